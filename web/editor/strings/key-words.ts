/** The keys, and what fingers do, as the help lists them: by what they are for. */

export interface KeyGroup {
  readonly name: string;
  /** What is pressed, and what that does. */
  readonly keys: readonly (readonly [string, string])[];
}

/** The last group is about fingers. */
export const keyGroups: readonly KeyGroup[] = [
  {
    name: "Decal",
    keys: [
      ["Arrow keys", "Move the selected decals, also those of a selected group; with Shift ten times as far"],
      ["[ and ]", "Turn them; with Shift ten times as far"],
      ["− and +", "Make them smaller or larger"],
      ["A drag of one of several", "Drag all that are selected"],
      ["Alt and a drag", "Drag a copy"],
      ["Shift in a drag", "Straight across, or straight up or down"],
      ["Ctrl or ⌘ in a drag", "Without snapping into line"],
      ["Alt with a handle", "Size it about its middle"],
      ["Shift while it is turned by its handle", "In steps of 15°"],
      ["Alt S, Alt U, Alt V", "Align the decal to the surface, upright, to the view"],
      ["Alt M", "Slide it into the model’s middle"],
      ["Alt P", "Project it from the view"],
      ["Alt W", "Wrap it around"],
    ],
  },
  {
    name: "Layers",
    keys: [
      ["Ctrl or ⌘ A", "Select all layers"],
      ["Shift and a click on the model", "Select one more, or one less"],
      ["0 to 9", "Opacity of the selected layers in tenths; 0 is all"],
      ["Delete", "Delete the selected layers"],
      ["Ctrl or ⌘ D", "Duplicate them"],
      [
        "Ctrl or ⌘ C, X, V",
        "Copy, cut and paste them, also into another project; paste a picture as a decal, words as a text",
      ],
      ["Ctrl or ⌘ G", "Group them; with Shift, ungroup"],
      ["Ctrl or ⌘ E", "Merge with the layer below"],
      ["Ctrl or ⌘ [ and ]", "Move them down or up; with Shift to the end"],
      ["Alt ↑ and ↓ in the list", "Move them, also into and out of groups"],
      ["← and → in the list", "Close and open a group"],
      ["Space and F2 in the list", "Hide or show; rename"],
    ],
  },
  {
    name: "Tools",
    keys: [
      ["V, B, E, I, S, T", "Move, brush, eraser, colour picker, clone, text"],
      ["Alt or S, and a press", "With the clone tool: say where it copies from"],
      ["N, G, U", "Pencil, fill bucket, line and rectangle, in pixel mode"],
      ["[ and ] with a brush", "Make it smaller or larger; with Shift softer or harder"],
      ["0 to 9 with a brush", "Its opacity in tenths; 0 is all"],
      ["Shift and a press", "A straight line from where the stroke before ended"],
      ["Alt and a press", "Take the colour that lies there"],
      ["X and D", "Swap the two colours; black and white"],
      [
        "Arrow keys, then Space or Enter",
        "Move a brush, the text tool, the colour picker or the picking of parts over the surface in the focused view, and use it",
      ],
    ],
  },
  {
    name: "View",
    keys: [
      ["Arrow keys, − and + in the view", "Turn the model, nearer or further, while no decal is selected"],
      ["Right button and a drag", "Move the view"],
      ["Right button on the model", "What can be done with the decal there"],
      ["Double click on a text", "Type it"],
      ["Space and a drag", "Turn the model, or move the texture, while a tool paints"],
      ["F", "Show the whole model"],
      ["Alt 1, 2, 3", "The model alone, model and texture, the texture alone"],
      ["Shift U", "The texels’ own colours, without light, or lit again"],
      ["Shift W", "Wireframe"],
      ["Shift T", "Turntable"],
      ["Shift G", "Names of the texture’s parts"],
      ["Shift L", "Whether what is dragged snaps into line"],
      ["Shift P", "Play or pause the animation"],
    ],
  },
  {
    name: "Page",
    keys: [
      ["Ctrl or ⌘ Z", "Undo, also a stroke or drag under way; with Shift, or Ctrl Y, redo"],
      ["Ctrl or ⌘ S", "Save the design"],
      ["Ctrl or ⌘ O", "Open a model"],
      ["Escape", "End a drag and put the decal back, or deselect"],
      ["?", "This list"],
    ],
  },
  {
    name: "Touch",
    keys: [
      ["Two fingers", "Turn or move the view, and zoom"],
      ["Three fingers", "Tap: undo; swipe left or right: undo, redo"],
      ["Four fingers", "Tap: redo"],
      ["A layer that is held in the list", "Select one more, or one less"],
    ],
  },
];
