/** A customer of a guide's page. */
import type { Frame, Page } from "@playwright/test";

/** Puts a picture on the mug; gives the hash of what the customer then hands in, once that happened. */
export async function personalise(opened: Page, place: Page | Frame): Promise<() => string> {
  let approved = "";
  await opened.exposeFunction("noteApproved", (sha256: string) => {
    approved = sha256;
  });
  await place.evaluate(async () => {
    type Editor = HTMLElement & { start(): Promise<void>; addDecal(source: string): Promise<string> };
    type Handed = CustomEvent<{ texture: { sha256: string } }>;
    const { noteApproved } = globalThis as unknown as { noteApproved: (sha256: string) => void };
    await customElements.whenDefined("texelcast-editor");
    const editor = document.querySelector("texelcast-editor") as Editor;
    editor.addEventListener("submit", (event) => noteApproved((event as unknown as Handed).detail.texture.sha256));
    await editor.start();
    await editor.addDecal("/logo.png");
  });
  return () => approved;
}
