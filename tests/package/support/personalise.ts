/** A customer of a guide's page. */
import type { Frame, Page } from "@playwright/test";

type Editor = HTMLElement & {
  design: string;
  start(): Promise<void>;
  addDecal(source: string): Promise<string>;
  addText(text: string): Promise<string>;
  exportTexture(): Promise<{ sha256: string }>;
};
type Handed = CustomEvent<{ texture: { sha256: string } }>;

/** What is asked of the page's editor, where it is: in the page or in its frame. */
export const customer = (place: Page | Frame) => ({
  start: () =>
    place.evaluate(async () => {
      await customElements.whenDefined("texelcast-editor");
      await (document.querySelector("texelcast-editor") as Editor).start();
    }),
  addText: (text: string) =>
    place.evaluate(async (words) => {
      await (document.querySelector("texelcast-editor") as Editor).addText(words);
    }, text),
  /** The finished texture's hash with the design of that address. */
  textureOf: (design: string) =>
    place.evaluate(async (address) => {
      await customElements.whenDefined("texelcast-editor");
      const editor = document.querySelector("texelcast-editor") as Editor;
      editor.design = address;
      await editor.start();
      return (await editor.exportTexture()).sha256;
    }, design),
});

/** Puts a picture on the mug; gives the hash of what the customer then hands in, once that happened. */
export async function personalise(opened: Page, place: Page | Frame): Promise<() => string> {
  let approved = "";
  await opened.exposeFunction("noteApproved", (sha256: string) => {
    approved = sha256;
  });
  await customer(place).start();
  await place.evaluate(async () => {
    const { noteApproved } = globalThis as unknown as { noteApproved: (sha256: string) => void };
    const editor = document.querySelector("texelcast-editor") as Editor;
    editor.addEventListener("submit", (event) => noteApproved((event as unknown as Handed).detail.texture.sha256));
    await editor.addDecal("/logo.png");
  });
  return () => approved;
}
