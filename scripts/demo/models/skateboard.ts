/** A complete skateboard, standing on its tail with the graphic side to the viewer. */

import {
  type Atlas,
  flatToUv,
  joinAtlas,
  joinGeometry,
  layOutCharts,
  type PlacedChart,
  placedChart,
} from "../geometry/atlas.ts";
import { type Chart, placeChart } from "../geometry/chart.ts";
import { mix, smoothstep, type Vec2, type Vec3 } from "../geometry/vector.ts";
import { addMaterial, addPrimitive, createDocument, writeGlb } from "../output/glb.ts";
import { atlasGuide, partData } from "../output/part-data.ts";
import { fractalNoise, valueNoise } from "../picture/noise.ts";
import { fillBox, fillChart, paintAtlas } from "../picture/paint-atlas.ts";
import { encodePng } from "../picture/png.ts";
import type { Picture } from "../picture/svg.ts";
import { DECK_THICKNESS, deckCharts } from "./skateboard-deck.ts";
import { gripBolts, truckBushings, truckMetal, truckWheels } from "./skateboard-parts.ts";

const TRUCK_DISTANCE = 0.19;

interface SkateboardCharts {
  readonly deck: readonly Chart[];
  readonly wheels: readonly Chart[];
  readonly metal: readonly Chart[];
  readonly bushings: readonly Chart[];
}

function skateboardCharts(): SkateboardCharts {
  const deck = deckCharts();
  const lowest = Math.min(...deck.flatMap((chart) => chart.positions.map((position) => position[1])));
  const stand = (charts: readonly Chart[]): Chart[] => charts.map((chart) => placeChart(chart, [0, -lowest, 0]));
  const ends = [
    { inner: 1, y: -TRUCK_DISTANCE },
    { inner: -1, y: TRUCK_DISTANCE },
  ] as const;
  const on = (y: number, z: number): Vec3 => [0, y, z];
  const half = DECK_THICKNESS / 2;
  return {
    deck: stand(deck),
    wheels: stand(ends.flatMap(({ inner, y }) => truckWheels(inner, on(y, half)))),
    metal: stand(
      ends.flatMap(({ inner, y }) => [...truckMetal(inner, on(y, half)), ...gripBolts(inner, on(y, -half))]),
    ),
    bushings: stand(ends.flatMap(({ inner, y }) => truckBushings(inner, on(y, half)))),
  };
}

function deckAtlas(charts: SkateboardCharts): Atlas {
  return layOutCharts(charts.deck, { width: 1024, height: 2048, spacing: 10 });
}

/** The rectangle round the graphic's side, as corners in u and v: nothing else of the board lies in it. */
export function deckPrintArea(): Vec2[] {
  const atlas = deckAtlas(skateboardCharts());
  const placed = placedChart(atlas, "graphic");
  const { flatMin, flatMax } = placed;
  const corners: Vec2[] = [flatMin, [flatMax[0], flatMin[1]], flatMax, [flatMin[0], flatMax[1]]];
  return corners.map((corner) => flatToUv(atlas, placed, corner));
}

function wheelAtlas(charts: SkateboardCharts): Atlas {
  return layOutCharts(charts.wheels, { width: 1024, height: 1024, spacing: 8 });
}

/** Maple veneer, black grip tape with grain, and the glued plies on the edge, two of them dyed. */
async function paintDeck(atlas: Atlas): Promise<Picture> {
  const plies = ["#d9b27c", "#c4955c", "#e3c28f", "#1f7f86", "#e3c28f", "#c4955c", "#de5b43", "#dcb784"];
  const picture = await paintAtlas(atlas, {
    background: "#d8b07a",
    paintChart: (placed) =>
      placed.chart.name.endsWith("edge") ? uprightStripes(placed, plies) : fillChart(placed, "#d8b07a"),
  });
  paintWood(picture, placedChart(atlas, "graphic"), atlas.spacing / 2);
  paintGrip(picture, placedChart(atlas, "grip"), atlas.spacing / 2);
  return picture;
}

/** Stripes along an upright pattern, from the graphic's side (right) to the grip's. */
function uprightStripes(placed: PlacedChart, colours: readonly string[]): string {
  const { flatMin, flatMax } = placed;
  const width = (flatMax[0] - flatMin[0]) / colours.length;
  const height = flatMax[1] - flatMin[1] + 0.02;
  const stripes = colours.map((colour, index) => {
    const x = flatMax[0] - (index + 1) * width;
    return `<rect x="${x}" y="${flatMin[1] - 0.01}" width="${width * 1.02}" height="${height}" fill="${colour}"/>`;
  });
  return fillBox(placed, "#d9b27c", 0, 1) + stripes.join("");
}

type PaintTexel = (x: number, y: number) => readonly [number, number, number];

/** Sets every texel of a chart's rectangle and margin; `paint` gets metres of the pattern and gives sRGB, 0 to 255. */
function paintTexels(picture: Picture, placed: PlacedChart, margin: number, paint: PaintTexel): void {
  const right = Math.min(picture.width, Math.ceil(placed.x + placed.width + margin));
  const bottom = Math.min(picture.height, Math.ceil(placed.y + placed.height + margin));
  for (let row = Math.max(0, placed.y - margin); row < bottom; row++) {
    for (let column = Math.max(0, placed.x - margin); column < right; column++) {
      const x = (column + 0.5 - placed.x) / placed.texelsPerMetre + placed.flatMin[0];
      const y = (row + 0.5 - placed.y) / placed.texelsPerMetre + placed.flatMin[1];
      picture.rgba.set(paint(x, y), (row * picture.width + column) * 4);
    }
  }
}

function paintWood(picture: Picture, placed: PlacedChart, margin: number): void {
  const light = [226, 190, 138] as const;
  const dark = [182, 128, 74] as const;
  paintTexels(picture, placed, margin, (x, y) => {
    // Year rings cut lengthwise: lines along the board, drawn apart by a slow warp.
    const warp = 0.9 * fractalNoise(x * 9, y * 1.7, 3, 21) + 0.18 * fractalNoise(x * 40, y * 5, 2, 33);
    const ring = x * 34 + warp * 3.2;
    const phase = ring - Math.floor(ring);
    const lateWood = smoothstep(0.35, 0.92, phase) * (1 - smoothstep(0.92, 1, phase));
    const fibre = 0.5 * valueNoise(x * 1500, y * 14, 5) + 0.5 * valueNoise(x * 700, y * 6, 7);
    const tone = 0.16 + 0.34 * lateWood + 0.1 * fibre + 0.12 * fractalNoise(x * 3, y * 1.2, 2, 9);
    // Steps of about two levels of eight bits: not seen under the grain, and the file is a third smaller.
    const share = Math.round(Math.min(1, Math.max(0, tone)) * 32) / 32;
    return [mix(light[0], dark[0], share), mix(light[1], dark[1], share), mix(light[2], dark[2], share)];
  });
}

function paintGrip(picture: Picture, placed: PlacedChart, margin: number): void {
  paintTexels(picture, placed, margin, (x, y) => {
    const grain = valueNoise(x * 1400, y * 1400, 3);
    // Three greys and no more: grain is noise, which a PNG can hardly compress.
    const level = 29 + 8 * Math.round(1.2 * grain);
    return [level, level, level];
  });
}

/** Roughness in green, metalness (none) in blue: lacquered graphic, matte plies, coarse grip. */
function paintDeckSurface(atlas: Atlas): Promise<Picture> {
  return paintAtlas(atlas, {
    background: "rgb(255,110,0)",
    outputWidth: 128,
    paintChart: (placed) => {
      const roughness = { graphic: 88, grip: 245 }[placed.chart.name] ?? 165;
      return fillChart(placed, `rgb(255,${roughness},0)`);
    },
  });
}

export async function buildSkateboard(): Promise<Uint8Array<ArrayBuffer>> {
  const charts = skateboardCharts();
  const atlas = deckAtlas(charts);
  const [basePicture, surfacePicture] = [
    await encodePng(await paintDeck(atlas)),
    await encodePng(await paintDeckSurface(atlas)),
  ];
  const document = createDocument();
  const deck = addMaterial(document, { name: "Deck", roughness: 1, metallic: 1, basePicture, surfacePicture });
  deck.setExtras(partData({ guide: atlasGuide(atlas, { graphic: "Graphic", grip: "Grip" }) }));
  const wheels = addMaterial(document, {
    name: "Wheels",
    baseColor: [0.87, 0.83, 0.74, 1],
    roughness: 0.42,
    metallic: 0,
  });
  const metal = addMaterial(document, {
    name: "Metal",
    baseColor: [0.72, 0.73, 0.75, 1],
    roughness: 0.34,
    metallic: 1,
  });
  const bushings = addMaterial(document, {
    name: "Bushings",
    baseColor: [0.73, 0.1, 0.05, 1],
    roughness: 0.4,
    metallic: 0,
  });
  const withoutUvs = (parts: readonly Chart[]) => joinGeometry(parts, () => [0, 0]);
  const mesh = document
    .createMesh("Skateboard")
    .addPrimitive(addPrimitive(document, joinAtlas(atlas), deck))
    .addPrimitive(addPrimitive(document, joinAtlas(wheelAtlas(charts)), wheels))
    .addPrimitive(addPrimitive(document, withoutUvs(charts.metal), metal, false))
    .addPrimitive(addPrimitive(document, withoutUvs(charts.bushings), bushings, false));
  document.createScene("Skateboard").addChild(document.createNode("Skateboard").setMesh(mesh));
  return writeGlb(document);
}
