/** What the shop mode loads when it is first seen or touched: the engine's client, the view, and their few panels. */
import type { TemplateResult } from "lit";
import type { Design } from "../../editor/document/design.ts";
import type { ModelSource } from "../../engine/engine-api.ts";
import { addPicture } from "../desk/placing.ts";
import { Texts } from "../desk/texts.ts";
import type { DecalSource, PlaceOptions, TextOptions } from "../element-api.ts";
import type { Mode, ModeHost } from "../mode.ts";
import { ShopDesk } from "./shop-desk.ts";
import { ShopView } from "./shop-view.ts";

/** Throws a TexelcastError without WebGL 2. */
export function openShop(host: ModeHost): Mode {
  return new ShopMode(host);
}

class ShopMode implements Mode {
  readonly styles = ShopView.styles;
  readonly desk: ShopDesk;
  readonly #texts: Texts;
  readonly #view: ShopView;

  constructor(host: ModeHost) {
    const { view, wasm, hooks } = host;
    this.desk = new ShopDesk({ view, wasm, hooks });
    this.#texts = new Texts(this.desk);
    this.#view = new ShopView(host, this.desk, this.#texts);
  }

  open(source: ModelSource, readDesign: () => Promise<Design>): Promise<void> {
    return this.desk.open(source, readDesign);
  }
  render(): TemplateResult {
    return this.#view.render();
  }
  addDecal(source: DecalSource, options?: PlaceOptions): Promise<string> {
    return addPicture(this.desk, source, options);
  }
  addText(text: string, options?: TextOptions): Promise<string> {
    return this.#texts.add(text, options);
  }
  configure(): void {
    this.desk.configure();
  }
  resize(): Promise<void> {
    return this.desk.resize();
  }
  idle(): Promise<void> {
    return this.desk.idle();
  }
  close(): void {
    this.desk.close();
  }
}
