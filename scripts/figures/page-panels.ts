/** The panels that show the model: taken from the real page, without its handles and buttons. */
import type { EditorPage, TestFile } from "../../tests/e2e/support/editor-page.ts";
import { file } from "../../tests/e2e/support/test-files.ts";
import type { Design } from "../../web/editor/document/index.ts";

/** Steps of the mouse wheel towards the model for a close look. */
const CLOSE = 6;

export class PagePanels {
  readonly #editor: EditorPage;
  #near = false;

  constructor(editor: EditorPage) {
    this.#editor = editor;
  }

  /** A model as it is, from the front and whole. */
  async model(name: string, glb: Uint8Array): Promise<Uint8Array> {
    await this.#openModel(file(name, glb));
    return this.#shoot();
  }

  /** A design on the model that is open. */
  async design(design: Design): Promise<Uint8Array> {
    await this.#editor.openDesign([file("figure.json", JSON.stringify(design), "application/json")]);
    return this.#shoot();
  }

  /** From here on, the middle of the model near by; `height`: where that is, metres. */
  async comeClose(height: number): Promise<void> {
    const { page } = this.#editor;
    const at = await page.evaluate((y) => window.texelcast.project(0, y, 0.13), height);
    if (!at) throw new Error("The avatar is not in view.");
    await page.mouse.move(at.x, at.y);
    for (let step = 0; step < CLOSE; step++) await page.mouse.wheel(0, -120);
    this.#near = true;
  }

  async #openModel(model: TestFile): Promise<void> {
    await this.#editor.openModel([model]);
    await this.#editor.removeAllDecals();
    await this.#editor.page.keyboard.press("f");
    this.#near = false;
  }

  async #shoot(): Promise<Uint8Array> {
    const { page, stage } = this.#editor;
    await page.evaluate(() => window.texelcast.select(null));
    // Away from the model: a decal under the pointer is outlined.
    await page.mouse.move(4, 4);
    await this.#editor.idle();
    // The camera glides to its place and shadows fade in.
    await page.waitForTimeout(1800);
    const box = await stage.boundingBox();
    if (!box) throw new Error("The page has no stage.");
    // The buttons stand at the right edge. A figure seen whole is narrow.
    const width = this.#near ? Math.min(box.width - 110, box.height) : box.height * 0.62;
    return page.screenshot({ clip: { x: box.x + (box.width - width) / 2, y: box.y, width, height: box.height } });
  }
}
