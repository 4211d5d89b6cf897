import { afterEach, describe, expect, it, vi } from "vitest";
import type { EngineLayer } from "../../web/engine/engine-api.ts";
import { decal, fill, group } from "../support/layers.ts";
import { allTexels, at, endHosts, paintablePlane } from "../support/painted-plane.ts";

afterEach(endHosts);

const below = Array.from({ length: 8 }, (_, i) => fill(`fill-${i}`, [i / 8, 0.5, 1 - i / 8, 0.5]));
const many: EngineLayer[] = [...below, decal("top", "logo")];

/** The plane with many layers, and what the engine holds then. */
async function stacked(layers = many) {
  const { engine, updates } = await paintablePlane();
  engine.setLayers(layers, 1);
  await engine.idle();
  const used = async (): Promise<number> => (await engine.stats()).memoryUsedBytes;
  return { engine, updates, used, before: await used() };
}

describe("a change that is expected", () => {
  it("has what lies below its layer held ready, which changes no texel and reports nothing", async () => {
    const { engine, updates, used, before } = await stacked();
    const texels = await allTexels(engine);
    const reported = updates.length;
    engine.expect({ id: "top", inside: false });
    await vi.waitFor(async () => expect(await used()).toBeGreaterThan(before));
    expect(await allTexels(engine)).toEqual(texels);
    expect(updates).toHaveLength(reported);
  });

  it("comes out as it does without having been expected", async () => {
    const { engine, used, before } = await stacked();
    engine.expect({ id: "top", inside: false });
    await vi.waitFor(async () => expect(await used()).toBeGreaterThan(before));
    const moved = [...below, decal("top", "logo", at(0.2, 0.1))];
    engine.setLayers(moved, 2);
    const { engine: other } = await stacked(moved);
    expect(await allTexels(engine)).toEqual(await allTexels(other));
  });

  it("may be what comes on top in a group, or changes the group's mask", async () => {
    const inside = [group("group", many, { isolated: true })];
    const { engine, used, before } = await stacked(inside);
    engine.expect({ id: "group", inside: true });
    await vi.waitFor(async () => expect(await used()).toBeGreaterThan(before));
    const added = [group("group", [...many, decal("new", "logo", at(-0.2, 0.1))], { isolated: true })];
    engine.setLayers(added, 2);
    const { engine: other } = await stacked(added);
    expect(await allTexels(engine)).toEqual(await allTexels(other));
  });

  it("of a layer or a target that is gone, or of none, asks for nothing", async () => {
    const { engine, used, before } = await stacked();
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    for (const change of [{ id: "nobody", inside: false }, { id: "top", inside: true }, null]) engine.expect(change);
    await engine.idle();
    expect(await used()).toBe(before);
    engine.expect({ id: "top", inside: false });
    await engine.closeTarget(0);
    await vi.waitFor(async () => expect(await used()).toBeLessThan(before));
    expect(errors).toEqual([]);
  });
});
