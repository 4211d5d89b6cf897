import { describe, expect, it } from "vitest";
import { INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { legibleColor } from "../../web/editor/state/legible-color.ts";
import type { TargetInfo } from "../../web/engine/engine-api.ts";
import type { SurfaceHit } from "../../web/viewer/viewer-api.ts";
import { FRONT } from "../support/layers.ts";

type Rgb = readonly [number, number, number];

const BLACK: Rgb = [0, 0, 0];
const PAPER: Rgb = [255, 255, 255];
const NAVY: Rgb = [20, 40, 90];
const MID_BLUE: Rgb = [30, 102, 245];
const YELLOW: Rgb = [250, 204, 21];
const GREY: Rgb = [128, 128, 128];

/** A wall of 100 texels a metre, coloured by how far along it a texel is; `painted`: whether its texture is open. */
function wall(colorAt: (along: number) => Rgb, painted = true) {
  const targets = new Map(painted ? [[3, { width: 200, height: 200 } as TargetInfo]] : []);
  const asked: number[] = [];
  const parts = {
    store: { state: { ...INITIAL_STATE, targets } },
    engine: {
      readTexels: async (_material: number, x: number) => {
        asked.push(x);
        return new Uint8Array([...colorAt((x + 0.5) / 100 - 1), 255]);
      },
    },
  };
  const near = ([x, y]: readonly [number, number, number]): SurfaceHit =>
    ({ position: [x, y, 0], material: 3, uv: [(x + 1) / 2, (y + 1) / 2] }) as unknown as SurfaceHit;
  return { parts, surface: { near }, asked };
}

const box = { ...FRONT, position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 0.2, 0.2] } as const;

describe("the colour of new letters", () => {
  it.each([BLACK, NAVY, MID_BLUE])("is white on the dark colour %s, %s, %s", async (...dark) => {
    const { parts, surface } = wall(() => dark);
    expect(await legibleColor(parts, surface, box)).toBe("#ffffff");
  });

  it.each([PAPER, YELLOW, GREY])("is left dark on the light colour %s, %s, %s", async (...light) => {
    const { parts, surface } = wall(() => light);
    expect(await legibleColor(parts, surface, box)).toBeNull();
  });

  it("is that which most of the words are read in, from their beginning to their end", async () => {
    const split = wall((along) => (along < 0.2 ? BLACK : PAPER));
    expect(await legibleColor(split.parts, split.surface, box)).toBe("#ffffff");
    const other = wall((along) => (along < -0.2 ? BLACK : PAPER));
    expect(await legibleColor(other.parts, other.surface, box)).toBeNull();
    expect(Math.min(...other.asked)).toBeLessThan(60);
    expect(Math.max(...other.asked)).toBeGreaterThan(140);
  });

  it("follows the words' own direction", async () => {
    const up = wall((along) => (Math.abs(along) < 0.06 ? BLACK : PAPER));
    const turned = { ...box, rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2] } as const;
    expect(await legibleColor(up.parts, up.surface, turned)).toBe("#ffffff");
    expect(await legibleColor(up.parts, up.surface, box)).toBeNull();
  });

  it("is left dark where nothing is known of the product: no texture, no surface, no answer", async () => {
    const closed = wall(() => BLACK, false);
    expect(await legibleColor(closed.parts, closed.surface, box)).toBeNull();
    const { parts, surface } = wall(() => BLACK);
    expect(await legibleColor(parts, { near: () => null }, box)).toBeNull();
    const silent = { ...parts, engine: { readTexels: () => Promise.reject(new Error("closed")) } };
    expect(await legibleColor(silent, surface, box)).toBeNull();
    expect(await legibleColor(parts, surface, { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 })).toBeNull();
  });
});
