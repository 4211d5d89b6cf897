/** The element's own words, apart from the whole editor's: a shop's page loads these alone. */
import { type ErrorWords, ownWords } from "../../editor/strings/error-words.ts";
import type { PrintFinding } from "../../engine/print-report.ts";
import type { EditorWording } from "./wording.ts";

export type WordsLanguage = "en" | "de";

export const english = {
  language: "en" as WordsLanguage,
  lang: "en",
  /** What the engine or the reader of a file reports. */
  told: ownWords,
  /** What the printer would say; `grave`: it must not be printed so. */
  finding: ({ message, hint }: PrintFinding, _grave: boolean): ErrorWords => ({ message, hint }),

  view: "Product in 3D. Drag to turn it. Arrow keys move what is chosen, [ and ] turn it, + and - size it.",
  start: "Personalise",
  loading: "Loading the product",
  failed: "The product could not be shown",
  retry: "Try again",
  close: "Close",

  panel: "Your design",
  addPicture: "Add picture",
  addText: "Add text",
  sampleText: "Your text",
  drop: "Drop the picture where it should go",
  emptyTitle: "Make it yours",
  emptyBody: "Add a picture or a text, then drag it where it should go.",
  full: (most: number): string => `This product takes ${most} at most. Delete one to add another.`,
  list: "On the product, the topmost first",
  kinds: { decal: "Picture", text: "Text", other: "Drawn" },
  remove: (name: string): string => `Delete ${name}`,

  undo: "Undo",
  redo: "Redo",
  fit: "Show the whole product",
  heatMap: "Show print quality",
  heatMapOff: "Show the product",
  heatLegend: { good: "Sharp", least: "Too coarse" },

  words: "Words",
  font: "Font",
  color: "Colour",
  width: "Width",
  height: "Height",
  turn: "Turn",
  depth: "Depth",
  centimetres: "cm",
  degrees: "°",

  submit: "Done",
  submitting: "Preparing…",
  submitted: "Your design is ready.",
  printGood: "Prints well",
  printIssues: (count: number): string => (count === 1 ? "1 thing to look at" : `${count} things to look at`),
  dpi: (value: number): string => `${value} dpi`,
  area: (value: string): string => `${value} cm²`,

  announce: {
    added: (name: string): string => `${name} added`,
    removed: (name: string): string => `${name} deleted`,
    undone: "Undone",
    redone: "Done again",
    selected: (name: string): string => `${name} chosen`,
  },
  steps: {
    add: "add picture",
    addText: "add text",
    remove: "delete",
    change: "change",
    design: "open design",
  },

  errors: {
    noModel: "There is no product to show.",
    noModelHint: "Set src to the address of a .glb or .gltf.",
    unreachable: (address: string): string => `${address} could not be fetched.`,
    unreachableHint: "Check the address, and that this page may read it.",
    notReady: "The product is not shown yet.",
    readonly: "This design cannot be changed.",
    tooMany: (most: number): string => `This product takes ${most} pictures and texts at most.`,
    tooManyHint: "Delete one to add another.",
    refused: (name: string): string => `“${name}” was not accepted.`,
    refusedHint: "Choose another picture.",
    notOpenable: "This product cannot be painted.",
    emptyText: "There are no words.",
    zoneMaterial: (zone: string, material: number): string =>
      `The model has no material ${material} for the zone “${zone}”.`,
    zoneMaterialHint: (materials: string): string => `Give it one of the model's: ${materials}.`,
    graphicsLost: "The browser has taken the graphics away. Nothing of your design is lost.",
    graphicsLostHint: "Try again, or restart the browser.",
    badOption: (name: string): string => `${name} is not what it must be.`,
    unexpected: "Something went wrong. Try again, or reload the page.",
  },
};

/** `own`: what a shop's own words have beside (`worded`). */
export type Words = typeof english & {
  readonly own?: Pick<EditorWording, "nowhere" | "noFont" | "noGraphics" | "ways">;
};
