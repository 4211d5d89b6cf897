/** The modes in which a layer is laid on those below it. */

/** W3C Compositing and Blending Level 1, in its order, and `erase` (destination out). */
export const BLEND_MODES = [
  "normal",
  "multiply",
  "screen",
  "overlay",
  "darken",
  "lighten",
  "color-dodge",
  "color-burn",
  "hard-light",
  "soft-light",
  "difference",
  "exclusion",
  "hue",
  "saturation",
  "color",
  "luminosity",
  "erase",
] as const;

export type BlendMode = (typeof BLEND_MODES)[number];
