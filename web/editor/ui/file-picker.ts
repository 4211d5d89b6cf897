/** Asks for files by the browser's own dialog. */
import { type CollectedFile, collectInput } from "../files/file-collection.ts";

export interface PickOptions {
  /** As the `accept` attribute of a file input. */
  readonly accept: string;
  readonly multiple?: boolean;
  readonly folder?: boolean;
}

/** Apart from the others (accepted-files.ts): a shop's customers need no more. */
export const PICTURES = ".png,.jpg,.jpeg,.webp,.avif,.svg,image/png,image/jpeg,image/webp,image/avif,image/svg+xml";

/** Calls `take` when the user has chosen something. Must be called from a user's gesture. */
export function pickFiles(
  { accept, multiple = true, folder = false }: PickOptions,
  take: (files: CollectedFile[]) => void,
): void {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = folder ? "" : accept;
  input.multiple = multiple;
  input.webkitdirectory = folder;
  input.addEventListener("change", () => take(collectInput(input.files)));
  input.click();
}
