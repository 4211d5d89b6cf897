/** What is on the product, the topmost first. */

import { html, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { type DesignLayer, isPlaced } from "../../editor/document/design.ts";
import { walkLayers } from "../../editor/document/layer-tree.ts";
import { icon } from "../../editor/ui/icon.ts";
import type { Desk } from "../desk/desk.ts";
import type { Words } from "../words/words.ts";
import { Shapes, Trash2, Type } from "./icons.ts";
import { layerBadge } from "./print-badges.ts";

export interface LayerActs {
  readonly select: (layer: DesignLayer) => void;
  readonly remove: (layer: DesignLayer) => void;
}

export function layerRows(desk: Desk, words: Words, acts: LayerActs): TemplateResult {
  const { design, selectedId } = desk.store.state;
  const layers = [...walkLayers(design, { masks: false, strokes: false })]
    .map(({ layer }) => layer)
    .filter(({ type }) => type !== "group")
    .reverse();
  return html`
    <ul class="list" role="list" aria-label=${words.list}>
      ${repeat(
        layers,
        ({ id }) => id,
        (layer) => row(desk, words, acts, layer, layer.id === selectedId),
      )}
    </ul>
  `;
}

function row(desk: Desk, words: Words, acts: LayerActs, layer: DesignLayer, chosen: boolean): TemplateResult {
  const kind = isPlaced(layer) ? words.kinds[layer.type] : words.kinds.other;
  return html`
    <li class="row" part="row" data-layer=${layer.id} ?data-chosen=${chosen}>
      <button class="choose" aria-pressed=${chosen} @click=${() => acts.select(layer)}>
        ${tile(desk, layer)}
        <span class="name"><span dir="auto">${layer.name}</span><span class="quiet">${kind}</span></span>
      </button>
      ${layerBadge(desk, layer.id, words)}
      <button
        class="icon"
        data-act="remove"
        aria-label=${words.remove(layer.name)}
        title=${words.remove(layer.name)}
        @click=${() => acts.remove(layer)}
      >
        ${icon(Trash2)}
      </button>
    </li>
  `;
}

function tile(desk: Desk, layer: DesignLayer): TemplateResult {
  const picture = layer.type === "decal" ? desk.library.get(desk.design.assets[layer.asset]) : undefined;
  if (picture) return html`<span class="tile"><img src=${picture.url} alt="" /></span>`;
  return html`<span class="tile plain">${icon(layer.type === "text" ? Type : Shapes)}</span>`;
}
