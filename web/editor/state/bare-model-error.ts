/** A model that was refused, and takes paint once it is unwrapped. */
import { TexelcastError, type TexelcastErrorDetails } from "../../core/texelcast-error.ts";
import type { ModelRef } from "./design-state.ts";

export interface BareModel {
  readonly ref: ModelRef;
  /** Its materials without texture coordinates. */
  readonly materials: readonly number[];
}

/** "no-uvs", with the model that it is about. */
export class BareModelError extends TexelcastError {
  readonly model: BareModel;

  constructor(model: BareModel, message: string, details: TexelcastErrorDetails) {
    super("no-uvs", message, details);
    this.model = model;
  }
}
