/** A target whose layers ask for more memory than there is, beside one that can be drawn. */
import { afterEach, describe, expect, it } from "vitest";
import type { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { EngineLayer } from "../../web/engine/engine-api.ts";
import type { EngineHost } from "../../web/engine/engine-host.ts";
import { decal, FRONT, fill } from "../support/layers.ts";
import { endHosts, LOGO, startHost } from "../support/painted-plane.ts";
import { halvesGlb } from "../support/two-halves.ts";

afterEach(endHosts);

const LARGE = 512;
const SMALL = 16;
const RED = [1, 0, 0, 1] as const;
const OVER_BUDGET = { code: "out-of-budget" };

/** Of a target that is opened first, so that it is drawn before the other. */
const TOO_MANY: readonly EngineLayer[] = Array.from({ length: 32 }, (_, index) =>
  decal(`large ${index}`, "logo", { occlusion: "none", projector: { ...FRONT, size: [4, 4, 4] } }),
);

async function twoTargets(): Promise<{ engine: EngineHost; codes: string[] }> {
  const engine = startHost({ memoryBudgetMib: 24 });
  const codes: string[] = [];
  engine.onError((error) => codes.push((error as TexelcastError).code));
  await engine.loadModel({ name: "halves.glb", bytes: halvesGlb({ materials: 2 }) });
  await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
  await engine.openTarget({ material: 0, width: LARGE, height: LARGE });
  await engine.openTarget({ material: 1, width: SMALL, height: SMALL });
  await engine.idle();
  return { engine, codes };
}

const firstTexel = async (engine: EngineHost): Promise<number[]> => [...(await engine.readTexels(1, 8, 8, 1, 1))];

describe("a target that cannot be drawn", () => {
  it("leaves the others to be drawn, read and exported as they are asked for", async () => {
    const { engine, codes } = await twoTargets();
    engine.setLayers([...TOO_MANY, fill("red", RED, { material: 1 })], 1);
    expect(await firstTexel(engine)).toEqual([255, 0, 0, 255]);
    expect(codes).toEqual(["out-of-budget"]);
    await engine.exportPng(1);
    await engine.exportGlb([1]);
    expect((await engine.layerMiniature("red", "layer", 4))?.subarray(0, 4)).toEqual(Uint8Array.of(255, 0, 0, 255));
    await engine.printMap(1, "dpi");
  });

  it("says why to whoever asks for its texels, instead of those of older layers, and to whoever waits for all", async () => {
    const { engine } = await twoTargets();
    engine.setLayers([...TOO_MANY, fill("red", RED, { material: 1 })], 1);
    for (const ask of [
      () => engine.idle(),
      () => engine.idle(),
      () => engine.readTexels(0, 0, 0, 1, 1),
      () => engine.hash(0),
      () => engine.layerMiniature("large 0", "layer", 4),
      () => engine.exportPng(0),
      () => engine.exportGlb(),
      () => engine.printMap(0, "dpi"),
      () => engine.printReport(),
    ]) {
      await expect(ask(), String(ask)).rejects.toMatchObject(OVER_BUDGET);
    }
  });

  it("is drawn as ever once its layers fit", async () => {
    const { engine } = await twoTargets();
    const fitting = TOO_MANY.slice(0, 1);
    engine.setLayers(fitting, 1);
    const expected = await engine.hash(0);
    engine.setLayers(TOO_MANY, 2);
    await expect(engine.idle()).rejects.toMatchObject(OVER_BUDGET);
    engine.setLayers(fitting, 3);
    expect(await engine.hash(0)).toBe(expected);
    await engine.idle();
  });

  it("is tried again when another that took up the memory is closed", async () => {
    const { engine, codes } = await twoTargets();
    await engine.openTarget({ material: 1, width: LARGE, height: LARGE });
    const both = TOO_MANY.slice(0, 12).map((layer) => ({ ...layer, material: [0, 1] }) as EngineLayer);
    engine.setLayers(both, 1);
    await engine.hash(0);
    await expect(engine.hash(1)).rejects.toMatchObject(OVER_BUDGET);
    await engine.closeTarget(0);
    await engine.idle();
    expect(await engine.hash(1)).toMatch(/^[0-9a-f]{16}$/);
    expect(codes).toEqual(["out-of-budget"]);
  });
});
