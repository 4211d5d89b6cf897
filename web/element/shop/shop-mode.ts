/** What the shop mode loads when it is first seen or touched: the engine's client, the still view, and the frame of its panel. */
import type { TemplateResult } from "lit";
import type { Design } from "../../editor/document/design.ts";
import type { MaterialInfo, ModelSource } from "../../engine/engine-api.ts";
import type { ModelView } from "../../viewer/viewer-api.ts";
import type { Desk } from "../desk/desk.ts";
import type { DecalSource, PlaceOptions, TextOptions } from "../element-api.ts";
import type { Mode, ModeHost, ReadDesign } from "../mode.ts";
import { ShopProduct } from "./shop-product.ts";
import { ShopView } from "./shop-view.ts";

/** Throws a TexelcastError without WebGL 2. */
export function openMode(host: ModeHost): Mode {
  return new ShopMode(host);
}

/** Of opening, where the model is read. */
const LOADED = 0.35;

class ShopMode implements Mode {
  readonly styles = ShopView.styles;
  readonly #product: ShopProduct;
  readonly #view: ShopView;

  constructor(host: ModeHost) {
    this.#product = new ShopProduct(host);
    this.#view = new ShopView(host, this.#product);
  }

  get viewer(): ModelView {
    return this.#product.viewer;
  }
  get desk(): Desk | null {
    return this.#view.bench?.desk ?? null;
  }
  get materials(): readonly MaterialInfo[] {
    return this.#product.open?.info.materials ?? [];
  }

  async takeDesk(): Promise<Desk> {
    return (await this.#view.takeBench()).desk;
  }

  async open(source: ModelSource, readDesign: ReadDesign | null): Promise<void> {
    const product = this.#product;
    const { progress } = product.hooks;
    const info = await product.engine.loadModel(source);
    // Without a design there is nothing to be worked on yet, and no desk.
    const begun = readDesign && (await this.#layOut(readDesign));
    progress(LOADED);
    const open = await product.show(source, info);
    const materials = [...new Set([open.material, ...(begun?.materials ?? [])])].filter((each) =>
      product.canPaint(each),
    );
    for (const [index, material] of materials.entries()) {
      const share = (part: number): number => LOADED + ((1 - LOADED) * (index + part)) / materials.length;
      await product.openTarget(material, (part) => progress(share(part)));
    }
    // There is a desk where the product comes with zones, too.
    this.#view.bench?.desk.begin(open, begun?.design);
    this.#view.opened();
    this.configure();
    // What could not be drawn was told, and does not keep the product from being shown; an engine that ended does.
    await product.engine.idle().catch(() => product.engine.stats());
  }

  /** Gives the engine a design before the model is shown, so that it is never shown without. */
  async #layOut(readDesign: ReadDesign) {
    const { usedMaterials } = await import("../../editor/state/design-edits.ts");
    const { desk } = await this.#view.takeBench();
    const design: Design = await readDesign(desk.library);
    desk.session.send(design);
    return { design, materials: usedMaterials(design) };
  }

  render(): TemplateResult {
    return this.#view.render();
  }
  async addDecal(source: DecalSource, options?: PlaceOptions): Promise<string> {
    return await (await this.#view.takeTools()).addPicture(source, options);
  }
  async addText(text: string, options?: TextOptions): Promise<string> {
    return await (await this.#view.takeTools()).texts.add(text, options);
  }
  configure(): void {
    this.viewer.setCamera(null, this.#product.hooks.settings().camera);
    this.#view.bench?.desk.configure();
  }
  resize(): Promise<void> {
    return this.#product.resize();
  }
  async idle(): Promise<void> {
    await this.desk?.settled();
    await this.#product.idle();
  }
  close(): void {
    this.#view.close();
    if (this.#view.bench) this.#view.bench.desk.close();
    else this.#product.close();
  }
}
