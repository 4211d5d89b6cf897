/** The print's quality on the product itself, in place of its picture; it follows the design while it is shown. */
import type { Design } from "../../editor/document/design.ts";
import type { Desk } from "../desk/desk.ts";

export class HeatMap {
  readonly #desk: Desk;
  readonly #changed: () => void;
  #shown = false;
  /** What the newest map is of. */
  #drawn: Design | null = null;

  constructor(desk: Desk, changed: () => void) {
    this.#desk = desk;
    this.#changed = changed;
    desk.store.subscribe(() => {
      if (this.#shown && desk.design !== this.#drawn && !desk.closed) void this.#draw().catch(desk.hooks.failed);
    });
  }

  get shown(): boolean {
    return this.#shown;
  }

  async toggle(): Promise<void> {
    this.#shown = !this.#shown;
    this.#changed();
    if (this.#shown) await this.#draw();
    else {
      this.#drawn = null;
      this.#desk.hands?.setMapPictures(null);
    }
  }

  async #draw(): Promise<void> {
    const desk = this.#desk;
    const { design } = desk;
    this.#drawn = design;
    const { heatMaps } = await import("../desk/prints.ts");
    const [viewer, maps] = await Promise.all([desk.takeHands(), heatMaps({ desk, idle: () => desk.engine.idle() })]);
    if (this.#shown && this.#drawn === design && !desk.closed) viewer.setMapPictures(maps);
  }
}
