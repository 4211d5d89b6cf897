/** What a desk asks of the element it works for. */
import type { TexelcastError } from "../../core/texelcast-error.ts";
import type { UploadLimits } from "../../engine/upload-check.ts";
import type { CameraLimits } from "../../viewer/model-camera.ts";
import type { BeforeAccept } from "../element-api.ts";
import type { Words } from "../words/words.ts";

export interface DeskSettings {
  readonly words: Words;
  /** glTF material index; null: the desk chooses. */
  readonly material: number | null;
  /** Texels of a texture's side; null: the model's own. */
  readonly size: number | null;
  readonly readonly: boolean;
  readonly maxDecals: number | null;
  readonly limits: Required<UploadLimits>;
  readonly camera: CameraLimits;
  readonly beforeAccept: BeforeAccept | null;
}

export interface DeskHooks {
  /** The element's settings as they are now. */
  settings(): DeskSettings;
  /** A step was recorded, undone or redone. */
  changed(): void;
  selected(id: string | null): void;
  /** Something failed that no call waits for. */
  failed(thrown: unknown): void;
  /** The browser has taken WebGL away and keeps it. */
  graphicsLost(): void;
  /** Something is wrong that is the page's to mend, and not its visitor's. */
  warn(error: TexelcastError): void;
  /** 0 to 1 of opening. */
  progress(share: number): void;
  announce(text: string): void;
}
