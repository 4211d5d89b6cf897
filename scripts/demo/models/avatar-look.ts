/** The avatar's base texture: flat, friendly colours with soft light from above and softly lit edges. */

import type { Atlas, PlacedChart } from "../geometry/atlas.ts";
import { fillBox, fillChart, paintAtlas } from "../picture/paint-atlas.ts";
import type { Picture } from "../picture/svg.ts";
import type { AvatarPart, BoundChart, Cloth } from "./avatar-body.ts";

const COLOURS: Readonly<Record<Cloth, string>> = {
  skin: "#e9ab7c",
  hair: "#472c25",
  shirt: "#eea628",
  trousers: "#2a3d5f",
  shoe: "#dd5b43",
  trim: "#fdf3df",
};

const DEFINITIONS = `
<linearGradient id="shade" x1="0" y1="0" x2="0" y2="1">
<stop offset="0" stop-color="#fff" stop-opacity="0.1"/><stop offset="0.45" stop-color="#fff" stop-opacity="0"/>
<stop offset="0.6" stop-color="#241a3c" stop-opacity="0"/><stop offset="1" stop-color="#241a3c" stop-opacity="0.16"/></linearGradient>
<linearGradient id="edge" x1="0" y1="0" x2="1" y2="0">
<stop offset="0" stop-color="#fff" stop-opacity="0"/><stop offset="0.5" stop-color="#fff" stop-opacity="0.13"/>
<stop offset="1" stop-color="#fff" stop-opacity="0"/></linearGradient>
<radialGradient id="blush"><stop offset="0" stop-color="#ee6f5c" stop-opacity="0.5"/>
<stop offset="0.5" stop-color="#ee6f5c" stop-opacity="0.3"/><stop offset="1" stop-color="#ee6f5c" stop-opacity="0"/></radialGradient>
<linearGradient id="eye" x1="0" y1="0" x2="0" y2="1"><stop offset="0" stop-color="#20181f"/><stop offset="1" stop-color="#4a3135"/></linearGradient>`;

export function paintAvatar(atlas: Atlas, bound: readonly BoundChart[]): Promise<Picture> {
  return paintAtlas(atlas, {
    background: "#e9e2d6",
    definitions: DEFINITIONS,
    paintChart: (placed) => {
      const found = bound.find(({ chart }) => chart.name === placed.chart.name) as BoundChart;
      const isBand = placed.chart.name === found.part.name;
      return isBand ? paintBand(placed, found.part) : paintCap(placed, found.part);
    },
  });
}

function paintBand(placed: PlacedChart, part: AvatarPart): string {
  return `${fillChart(placed, COLOURS[part.cloth])}${details(placed, part)}${fillChart(placed, "url(#shade)")}${edges(placed, part)}`;
}

function paintCap(placed: PlacedChart, part: AvatarPart): string {
  const isTop = placed.chart.name.endsWith("top");
  const light = isTop ? `fill="#fff" fill-opacity="0.1"` : `fill="#241a3c" fill-opacity="0.16"`;
  const veil = fillChart(placed, "none").replace(`fill="none"`, light);
  return `${fillChart(placed, capColour(part, isTop))}${veil}`;
}

function capColour(part: AvatarPart, isTop: boolean): string {
  if (part.cloth === "shoe" && !isTop) return "#efe6d6";
  if (part.name === "head" && isTop) return COLOURS.hair;
  return COLOURS[part.cloth];
}

/** Soft light along the four upright edges of a band. */
function edges(placed: PlacedChart, part: AvatarPart): string {
  const arc = (part.bevel * Math.PI) / 2;
  const height = placed.flatMax[1] - placed.flatMin[1];
  const corners = cornerMiddles(part);
  return corners
    .map(
      (x) =>
        `<rect x="${x - arc}" y="${-height * 0.1}" width="${arc * 2}" height="${height * 1.2}" fill="url(#edge)"/>`,
    )
    .join("");
}

/** Where the edges lie on a band's pattern, which starts at the middle of the back and goes by the avatar's right side. */
function cornerMiddles(part: AvatarPart): number[] {
  const arc = (part.bevel * Math.PI) / 2;
  const width = part.size[0] - 2 * part.bevel;
  const depth = part.size[2] - 2 * part.bevel;
  const first = width / 2 + arc / 2;
  return [first, first + depth + arc, first + depth + width + 2 * arc, first + 2 * depth + width + 3 * arc];
}

/** Middle of the front on a band's pattern. */
const frontX = (placed: PlacedChart): number => (placed.flatMin[0] + placed.flatMax[0]) / 2;

function details(placed: PlacedChart, part: AvatarPart): string {
  switch (part.name) {
    case "head":
      return face(placed);
    case "torso":
      return fillBox(placed, "#d98f1c", 0.945, 1);
    case "hips":
      return fillBox(placed, "#243450", 0.18, 0.42) + belt(placed);
    default:
      break;
  }
  if (part.cloth === "hair") return strands(placed);
  if (part.name.endsWith("sleeve")) return fillBox(placed, COLOURS.trim, 0.8, 0.9);
  if (part.name.endsWith("leg")) return fillBox(placed, "#3d557f", 0.9, 1);
  if (part.name.endsWith("shoe")) return shoe(placed);
  return "";
}

function face(placed: PlacedChart): string {
  const x = frontX(placed);
  const eye = (side: number): string => {
    const cx = x + side * 0.078;
    return `<ellipse cx="${cx}" cy="0.2" rx="0.0235" ry="0.036" fill="url(#eye)"/>
<circle cx="${cx + 0.007}" cy="0.186" r="0.0085" fill="#fff"/><circle cx="${cx - 0.007}" cy="0.213" r="0.004" fill="#fff" fill-opacity="0.7"/>
<path d="M${cx - 0.03} ${0.148 - side * 0.002} Q${cx} 0.133 ${cx + 0.03} ${0.148 + side * 0.002}" stroke="${COLOURS.hair}" stroke-width="0.0095" stroke-linecap="round" fill="none"/>
<ellipse cx="${x + side * 0.118}" cy="0.252" rx="0.034" ry="0.022" fill="url(#blush)"/>`;
  };
  // Hair grows on the head itself too, under the blocks of the hair, so that no skin shows between them.
  return `<rect x="-1" y="-1" width="3" height="1.06" fill="${COLOURS.hair}"/>
<rect x="-1" y="-1" width="${1 + cornerBack(placed)}" height="1.22" fill="${COLOURS.hair}"/>
<rect x="${placed.flatMax[0] - cornerBack(placed)}" y="-1" width="1" height="1.22" fill="${COLOURS.hair}"/>
${eye(-1)}${eye(1)}
<path d="M${x - 0.042} 0.268 Q${x} 0.312 ${x + 0.042} 0.268 Q${x} 0.286 ${x - 0.042} 0.268 Z" fill="#8f3b35" stroke="#8f3b35" stroke-width="0.008" stroke-linejoin="round"/>
<path d="M${x - 0.006} 0.236 Q${x} 0.241 ${x + 0.006} 0.236" stroke="#cf8058" stroke-width="0.007" stroke-linecap="round" fill="none"/>`;
}

/** How far the back of the head reaches from the seam. */
const cornerBack = (placed: PlacedChart): number => (placed.flatMax[0] - placed.flatMin[0]) * 0.17;

function strands(placed: PlacedChart): string {
  const { flatMin, flatMax } = placed;
  let drawing = `<g stroke="#6a473a" stroke-opacity="0.55" stroke-width="0.006" stroke-linecap="round" fill="none">`;
  const height = flatMax[1] - flatMin[1];
  const spacing = 0.042;
  for (let x = flatMin[0] + spacing / 2, index = 0; x < flatMax[0]; x += spacing, index++) {
    const top = flatMin[1] + height * (0.2 + 0.16 * ((index * 5) % 3));
    const length = height * (0.26 + 0.1 * ((index * 7) % 4) * 0.5);
    drawing += `<path d="M${x} ${top} q0.008 ${length / 2} 0 ${length}"/>`;
  }
  return `${drawing}</g>`;
}

function belt(placed: PlacedChart): string {
  const x = frontX(placed);
  const height = placed.flatMax[1] - placed.flatMin[1];
  return `<rect x="${x - 0.026}" y="${height * 0.15}" width="0.052" height="${height * 0.3}" rx="0.008" fill="none" stroke="#e6c78a" stroke-width="0.01"/>`;
}

function shoe(placed: PlacedChart): string {
  const x = frontX(placed);
  const height = placed.flatMax[1] - placed.flatMin[1];
  const lace = (share: number): string =>
    `<path d="M${x - 0.03} ${height * share} H${x + 0.03}" stroke="#fdf3df" stroke-width="0.009" stroke-linecap="round"/>`;
  return `${fillBox(placed, "#efe6d6", 0.68, 1)}${fillBox(placed, "#b9432f", 0.64, 0.68)}${lace(0.14)}${lace(0.28)}`;
}
