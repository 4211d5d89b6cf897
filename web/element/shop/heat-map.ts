/** The print's quality on the product itself, in place of its picture; it follows the design while it is shown. */
import type { Design } from "../../editor/document/design.ts";
import type { MapPicture } from "../../viewer/viewer-api.ts";
import type { Desk } from "../desk/desk.ts";

/** Shows maps in place of the textures, by material; null shows the textures again. */
export type ShowMaps = (maps: ReadonlyMap<number, MapPicture> | null) => Promise<void>;

export class HeatMap {
  readonly #desk: Desk;
  readonly #show: ShowMaps;
  readonly #changed: () => void;
  #shown = false;
  /** What the newest map is of. */
  #drawn: Design | null = null;

  constructor(desk: Desk, show: ShowMaps, changed: () => void) {
    this.#desk = desk;
    this.#show = show;
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
      await this.#show(null);
    }
  }

  async #draw(): Promise<void> {
    const desk = this.#desk;
    const { design } = desk;
    this.#drawn = design;
    const { heatMaps } = await import("../desk/prints.ts");
    const maps = await heatMaps({ desk, idle: () => desk.engine.idle() });
    if (this.#shown && this.#drawn === design && !desk.closed) await this.#show(maps);
  }
}
