/** The editor page as a test drives it: the real page in a real browser, by mouse, keyboard and file dialogs. */
import { readFileSync } from "node:fs";
import { test as base, expect, type Locator, type Page } from "@playwright/test";
import type { TestHandleStats } from "../../../web/app/test-handle.ts";
import type { DecalLayer, Design } from "../../../web/editor/document/index.ts";

export { expect };

export interface TestFile {
  readonly name: string;
  readonly mimeType: string;
  readonly buffer: Buffer;
}

export interface Region {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface Point {
  readonly x: number;
  readonly y: number;
}

/** A page that fails its test when anything is written to the console as an error, or thrown and not caught. */
export const test = base.extend<{ editor: EditorPage }>({
  editor: async ({ page }, use) => {
    const faults: string[] = [];
    page.on("console", (message) => {
      if (message.type() === "error") faults.push(`console: ${message.text()}`);
    });
    page.on("pageerror", (error) => faults.push(`page: ${error.stack ?? error.message}`));
    await use(new EditorPage(page));
    expect(faults, "errors of the page").toEqual([]);
  },
});

export class EditorPage {
  readonly page: Page;
  readonly stage: Locator;
  /** The model's own view on the stage, beside the tools. */
  readonly view: Locator;
  readonly notices: Locator;

  constructor(page: Page) {
    this.page = page;
    this.stage = page.locator("tc-stage");
    this.view = page.locator(".tcv-root:not(.tcv-texture)");
    this.notices = page.locator("tc-notice-stack section");
  }

  /** Opens the page on its first demo; the first visit's hint is a test's own matter. */
  async open({ hint = false } = {}): Promise<void> {
    if (!hint) await this.page.addInitScript(() => localStorage.setItem("texelcast-hint-seen", "yes"));
    await this.page.goto("./");
    await this.#ready();
    await this.idle();
    // The engine is done before the first picture is: what stands on it, as handles do, has no place until then.
    await this.#drawn();
  }

  /** Opens the page on its first demo, whose lowest layer is chosen; returns that layer's id. */
  async openOnLowest(): Promise<string> {
    await this.open();
    const id = await this.lowestLayer();
    await this.select(id);
    return id;
  }

  async reload(): Promise<void> {
    await this.page.reload();
    await this.#ready();
  }

  /**
   * The places of parts of the page, all read in turn until no frame moves any of them: after a window's change
   * the panels follow it frames later.
   */
  async places<Parts extends readonly Locator[]>(...parts: Parts): Promise<{ [At in keyof Parts]: Region }> {
    const read = async () => {
      const places = await Promise.all(parts.map((part) => part.boundingBox()));
      const missing = places.indexOf(null);
      if (missing >= 0) throw new Error(`${parts[missing]} has no place on the page.`);
      return places as { [At in keyof Parts]: Region };
    };
    let places = await read();
    let before: string;
    do {
      before = JSON.stringify(places);
      await this.#drawn();
      places = await read();
    } while (JSON.stringify(places) !== before);
    return places;
  }

  /** Gives the page's window a size, and waits until the page has been drawn in it. */
  async resize(width: number, height: number): Promise<void> {
    await this.page.setViewportSize({ width, height });
    await this.page.waitForFunction(([across, down]) => innerWidth === across && innerHeight === down, [
      width,
      height,
    ] as const);
    await this.#drawn();
  }

  /** Waits two frames: what asks for a frame in the first has had it. */
  async #drawn(): Promise<void> {
    await this.page.evaluate(
      () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
    );
  }

  async #ready(): Promise<void> {
    await this.page.waitForFunction(() => window.texelcast !== undefined);
    await this.page.evaluate(() => window.texelcast.ready);
  }

  async idle(): Promise<void> {
    await this.page.evaluate(() => window.texelcast.idle());
  }

  hash(region?: Region): Promise<string> {
    return this.page.evaluate((part) => window.texelcast.hash(part), region);
  }

  /** The hash once everything is drawn. */
  async settledHash(): Promise<string> {
    await this.idle();
    return this.hash();
  }

  design(): Promise<Design> {
    return this.page.evaluate(() => window.texelcast.design());
  }

  async decal(id: string): Promise<DecalLayer> {
    const layer = (await this.design()).layers.find((candidate) => candidate.id === id);
    if (layer?.type !== "decal") throw new Error(`The design has no decal ${id}.`);
    return layer;
  }

  stats(): Promise<TestHandleStats> {
    return this.page.evaluate(() => window.texelcast.stats());
  }

  /** Width and height of the shown texture. */
  async textureSize(): Promise<{ width: number; height: number }> {
    const [, width, height] =
      /(\d+) × (\d+)/.exec((await this.page.locator("tc-status-line span").first().textContent()) ?? "") ?? [];
    return { width: Number(width), height: Number(height) };
  }

  async texels({ x, y, width, height }: Region): Promise<Buffer> {
    const base64 = await this.page.evaluate(
      async ([left, top, columns, rows]) => {
        const bytes = await window.texelcast.readTexels(
          left as number,
          top as number,
          columns as number,
          rows as number,
        );
        let binary = "";
        for (let start = 0; start < bytes.length; start += 0x8000) {
          binary += String.fromCharCode(...bytes.subarray(start, start + 0x8000));
        }
        return btoa(binary);
      },
      [x, y, width, height],
    );
    return Buffer.from(base64, "base64");
  }

  /**
   * Does what a quick hand does: by the page's clock all of it happens at one moment, however long a slow machine takes for
   * it, so that steps which become one when they follow each other soon do.
   */
  async quickly(act: () => Promise<void>): Promise<void> {
    await this.page.evaluate(() => {
      const now = performance.now();
      performance.now = () => now;
    });
    await act();
    await this.page.evaluate(() => Reflect.deleteProperty(performance, "now"));
  }

  /** Chooses an item of the projects' menu. */
  async chooseOfProjects(item: string): Promise<void> {
    await this.page.locator("tc-top-bar .projects button").first().click();
    await this.page.getByRole("menuitem", { name: item }).click();
  }

  row(name: string): Locator {
    return this.page.locator("tc-layer-list .row").filter({ has: this.page.getByText(name, { exact: true }) });
  }

  action(name: "up" | "down" | "duplicate" | "delete" | "group" | "add-mask"): Locator {
    return this.page.locator(`tc-layer-list [data-action=${name}]`);
  }

  field(name: string): Locator {
    return this.page.locator(`tc-number[data-field="${name}"] input`);
  }

  async setField(name: string, value: string): Promise<void> {
    await this.field(name).fill(value);
    await this.field(name).press("Enter");
  }

  select(id: string): Promise<void> {
    return this.page.evaluate((layer) => window.texelcast.select(layer), id);
  }

  /** The id of the design's lowest layer: of a demo, its decal. */
  async lowestLayer(): Promise<string> {
    const [layer] = (await this.design()).layers;
    if (!layer) throw new Error("The design has no layer.");
    return layer.id;
  }

  async selectedName(): Promise<string> {
    return ((await this.page.locator("tc-layer-list [aria-current=true] .name").textContent()) ?? "").trim();
  }

  /** Adds a layer by the menu of the layer list. */
  async addLayer(name: string | RegExp): Promise<void> {
    await this.page.locator("tc-layer-list tc-menu.add button").first().click();
    await this.page.getByRole("menuitem", { name }).click();
  }

  /** Adds a demo decal by its button; it lands in the middle of the view. Returns its layer's id. */
  async addDemoDecal(id: string): Promise<string> {
    const count = (await this.design()).layers.length;
    await this.page.locator(`tc-decal-palette [data-decal=${id}]`).click();
    await expect.poll(async () => (await this.design()).layers.length).toBe(count + 1);
    await this.idle();
    return (await this.design()).layers.at(-1)?.id as string;
  }

  async removeAllDecals(): Promise<void> {
    for (const { id } of (await this.design()).layers) {
      await this.select(id);
      await this.action("delete").click();
    }
    await this.idle();
  }

  /** Where the middle of a decal stands on the page. A view that was just given another size has it from the next frame on. */
  async pointOf(id: string): Promise<Point> {
    await this.#drawn();
    const { projector } = await this.decal(id);
    if (projector.kind !== "planar") throw new Error("Only planar decals have a place.");
    const [x, y, z] = projector.position;
    const point = await this.page.evaluate((at) => window.texelcast.project(...at) ?? null, [x, y, z] as const);
    if (!point) throw new Error("The decal is not in view.");
    return point;
  }

  /** Drags with the mouse in steps; `onStep` runs between two moves, while the button is down. */
  async drag(from: Point, to: Point, steps: number, onStep: () => Promise<void> = async () => {}): Promise<void> {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    for (let step = 1; step <= steps; step += 1) {
      const share = step / steps;
      await mouse.move(from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share);
      await onStep();
    }
    await mouse.up();
    await this.idle();
  }

  /** The middle of one of the gizmo's handles. */
  async handle(name: string): Promise<Point> {
    await this.#drawn();
    const box = await this.view.locator(`[data-handle="${name}"] .tcv-mark`).boundingBox();
    if (!box) throw new Error(`The gizmo shows no handle ${name}.`);
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  /** Chooses files in the dialog that `open` brings up. */
  async choose(open: () => Promise<void>, files: readonly TestFile[]): Promise<void> {
    const [chooser] = await Promise.all([this.page.waitForEvent("filechooser"), open()]);
    await chooser.setFiles([...files]);
    await this.idle();
  }

  async openModel(files: readonly TestFile[]): Promise<void> {
    await this.choose(async () => {
      await this.page.locator("tc-top-bar .models button").first().click();
      await this.page.getByRole("menuitem", { name: "Open model…" }).click();
    }, files);
  }

  /** Begins anew with one of the templates for skins. */
  async openTemplate(id: string): Promise<void> {
    await this.page.locator("tc-top-bar .models button").first().click();
    await this.page.getByRole("menuitem", { name: "New from template…" }).click();
    await this.page.locator(`tc-template-dialog [data-template=${id}]`).click();
    await this.idle();
  }

  async middleOfStage(): Promise<Point> {
    const box = await this.stage.boundingBox();
    if (!box) throw new Error("The page shows no model.");
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  async openDesign(files: readonly TestFile[]): Promise<void> {
    await this.choose(() => this.page.locator("#open-design").click(), files);
  }

  /** Drops files at a point of the page, as a file manager does. */
  async drop(files: readonly TestFile[], at: Point): Promise<void> {
    const packed = files.map(({ name, mimeType, buffer }) => ({ name, mimeType, data: buffer.toString("base64") }));
    await this.page.evaluate(
      ({ packed, at }) => {
        const dataTransfer = new DataTransfer();
        for (const { name, mimeType, data } of packed) {
          const bytes = Uint8Array.from(atob(data), (character) => character.charCodeAt(0));
          dataTransfer.items.add(new File([bytes], name, { type: mimeType }));
        }
        const target = document.elementFromPoint(at.x, at.y);
        const init = { dataTransfer, clientX: at.x, clientY: at.y, bubbles: true, cancelable: true, composed: true };
        for (const type of ["dragenter", "dragover", "drop"]) target?.dispatchEvent(new DragEvent(type, init));
      },
      { packed, at },
    );
    await this.idle();
  }

  async saved(start: () => Promise<void>): Promise<{ name: string; bytes: Buffer }> {
    const [download] = await Promise.all([this.page.waitForEvent("download"), start()]);
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  }

  saveDesign(): Promise<{ name: string; bytes: Buffer }> {
    return this.saved(() => this.page.locator("#save-design").click());
  }

  /** The project as one file, with its model. */
  savedProject(): Promise<{ name: string; bytes: Buffer }> {
    return this.saved(async () => {
      await this.chooseOfProjects("Save as one file");
    });
  }

  exported(item: "Texture as PNG" | "Model as GLB" | "Model as USDZ"): Promise<{ name: string; bytes: Buffer }> {
    return this.saved(async () => {
      await this.page.getByRole("button", { name: "Export", exact: true }).click();
      await this.page.getByRole("menuitem", { name: item }).click();
    });
  }
}
