/** The hand-painted strokes of the paper's teaser: paths drawn on the avatar as it is seen from the front. */
import { type Dab, type Design, type PathPoint, parseDesign, placeDabs } from "../../web/editor/document/index.ts";
import type { EngineHost } from "../../web/engine/engine-host.ts";
import { decalPng } from "./subject.ts";

/** Metres: how finely the surface is looked up. */
const CELL = 0.008;
/** Points along a path. */
const POINTS = 120;

/** Where the surface is, straight ahead of a viewer in front; null beside the model. */
type Front = (x: number, y: number) => PathPoint | null;

/** Looks the surface up in the local space texture itself: of all texels behind a place, the one nearest to the viewer. */
export async function frontOf(engine: EngineHost, size: number): Promise<Front> {
  const [positions, normals, coverage] = [
    await engine.readMapRows(0, "positions", 0, size),
    await engine.readMapRows(0, "normals", 0, size),
    await engine.readMapRows(0, "coverage", 0, size),
  ];
  const cellOf = (x: number, y: number): string => `${Math.round(x / CELL)} ${Math.round(y / CELL)}`;
  const nearest = new Map<string, PathPoint>();
  for (let texel = 0; texel < size * size; texel++) {
    if (coverage[texel] !== 1) continue;
    const [x, y, z] = positions.subarray(texel * 3, texel * 3 + 3);
    const [nx, ny, nz] = normals.subarray(texel * 3, texel * 3 + 3);
    const cell = cellOf(x, y);
    const known = nearest.get(cell);
    if (known !== undefined && known.position[2] >= z) continue;
    nearest.set(cell, { position: [x, y, z], normal: [nx, ny, nz] });
  }
  return (x, y) => {
    const found = nearest.get(cellOf(x, y));
    return found === undefined ? null : { ...found, position: [x, y, found.position[2]] };
  };
}

interface Stroke {
  readonly name: string;
  readonly brush: object;
  /** Of a dab, metres. */
  readonly size: number;
  readonly spacing: number;
  /** Where the brush is at a share of its way. */
  readonly path: (share: number) => readonly [number, number];
  /** Default: 1 all the way. */
  readonly pressure?: (share: number) => number;
}

const TURN = 2 * Math.PI;

/** Bottom to top. */
const STROKES: readonly Stroke[] = [
  {
    name: "Airbrush",
    brush: { color: "#7ee8fa", hardness: 0, flow: 0.12 },
    size: 0.13,
    spacing: 0.1,
    path: (t) => [-0.1 + 0.04 * Math.sin(t * 5 * Math.PI), 0.78 - 0.56 * t],
  },
  {
    name: "Flowers",
    brush: { tip: "picture", asset: "flower" },
    size: 0.085,
    spacing: 1.25,
    path: (t) => [0.1 + 0.03 * Math.sin(t * TURN), 0.74 - 0.52 * t],
  },
  {
    name: "Heart",
    brush: { color: "#e0264c", hardness: 0.85 },
    size: 0.032,
    spacing: 0.12,
    path: (t) => {
      const a = t * TURN;
      const y = 13 * Math.cos(a) - 5 * Math.cos(2 * a) - 2 * Math.cos(3 * a) - Math.cos(4 * a);
      return [0.0085 * 16 * Math.sin(a) ** 3, 1.0 + 0.0085 * y];
    },
  },
  {
    name: "Wave",
    brush: { color: "#243a78", hardness: 0.6, flow: 0.6 },
    size: 0.03,
    spacing: 0.12,
    path: (t) => [-0.16 + 0.32 * t, 1.235 + 0.022 * Math.sin(t * 3 * TURN)],
    pressure: (t) => Math.sin(t * Math.PI),
  },
];

function dabsOf({ path, size, spacing, pressure }: Stroke, front: Front): readonly Dab[] {
  const points = Array.from({ length: POINTS + 1 }, (_, i) => {
    const share = i / POINTS;
    const point = front(...path(share));
    return point && { ...point, pressure: pressure?.(share) ?? 1 };
  });
  return placeDabs(
    points.filter((point) => point !== null),
    { size, spacing, depth: 0.08 },
  ).dabs;
}

/** All strokes as a design. */
export async function strokesDesign(front: Front): Promise<Design> {
  const uri = `data:image/png;base64,${(await decalPng("flower")).toString("base64")}`;
  const layers = STROKES.map((stroke) => ({
    type: "stroke",
    name: stroke.name,
    brush: stroke.brush,
    dabs: dabsOf(stroke, front),
  }));
  const assets = { flower: { type: "image/png", uri } };
  return parseDesign({ format: "texelcast-design", version: 1, assets, layers }, "strokes");
}
