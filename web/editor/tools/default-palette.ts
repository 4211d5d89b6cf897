/** The palette that a new page begins with: greys, then hues in four steps from deep to pale, and skin and hair tones. */
import type { Palette } from "./gimp-palette.ts";

export const DEFAULT_PALETTE: Palette = {
  name: "",
  colors: [
    ...["#15171b", "#3a3f47", "#646b76", "#949ba6", "#c5cad1", "#eceef1", "#ffffff", "#f3ead7"],
    ...["#5c1a1b", "#a32a2a", "#d94f45", "#f2978b", "#5e3010", "#a85a1c", "#e38b32", "#f6c283"],
    ...["#5f4a0c", "#a8861a", "#e6c233", "#f7e48d", "#1f4a22", "#367a37", "#63b04f", "#a9d98a"],
    ...["#0f4644", "#1d7a75", "#3fb3a6", "#93dccd", "#16345f", "#2659a0", "#4a8fdc", "#9cc5f2"],
    ...["#2c2266", "#4d3ea6", "#7f72dc", "#b9b1f2", "#54195c", "#8e3396", "#c767c4", "#e9aee2"],
    ...["#3b2219", "#6b4430", "#9c6b4a", "#c6926b", "#e2b58e", "#f2d3b3", "#2a1c12", "#d9b25c"],
  ],
};
