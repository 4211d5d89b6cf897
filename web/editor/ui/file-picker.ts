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

/** Of the dialog that was opened last, until it has been answered. */
let asked: HTMLInputElement | undefined;

/** Calls `take` when the user has chosen something. Must be called from a user's gesture. */
export function pickFiles(
  { accept, multiple = true, folder = false }: PickOptions,
  take: (files: CollectedFile[]) => void,
): void {
  asked?.remove();
  const input = document.createElement("input");
  asked = input;
  input.type = "file";
  input.accept = folder || (accept !== PICTURES && greysOutOwnEndings(navigator)) ? "" : accept;
  input.multiple = multiple;
  input.webkitdirectory = folder;
  input.hidden = true;
  input.addEventListener("change", () => {
    input.remove();
    take(collectInput(input.files));
  });
  input.addEventListener("cancel", () => input.remove());
  // Safari on iPhones and iPads tells an input that the page does not hold neither of the two.
  document.body.append(input);
  input.click();
}

/** Dialogs of telephones and tablets go by types that their system has heard of: of .glb most have not, and nobody could choose one. */
export const greysOutOwnEndings = ({
  userAgent,
  platform,
  maxTouchPoints,
}: Pick<Navigator, "userAgent" | "platform" | "maxTouchPoints">): boolean =>
  /Android|iPhone|iPad|iPod/.test(userAgent) || (platform === "MacIntel" && maxTouchPoints > 1); // an iPad that asks for pages as a Mac

/** Whether folders can be asked for. */
export const picksFolders = (): boolean => "webkitdirectory" in HTMLInputElement.prototype;
