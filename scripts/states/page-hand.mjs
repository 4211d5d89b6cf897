/** A hand on the page: what a chapter does to it, whatever the screen and the language. */

/** Milliseconds that menus take to open and shadows to fade in. */
const CALM = 220;

export class PageHand {
  /**
   * @param {import("@playwright/test").Page} page
   * @param {import("./looks.mjs").Look} look
   */
  constructor(page, look) {
    this.page = page;
    this.look = look;
    this.phone = look.viewport.width <= 720;
  }

  async ready() {
    await this.page.waitForFunction(() => "texelcast" in window);
    await this.page.evaluate(() => window.texelcast.ready);
    await this.settle();
  }

  async settle() {
    await this.page.evaluate(() => window.texelcast.idle());
    await this.page.waitForTimeout(CALM);
  }

  /** The newest frame is on the screen: drawn by software, it may be late. */
  async drawn() {
    await this.page.evaluate(async () => {
      for (let frame = 0; frame < 3; frame += 1) await new Promise((drawn) => requestAnimationFrame(drawn));
    });
    await this.page.waitForTimeout(CALM);
  }

  /** Of the view of the model, or of the texture. */
  async middle(place = "tc-stage") {
    const box = await this.page.locator(place).first().boundingBox();
    if (!box) throw new Error(`${place} is not to be seen.`);
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  /**
   * A panel of the side, which a phone has in its sheet.
   *
   * @param {"layers" | "properties" | "history" | "target" | "texture"} panel
   */
  async panel(panel) {
    if (this.phone) {
      const tab = this.page.locator(`#sheet-${panel}`);
      if ((await tab.getAttribute("aria-expanded")) !== "true") await tab.click();
    } else if (panel === "layers" || panel === "history") {
      await this.page.locator(`tc-side-panel #tab-${panel}`).click();
    }
  }

  /** @param {string} selector of what is scrolled into its panel's sight */
  async reveal(selector) {
    const element = this.page.locator(selector).first();
    await element.evaluate((found) => found.scrollIntoView({ block: "center" }));
    return element;
  }

  /** @param {string} selector */
  click(selector) {
    return this.page.locator(selector).first().click();
  }

  /**
   * @param {string} menu
   * @param {number} [entry] from 0; without one the menu stays open
   */
  async menu(menu, entry) {
    await this.click(`${menu} button`);
    if (entry !== undefined) await this.page.locator(`${menu} [role^=menuitem]`).nth(entry).click();
  }

  /** @param {string} keys */
  press(keys) {
    return this.page.keyboard.press(keys);
  }

  /** @param {string} tool */
  tool(tool) {
    return this.click(`#tool-${tool}`);
  }

  /** The design's layers, bottom to top. */
  layers() {
    return this.page.evaluate(() => window.texelcast.design().layers);
  }

  /** @param {string} decal of the demo's */
  async addDecal(decal) {
    await this.panel("layers");
    await this.page.locator(`tc-decal-palette [data-decal=${decal}]`).click();
    await this.settle();
  }

  /** @param {number} index from the bottom */
  async select(index) {
    await this.page.evaluate(
      (at) => window.texelcast.select(window.texelcast.design().layers.at(at)?.id ?? null),
      index,
    );
    await this.settle();
  }

  /**
   * Presses and moves; the button stays down.
   *
   * @param {{ x: number, y: number }} from
   * @param {readonly (readonly [number, number])[]} moves from there
   */
  async hold(from, moves) {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    for (const [x, y] of moves) await mouse.move(from.x + x, from.y + y, { steps: 5 });
  }

  /**
   * @param {{ x: number, y: number }} from
   * @param {readonly (readonly [number, number])[]} moves
   */
  async drag(from, moves) {
    await this.hold(from, moves);
    await this.page.mouse.up();
    await this.settle();
  }

  /**
   * Drops a file on the page, as a file manager does.
   *
   * @param {string} name
   * @param {string} text
   */
  async drop(name, text) {
    const at = await this.middle("[role=main]");
    await this.page.evaluate(
      ({ name, text, at }) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([text], name));
        const target = document.elementFromPoint(at.x, at.y);
        const init = { dataTransfer, clientX: at.x, clientY: at.y, bubbles: true, cancelable: true, composed: true };
        for (const type of ["dragenter", "dragover", "drop"]) target?.dispatchEvent(new DragEvent(type, init));
      },
      { name, text, at },
    );
    await this.settle();
  }

  /** @param {string} id */
  async template(id) {
    await this.menu("tc-top-bar .projects", 1);
    await this.click(`tc-template-dialog [data-template=${id}]`);
    await this.settle();
    await this.dismissNotices();
  }

  async dismissNotices() {
    const dismiss = this.page.locator("tc-notice-stack .dismiss");
    while ((await dismiss.count()) > 0) await dismiss.first().click();
  }
}
