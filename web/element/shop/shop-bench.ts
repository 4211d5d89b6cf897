/** What the shop mode loads with a design, with zones, or at the first touch: the desk, and what its panel shows of a design. */
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../../editor/ui/icon.ts";
import type { ModeHost } from "../mode.ts";
import { badgeStyles } from "./badge-styles.ts";
import { HeatMap } from "./heat-map.ts";
import { ScanEye } from "./icons.ts";
import { type LayerActs, layerRows } from "./layer-rows.ts";
import { layerFindings, verdict } from "./print-badges.ts";
import { designStyles } from "./shop-design-styles.ts";
import { ShopDesk } from "./shop-desk.ts";
import type { ShopProduct } from "./shop-product.ts";

type Shown = TemplateResult | typeof nothing;

export class ShopBench {
  static readonly styles = [badgeStyles, designStyles];
  readonly desk: ShopDesk;
  readonly #host: ModeHost;
  readonly #heat: HeatMap;

  constructor(product: ShopProduct, host: ModeHost) {
    this.desk = new ShopDesk(product);
    this.#host = host;
    this.#heat = new HeatMap(
      this.desk,
      (maps) => this.desk.showMaps(maps),
      () => host.requestUpdate(),
    );
    this.desk.store.subscribe(() => host.requestUpdate());
  }

  get hasLayers(): boolean {
    return this.desk.store.state.design.layers.length > 0;
  }

  rows(acts: LayerActs): TemplateResult {
    return layerRows(this.desk, this.#host.words, acts);
  }

  findings(id: string): Shown {
    return layerFindings(this.desk, id, this.#host.words);
  }

  verdict(): Shown {
    return verdict(this.desk, this.#host.words);
  }

  heatSwitch(): Shown {
    if (this.desk.zones === null) return nothing;
    const { words, tell, dismiss } = this.#host;
    const label = this.#heat.shown ? words.heatMapOff : words.heatMap;
    const toggle = (): void => {
      dismiss();
      this.#heat.toggle().catch(tell);
    };
    return html`<button
      class="icon"
      part="button heat-button"
      data-act="heat"
      aria-pressed=${this.#heat.shown}
      aria-label=${label}
      title=${label}
      @click=${toggle}
    >
      ${icon(ScanEye)}
    </button>`;
  }

  legend(): Shown {
    if (!this.#heat.shown) return nothing;
    const { good, least } = this.#host.words.heatLegend;
    return html`<div class="own legend"><span class="good">${good}</span><span class="bad">${least}</span></div>`;
  }
}
