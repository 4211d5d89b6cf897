/** A small picture of a layer, over a checkerboard that shows where it is transparent; and one of its mask. */
import { css, html, nothing, svg, type TemplateResult } from "lit";
import { Brush, Folder, FolderOpen } from "lucide";
import type { Design, DesignLayer, FillLayer, Gradient, Mask, PaintLayer, StrokeLayer } from "../document/index.ts";
import type { AssetLibrary } from "../state/asset-library.ts";
import { familyOfText } from "./font-previews.ts";
import { icon } from "./icon.ts";
import { type MiniatureSource, miniature, miniatureStyles } from "./miniature.ts";

export interface ThumbnailSource extends MiniatureSource {
  readonly library: AssetLibrary;
  readonly design: Design;
}

export const thumbnailStyles = css`
  ${miniatureStyles}
  .thumbnail {
    position: relative;
    flex: none;
    display: grid;
    place-items: center;
    width: var(--thumbnail, 32px);
    height: var(--thumbnail, 32px);
    overflow: hidden;
    border-radius: 5px;
    background: repeating-conic-gradient(var(--tile-checker) 0 25%, var(--tile) 0 50%) 0 0 / 10px 10px;
  }
  .thumbnail::after {
    content: "";
    position: absolute;
    inset: 0;
    border-radius: inherit;
    box-shadow: inset 0 0 0 1px var(--line);
  }
  .thumbnail.plain {
    background: none;
    color: var(--text-quiet);
  }
  .thumbnail.plain::after {
    content: none;
  }
  .thumbnail.words {
    background: var(--tile);
    font-size: 0.6875rem;
    font-weight: 650;
    white-space: nowrap;
  }
  .thumbnail .ink {
    position: absolute;
    inset: 0;
    forced-color-adjust: none;
  }
  .thumbnail .mark {
    position: relative;
    display: grid;
    place-items: center;
    width: 62%;
    height: 62%;
    border-radius: 50%;
    background: var(--surface-high);
    color: var(--text);
  }
  .thumbnail .mark tc-icon {
    transform: scale(0.7);
  }
  .thumbnail img {
    width: 100%;
    height: 100%;
    object-fit: contain;
  }
  .mask-picture {
    position: relative;
    display: block;
    width: 100%;
    height: 100%;
    overflow: hidden;
    border-radius: 4px;
  }
  .mask-picture svg {
    display: block;
    width: 100%;
    height: 100%;
  }
`;

/** Colours of a paint layer that its picture shows. */
const COLOURS_SHOWN = 4;
/** Letters of a text that fit. */
const LETTERS_SHOWN = 3;

/** @param open Of a group: its layers are shown. */
export function thumbnail(source: ThumbnailSource, layer: DesignLayer, open = false): TemplateResult {
  const { library, design } = source;
  switch (layer.type) {
    case "group":
      return html`<span class="thumbnail plain">${icon(open ? FolderOpen : Folder)}</span>`;
    case "fill":
      return inked(fillInk(layer));
    case "decal":
      return pictured(library, design, layer.asset);
    case "text": {
      const letters = [...layer.text.trim()].slice(0, LETTERS_SHOWN).join("");
      const family = familyOfText(library, design.assets[layer.font]);
      const font = family ? `font-family: "${family}", var(--font); font-weight: normal` : "";
      return html`<span class="thumbnail words" .style=${`color: ${layer.color}; ${font}`}>${letters}</span>`;
    }
    case "stroke":
      return layer.brush.tip === "picture"
        ? pictured(library, design, layer.brush.asset, miniature(source, layer, "layer"))
        : inked(layer.brush.color, miniature(source, layer, "layer"));
    case "paint":
      return paintPicture(layer, miniature(source, layer, "layer"));
  }
}

/** A layer's mask; until it is drawn what it begins with, white for all and black for nothing, and a spot for what was painted. */
export function maskPicture(source: MiniatureSource, layer: DesignLayer, { layers, invert }: Mask): TemplateResult {
  const [first] = layers;
  const hides = first?.type === "fill" && first.blend === "erase" && first.visible;
  const ground = hides === invert ? "#fff" : "#000";
  const painted = layers.length > (hides ? 1 : 0);
  const spot = painted ? svg`<circle cx="12" cy="12" r="5.5" fill=${ground === "#fff" ? "#000" : "#fff"} />` : nothing;
  return html`<span class="mask-picture">
    <svg viewBox="0 0 24 24" aria-hidden="true"><rect width="24" height="24" fill=${ground} />${spot}</svg>
    ${miniature(source, layer, "mask")}
  </span>`;
}

/** As CSS draws it; the place on the model is left out. */
export function gradientInk({ kind, stops }: Gradient): string {
  const list = stops.map(({ offset, color }) => `${color} ${offset * 100}%`).join(", ");
  return kind === "linear" ? `linear-gradient(to top, ${list})` : `radial-gradient(circle, ${list})`;
}

function fillInk({ color, gradient }: FillLayer): string {
  return gradient === null ? color : gradientInk(gradient);
}

function pictured(
  library: AssetLibrary,
  design: Design,
  asset: string,
  over: TemplateResult | typeof nothing = nothing,
): TemplateResult {
  const picture = library.get(design.assets[asset]);
  return html`<span class="thumbnail">
    ${picture?.url ? html`<img src=${picture.url} alt="" draggable="false" />` : nothing}${over}
  </span>`;
}

/** `background` is any CSS colour or image; what is transparent in it shows the checkerboard. */
function inked(background: string, inner: TemplateResult | typeof nothing = nothing): TemplateResult {
  return html`<span class="thumbnail"><span class="ink" .style=${`background: ${background}`}></span>${inner}</span>`;
}

function paintPicture({ strokes }: PaintLayer, over: TemplateResult): TemplateResult {
  const colours = new Set<string>();
  for (let index = strokes.length - 1; index >= 0 && colours.size < COLOURS_SHOWN; index -= 1) {
    const colour = colourOf(strokes[index] as StrokeLayer);
    if (colour !== null) colours.add(colour);
  }
  const mark = html`<span class="mark">${icon(Brush)}</span>${over}`;
  const share = 100 / colours.size;
  const stripes = [...colours].map((colour, index) => `${colour} ${index * share}% ${(index + 1) * share}%`);
  return inked(colours.size === 0 ? "none" : `linear-gradient(135deg, ${stripes.join(", ")})`, mark);
}

/** Null for what has no colour of its own: an eraser, and a stamp of a picture as it is. */
function colourOf({ brush, blend }: StrokeLayer): string | null {
  return blend === "erase" ? null : brush.color;
}
