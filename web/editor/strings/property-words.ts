/** Words of the property panel for fills, gradients and parts. */
import { plural } from "./plural.ts";

export const gradientWords = {
  name: "Gradient",
  kind: "Fill",
  kinds: { color: "Colour", linear: "Linear", radial: "Radial" },
  stops: "Colours of the gradient",
  barHint: "Double-click adds a colour",
  stop: (place: number, count: number): string => `Colour ${place} of ${count}`,
  color: "Colour here",
  offset: "Offset",
  offsetLetter: "At",
  alpha: "Opacity of this colour",
  alphaLetter: "α",
  add: "Add a colour",
  remove: "Remove this colour",
  reverse: "Turn the gradient round",
  align: "Align to",
  alignTo: { x: "From side to side (X)", y: "From bottom to top (Y)", z: "From back to front (Z)" },
  wholeModel: "Model",
  from: "From",
  to: "To",
  center: "Centre",
  radius: "Radius",
  handle: (end: string): string =>
    `Gradient: ${end}. Drag it, or move it by the arrow keys; Alt takes it to the surface.`,
  moved: "move the gradient",
} as const;

export const maskWords = {
  title: "Mask",
  linked: "Moves with the layer",
  linkedHint: "The mask goes along when the layer is moved, turned or sized.",
  stays: "Drawn pixels and chosen parts lie in the texture, and stay there.",
  start: "Shows",
  startHint: "What the mask begins with. What is painted on it lies above.",
  starts: { all: "All", nothing: "Nothing", linear: "Linear", radial: "Radial" },
  stops: "From black, which hides, to white, which shows",
} as const;

export const partsWords = {
  title: "Painted parts",
  kinds: { all: "All", charts: "Charts", faces: "Faces" },
  picked: (kind: "charts" | "faces", count: number): string =>
    kind === "charts" ? plural(count, "chart", "charts") : plural(count, "face", "faces"),
  pick: "Pick…",
  done: "Done",
  tool: "Pick parts",
  oneMaterial: "Choose one material first",
  otherMaterial: "That part has another material than this fill.",
  step: "pick parts",
} as const;
