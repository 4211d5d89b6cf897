/** A model that was refused, and takes paint once it is unwrapped. */
import { TexelcastError, type TexelcastErrorDetails } from "../../core/texelcast-error.ts";
import type { MaterialInfo } from "../../engine/engine-api.ts";
import type { ModelRef } from "./design-state.ts";

/** Whether a material takes no paint for want of texture coordinates, or because those that it has are broken. */
export const takesPaintUnwrapped = ({ refusal }: Pick<MaterialInfo, "refusal">): boolean =>
  refusal?.code === "no-uvs" || refusal?.code === "bad-uvs";

export interface BareModel {
  readonly ref: ModelRef;
  /** Its materials without texture coordinates that a texture could be painted by. */
  readonly materials: readonly number[];
}

/** "no-uvs" or "bad-uvs", with the model that it is about. */
export class BareModelError extends TexelcastError {
  readonly model: BareModel;

  constructor(code: string, model: BareModel, message: string, details: TexelcastErrorDetails) {
    super(code, message, details);
    this.model = model;
  }
}
