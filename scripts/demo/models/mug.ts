/** A ceramic mug, 95 mm tall and 82 mm wide without its handle, which points to +X. */

import { type Atlas, flatToUv, joinAtlas, layOutCharts, type PlacedChart, placedChart } from "../geometry/atlas.ts";
import { type Chart, turnPattern } from "../geometry/chart.ts";
import { latheBand, latheDisc } from "../geometry/lathe.ts";
import { type ProfileCorner, profileRun, roundedProfile } from "../geometry/profile.ts";
import { PlaneCurve, superellipse, sweepChart } from "../geometry/sweep.ts";
import { mix, type Vec2, type Vec3 } from "../geometry/vector.ts";
import { addMaterial, addPrimitive, createDocument, writeGlb } from "../output/glb.ts";
import { atlasGuide, partData } from "../output/part-data.ts";
import { fillChart, paintAtlas } from "../picture/paint-atlas.ts";
import { encodePng } from "../picture/png.ts";
import { randomNumbers } from "../picture/random.ts";
import type { Picture } from "../picture/svg.ts";

const MM = 0.001;
const BODY_RADIUS = 41 * MM;
const SEGMENTS = 112;

/** Half the mug in section, millimetres: from the middle of the underside outward, up, over the rim and back inside. */
const SECTION: readonly ProfileCorner[] = [
  { x: 0, y: 2.6 },
  { x: 28.6, y: 2.6, radius: 1.2, steps: 4 },
  { x: 29.2, y: 0, radius: 0.9, steps: 4 },
  { x: 33, y: 0, radius: 1.1, steps: 4 },
  { x: 33.4, y: 2.4, radius: 1.2, steps: 4 },
  { x: 41, y: 5.2, radius: 9, steps: 10 },
  { x: 41, y: 95, radius: 1.9, steps: 6 },
  { x: 37.2, y: 95, radius: 1.9, steps: 6 },
  { x: 36.9, y: 7.4, radius: 10, steps: 10 },
  { x: 0, y: 6.8 },
];
const GROOVE = 4;
const INNER_RIM = 7;
const INNER_FILLET = 8;

function mugCharts(): Chart[] {
  const corners = SECTION.map(({ x, y, radius, steps }) => ({
    x: x * MM,
    y: y * MM,
    ...(radius === undefined ? {} : { radius: radius * MM }),
    ...(steps === undefined ? {} : { steps }),
  }));
  const profile = roundedProfile(corners, 14 * MM);
  // The seam of both bands lies behind the handle, so the pattern's middle is the side opposite to it.
  const band = { segments: SEGMENTS, seamAngle: Math.PI / 2 };
  return [
    latheBand("outside", profileRun(profile, GROOVE, INNER_RIM), { ...band, patternRadius: BODY_RADIUS }),
    turnPattern(
      latheBand("inside", profileRun(profile, INNER_RIM, INNER_FILLET), { ...band, patternRadius: 36.5 * MM }),
    ),
    latheDisc("floor", profileRun(profile, INNER_FILLET, -1), SEGMENTS),
    latheDisc("underside", profileRun(profile, -1, GROOVE), SEGMENTS),
    handleChart(),
  ];
}

/** How far the handle's foot spreads over the wall, and how far from it the spreading begins. */
const FOOT = 5 * MM;

/**
 * The handle is swept in a flat frame (x = distance from the wall, y = height, z = along the wall), and then bent
 * round the body, so that its feet lie exactly on the wall and meet it tangentially.
 */
function handleChart(): Chart {
  const at = (x: number, y: number): Vec2 => [x * MM, y * MM];
  const curve = new PlaneCurve([
    [at(0, 76), at(2, 76), at(4, 76), at(6, 76)],
    [at(6, 76), at(25, 76), at(34.5, 70), at(34.5, 55)],
    [at(34.5, 55), at(34.5, 37), at(22, 26), at(6, 26)],
    [at(6, 26), at(4, 26), at(2, 26), at(0, 26)],
  ]);
  const rings: number[] = [];
  const footRings = 9;
  for (let ring = 0; ring <= footRings; ring++) {
    rings.push(FOOT * (1 - Math.cos((Math.PI / 2) * (ring / footRings))));
  }
  const middleRings = 36;
  for (let ring = 1; ring < middleRings; ring++) rings.push(mix(FOOT, curve.length - FOOT, ring / middleRings));
  rings.push(
    ...rings
      .slice(0, footRings + 1)
      .map((distance) => curve.length - distance)
      .reverse(),
  );
  return sweepChart("handle", {
    curve,
    rings,
    columns: 28,
    seamAngle: Math.PI,
    patternWidth: 38 * MM,
    section: (distance, angle) => {
      const share = distance / curve.length;
      const [x, y] = superellipse(angle, 2.6);
      const foot = footSpread(Math.min(distance, curve.length - distance));
      // The foot grows by the same amount all round: along the superellipse's own direction, as a fillet does.
      const size = Math.hypot(x, y);
      return [(3.9 * MM + foot / size) * x, (mix(7.4, 6.2, share) * MM + foot / size) * y];
    },
    bend: ([x, y, z]) => {
      const radius = BODY_RADIUS + x;
      return [radius * Math.cos(z / radius), y, radius * Math.sin(z / radius)];
    },
  });
}

/** A quarter circle between wall and handle: offset at a distance from the wall. */
function footSpread(distance: number): number {
  if (distance >= FOOT) return 0;
  const rest = 1 - distance / FOOT;
  return FOOT * (1 - Math.sqrt(Math.max(0, 1 - rest * rest)));
}

function mugAtlas(): Atlas {
  return layOutCharts(mugCharts(), { width: 2048, height: 2048, spacing: 12 });
}

/** Millimetres above the table between which the wall is upright, and how near to the handle's middle a press comes. */
const PRINT_LOWEST = 14;
const PRINT_HIGHEST = 88;
const PRINT_FROM_HANDLE = 24;

/** What a mug press reaches: a rectangle round the wall, as corners in u and v. */
export function mugPrintArea(): Vec2[] {
  const atlas = mugAtlas();
  const placed = placedChart(atlas, "outside");
  const left = placed.flatMin[0] + PRINT_FROM_HANDLE * MM;
  const right = placed.flatMax[0] - PRINT_FROM_HANDLE * MM;
  const [top, bottom] = [PRINT_HIGHEST, PRINT_LOWEST].map((height) => flatHeight(placed.chart, height * MM)) as [
    number,
    number,
  ];
  const corners: Vec2[] = [
    [left, top],
    [right, top],
    [right, bottom],
    [left, bottom],
  ];
  return corners.map((corner) => flatToUv(atlas, placed, corner));
}

/** Where on the pattern a height of the upright wall lies. */
function flatHeight(chart: Chart, height: number): number {
  const wall = chart.positions.flatMap(([x, y, z]: Vec3, vertex) =>
    Math.abs(Math.hypot(x, z) - BODY_RADIUS) < 1e-6 ? [{ y, flat: (chart.flat[vertex] as Vec2)[1] }] : [],
  );
  const lowest = wall.reduce((a, b) => (b.y < a.y ? b : a));
  const highest = wall.reduce((a, b) => (b.y > a.y ? b : a));
  return mix(lowest.flat, highest.flat, (height - lowest.y) / (highest.y - lowest.y));
}

const GLAZE = "#f4f0e7";
const INNER_GLAZE = "#dd5a41";
const CLAY = "#d9c9b1";

/** Off-white glaze with fine specks of iron, a coloured glaze inside, bare clay under the foot. */
function paintMug(atlas: Atlas): Promise<Picture> {
  return paintAtlas(atlas, {
    background: GLAZE,
    definitions: `<linearGradient id="glaze" x1="0" y1="0" x2="0" y2="1">
<stop offset="0" stop-color="#efe8da"/><stop offset="0.06" stop-color="${GLAZE}"/>
<stop offset="0.85" stop-color="${GLAZE}"/><stop offset="1" stop-color="#ebe3d3"/></linearGradient>
<linearGradient id="inner" x1="0" y1="0" x2="0" y2="1">
<stop offset="0" stop-color="#e4705a"/><stop offset="0.08" stop-color="${INNER_GLAZE}"/><stop offset="1" stop-color="#d24f38"/></linearGradient>`,
    paintChart: (placed) => {
      switch (placed.chart.name) {
        case "outside":
          return fillChart(placed, "url(#glaze)") + specks(placed, 900, 11);
        case "inside":
          return fillChart(placed, "url(#inner)");
        case "floor":
          return fillChart(placed, "#d24f38");
        case "handle":
          return fillChart(placed, GLAZE) + specks(placed, 120, 12);
        default:
          return underside(placed);
      }
    },
  });
}

function specks(placed: PlacedChart, count: number, seed: number): string {
  const random = randomNumbers(seed);
  const { flatMin, flatMax } = placed;
  let drawing = `<g fill="#7d6a52">`;
  for (let index = 0; index < count; index++) {
    const x = mix(flatMin[0], flatMax[0], random());
    const y = mix(flatMin[1], flatMax[1], random());
    const radius = (0.08 + 0.26 * random() ** 3) * MM;
    drawing += `<circle cx="${x}" cy="${y}" r="${radius}" fill-opacity="${0.15 + 0.3 * random()}"/>`;
  }
  return `${drawing}</g>`;
}

function underside(placed: PlacedChart): string {
  const ring = (inner: number, outer: number): string =>
    `<circle r="${((inner + outer) / 2) * MM}" stroke-width="${(outer - inner) * MM}" fill="none" stroke="${CLAY}"/>`;
  // Pattern radii run along the surface: the inner wall of the foot adds to them.
  return `${fillChart(placed, GLAZE)}${ring(30.6, 35.4)}`;
}

const MUG_PARTS = {
  outside: "Outside",
  inside: "Inside",
  floor: "Floor",
  underside: "Underside",
  handle: "Handle",
};

export async function buildMug(): Promise<Uint8Array<ArrayBuffer>> {
  const atlas = mugAtlas();
  const document = createDocument();
  const material = addMaterial(document, {
    name: "Glaze",
    roughness: 0.22,
    metallic: 0,
    basePicture: await encodePng(await paintMug(atlas)),
  });
  material.setExtras(partData({ guide: atlasGuide(atlas, MUG_PARTS) }));
  const mesh = document.createMesh("Mug").addPrimitive(addPrimitive(document, joinAtlas(atlas), material));
  document.createScene("Mug").addChild(document.createNode("Mug").setMesh(mesh));
  return writeGlb(document);
}
