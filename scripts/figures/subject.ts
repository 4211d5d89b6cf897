/** What the figures show: the demo's avatar, and decals on it. */
import { readFile } from "node:fs/promises";
import type { Design } from "../../web/editor/document/index.ts";
import { parseDesign } from "../../web/editor/document/index.ts";
import type { Quaternion, Vec3 } from "../../web/engine/engine-api.ts";
import { inRoot } from "../bootstrap/paths.mjs";

export const DECALS = ["badge", "flower", "sunburst", "number"] as const;
export type DecalName = (typeof DECALS)[number];

/** Metres and degrees, model space; the avatar stands on y = 0 and looks along +Z. */
export interface Stamp {
  readonly decal: DecalName;
  readonly position: Vec3;
  readonly size: number;
  /** How far the box reaches in and out. */
  readonly depth: number;
  /** Around the avatar's own height, then around the way the decal looks. */
  readonly turn?: number;
  readonly roll?: number;
}

/** From the shirt over the belt to the trousers, which lie apart in the texture; its middle is on the shirt. */
export const BELT: Stamp = { decal: "badge", position: [0, 0.94, 0.13], size: 0.4, depth: 0.2 };

export const TRANSFORMS: readonly { readonly name: string; readonly stamp: Stamp }[] = [
  { name: "as it is", stamp: BELT },
  { name: "moved and scaled", stamp: { ...BELT, position: [0.06, 1.08, 0.13], size: 0.22 } },
  { name: "rolled", stamp: { ...BELT, roll: 40 } },
  { name: "turned", stamp: { ...BELT, position: [0.1, 0.9, 0.08], turn: 50, depth: 0.4 } },
];

/** The whole picture. */
export const DRESSED: readonly Stamp[] = [
  { decal: "badge", position: [0, 1.02, 0.13], size: 0.34, depth: 0.2 },
  { decal: "sunburst", position: [-0.1, 0.52, 0.12], size: 0.28, depth: 0.2, roll: 15 },
  { decal: "flower", position: [0.11, 0.32, 0.12], size: 0.22, depth: 0.2 },
];

export const LOGO: Stamp = { decal: "number", position: [0, 1.0, 0.13], size: 0.36, depth: 0.2 };

export const avatar = () => readFile(inRoot("build/public/demo/avatar.glb"));
export const decalPng = (name: DecalName) => readFile(inRoot("build/public/demo/decals", `${name}.png`));

export async function designOf(stamps: readonly Stamp[]): Promise<Design> {
  const names = [...new Set(stamps.map(({ decal }) => decal))];
  const pngs = await Promise.all(names.map(async (name) => (await decalPng(name)).toString("base64")));
  const assets = names.map((name, index) => [name, { type: "image/png", uri: `data:image/png;base64,${pngs[index]}` }]);
  const layers = stamps.map(({ decal, position, size, depth, turn = 0, roll = 0 }, index) => ({
    ...{ id: `stamp-${index}`, type: "decal", name: decal, asset: decal },
    projector: { kind: "planar", position, rotation: rotationOf(turn, roll), size: [size, size, depth] },
  }));
  const document = { format: "texelcast-design", version: 1, assets: Object.fromEntries(assets), layers };
  return parseDesign(document, "figures");
}

function rotationOf(turn: number, roll: number): Quaternion {
  const [half, halfRoll] = [turn, roll].map((degrees) => (degrees / 360) * Math.PI);
  const [sy, cy, sz, cz] = [Math.sin(half), Math.cos(half), Math.sin(halfRoll), Math.cos(halfRoll)];
  return [sy * sz, sy * cz, cy * sz, cy * cz];
}
