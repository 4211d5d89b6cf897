/** What the gizmo does with projectors that are no boxes: slides, labels and stamps. Apart from it, since few designs have any. */
import { nudged, pictureDrag } from "./projector-drag.ts";
import { thrownHandleDrag } from "./projector-handles.ts";
import { pictureBox, throwOutline } from "./projector-outline.ts";
import { drawThrown } from "./projector-picture.ts";

export const THROWN = {
  outline: throwOutline,
  draw: drawThrown,
  drag: pictureDrag,
  handleDrag: thrownHandleDrag,
  nudged,
  box: pictureBox,
} as const;

export type ThrownKinds = typeof THROWN;
