/** The benchmark's page: the same work for all, driven by bench/browser/main.ts through `window.bench`. */
import { REVISION } from "three";
import type { Picture, PlanarProjector } from "../../web/engine/engine-api.ts";
import { nudged } from "../nudged.ts";
import type { Figures } from "../rounds.ts";
import { takeTurns } from "../rounds.ts";
import type { BenchMesh } from "../work.ts";
import { BabylonEngine } from "./babylon-engine.ts";
import type { PageEngine } from "./page-engine.ts";
import { TexelcastPageEngine } from "./texelcast-page-engine.ts";
import { ThreeDecalEngine } from "./three-decal-engine.ts";

export interface EngineFigures extends Figures {
  readonly engine: string;
}

export interface BenchPage {
  /** Versions of what the page itself brings, and the graphics card. */
  readonly versions: Readonly<Record<string, string>>;
  load(mesh: BenchMesh, decal: Picture): Promise<void>;
  prepare(size: number): Promise<void>;
  bake(size: number, rounds: number): Promise<EngineFigures[]>;
  drag(projector: PlanarProjector, rounds: number): Promise<EngineFigures[]>;
  /** Each engine's texture after one step, for people to compare; null where it paints none. */
  textures(projector: PlanarProjector): Promise<{ readonly engine: string; readonly rgba: Uint8Array | null }[]>;
}

declare global {
  interface Window {
    bench?: BenchPage;
  }
}

const ours = await TexelcastPageEngine.create({ upload: false });
const engines: readonly PageEngine[] = [
  ours,
  await TexelcastPageEngine.create({ upload: true }),
  new BabylonEngine(),
  new ThreeDecalEngine(),
];

window.bench = {
  versions: { "babylon.js": BabylonEngine.version, "three.js": REVISION, graphics: graphicsCard() },
  async load(mesh, decal) {
    for (const engine of engines) await engine.load(mesh, decal);
  },
  async prepare(size) {
    for (const engine of engines) await engine.prepare(size);
  },
  async bake(size, rounds) {
    const [{ figures }] = await takeTurns([ours], rounds, () => ours.engine.bake(size));
    return [{ engine: ours.name, ...figures }];
  },
  async drag(projector, rounds) {
    const results = await takeTurns(engines, rounds, (engine, round) =>
      engine.project({ projector: nudged(projector, round), occlusion: "none" }),
    );
    return results.map(({ contestant, figures }) => ({ engine: contestant.name, ...figures }));
  },
  async textures(projector) {
    const pictures: { engine: string; rgba: Uint8Array | null }[] = [];
    for (const engine of engines) {
      await engine.project({ projector, occlusion: "none" });
      pictures.push({ engine: engine.name, rgba: await engine.readTexture() });
    }
    return pictures;
  },
};

function graphicsCard(): string {
  const gl = document.createElement("canvas").getContext("webgl2");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  return names ? String(gl?.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "unknown";
}
