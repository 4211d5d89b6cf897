/** What three.js finds in a browser where it reads a model's pictures. */
import { vi } from "vitest";

export function letThreeReadPictures(): void {
  vi.stubGlobal("self", globalThis);
  vi.stubGlobal("createImageBitmap", async () => ({ width: 1, height: 1, close: () => undefined }));
}
