/** What is on the product, the topmost first. */
import { html, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { Shapes, Trash2, Type } from "lucide";
import type { Design, DesignLayer } from "../../editor/document/design.ts";
import { walkLayers } from "../../editor/document/layer-tree.ts";
import { icon } from "../../editor/ui/icon.ts";
import { layerBadge } from "./print-badges.ts";
import type { ShopView } from "./shop-view.ts";

export function layerRows(view: ShopView, design: Design, selectedId: string | null): TemplateResult {
  const { words } = view.host;
  const layers = [...walkLayers(design, { masks: false, strokes: false })]
    .map(({ layer }) => layer)
    .filter(({ type }) => type !== "group")
    .reverse();
  return html`
    <ul class="list" role="list" aria-label=${words.list}>
      ${repeat(
        layers,
        ({ id }) => id,
        (layer) => row(view, design, layer, layer.id === selectedId),
      )}
    </ul>
  `;
}

function row(view: ShopView, design: Design, layer: DesignLayer, chosen: boolean): TemplateResult {
  const { words } = view.host;
  const kind = layer.type === "decal" || layer.type === "text" ? words.kinds[layer.type] : words.kinds.other;
  return html`
    <li class="row" part="row" data-layer=${layer.id} ?data-chosen=${chosen}>
      <button class="choose" aria-pressed=${chosen} @click=${() => view.select(layer)}>
        ${tile(view, design, layer)}
        <span class="name"><span>${layer.name}</span><span class="quiet">${kind}</span></span>
      </button>
      ${layerBadge(view.desk, layer.id, words)}
      <button
        class="icon"
        data-act="remove"
        aria-label=${words.remove(layer.name)}
        title=${words.remove(layer.name)}
        @click=${() => view.remove(layer)}
      >
        ${icon(Trash2)}
      </button>
    </li>
  `;
}

function tile(view: ShopView, design: Design, layer: DesignLayer): TemplateResult {
  const picture = layer.type === "decal" ? view.desk.library.get(design.assets[layer.asset]) : undefined;
  if (picture) return html`<span class="tile"><img src=${picture.url} alt="" /></span>`;
  return html`<span class="tile plain">${icon(layer.type === "text" ? Type : Shapes)}</span>`;
}
