/** A layer's picture, small, over a checkerboard that shows where it is transparent. */
import { css, html, nothing, type TemplateResult } from "lit";
import type { Design, DesignLayer } from "../document/index.ts";
import type { AssetLibrary } from "../state/asset-library.ts";

export const thumbnailStyles = css`
  .thumbnail {
    flex: none;
    display: grid;
    place-items: center;
    width: 32px;
    height: 32px;
    overflow: hidden;
    border-radius: 5px;
    background: repeating-conic-gradient(var(--tile-checker) 0 25%, var(--tile) 0 50%) 0 0 / 10px 10px;
    box-shadow: inset 0 0 0 1px var(--line);
  }
  .thumbnail img {
    width: 100%;
    height: 100%;
    object-fit: contain;
  }
`;

export function thumbnail(library: AssetLibrary, design: Design, layer: DesignLayer): TemplateResult {
  const brush = layer.type === "stroke" ? layer.brush : undefined;
  const color = layer.type === "fill" ? layer.color : brush?.tip === "round" ? brush.color : undefined;
  if (color) return html`<span class="thumbnail" style=${`background:${color}`}></span>`;
  const asset = layer.type === "decal" ? layer.asset : brush?.tip === "picture" ? brush.asset : undefined;
  const picture = asset === undefined ? undefined : library.get(design.assets[asset]);
  return html`<span class="thumbnail">${picture ? html`<img src=${picture.url} alt="" draggable="false" />` : nothing}</span>`;
}
