import { afterEach, describe, expect, it, vi } from "vitest";
import type { EngineLayer, TargetUpdate } from "../../web/engine/engine-api.ts";
import { OpenTarget } from "../../web/engine/open-target.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { dab, decal, FRONT, fill, group, stroke } from "../support/layers.ts";
import { buildGlb, cylinder, plane, sphere } from "../support/model-builder.ts";
import {
  allTexels,
  at,
  CHART,
  endHosts,
  LOGO,
  paintablePlane,
  SIZE,
  startHost,
  texturedPlane,
} from "../support/painted-plane.ts";
import { solidPng } from "../support/png-file.ts";

afterEach(() => {
  endHosts();
  vi.restoreAllMocks();
});

const RED = [255, 0, 0, 255] as const;

describe("updates", () => {
  it("report every texel of a new target first", async () => {
    const { engine, updates } = await paintablePlane();
    expect(updates).toHaveLength(1);
    expect(patched(new Uint8Array(SIZE * SIZE * 4), updates)).toEqual(await allTexels(engine));
  });

  it("show what takes many turns from the bottom up, in ever fewer pictures", async () => {
    const { engine, updates } = await paintablePlane();
    const before = await allTexels(engine);
    const rows = Array.from({ length: 24 }, (_, row) => 0.023 * (row - 12));
    const dabs = (y: number) => Array.from({ length: 1000 }, (_, i) => dab(-0.4 + 0.0008 * i, y, 0.02, 0.5));
    // Each look at the time finds the turn over.
    let now = 0;
    vi.spyOn(performance, "now").mockImplementation(() => (now += 1000));
    const turns = vi.spyOn(OpenTarget.prototype, "draw");
    updates.length = 0;
    engine.setLayers(
      rows.map((y, row) => stroke(`s${row}`, dabs(y))),
      1,
    );
    const after = await allTexels(engine);
    expect(patched(before, updates)).toEqual(after);
    const changed = updates.map((_, count) => {
      const known = patched(before, updates.slice(0, count + 1));
      return known.reduce((sum, value, place) => sum + (value === before[place] ? 0 : 1), 0);
    });
    expect(changed).toEqual(changed.toSorted((one, other) => one - other));
    expect(new Set(changed).size).toBeGreaterThan(2);
    expect(updates.length).toBeLessThanOrEqual(1 + Math.log2(turns.mock.calls.length));
    expect(updates.every(({ projectedTexels }) => projectedTexels > 0)).toBe(true);
    // Row 0 is the top one, and y grows upward.
    const topOf = (all: Uint8Array): number => all.findIndex((value, place) => value !== before[place]) / (SIZE * 4);
    expect(topOf(patched(before, updates.slice(0, 1)))).toBeGreaterThan(topOf(after) + 10);
  });

  it("cover exactly what changed, whatever is done to the layers", async () => {
    const { engine, updates } = await paintablePlane();
    let known = await allTexels(engine);
    const a = decal("a", "logo", at(-0.2, 0.1));
    const b = decal("b", "logo", { ...at(0, 0.05, 0.4), opacity: 0.5 });
    const steps: EngineLayer[][] = [
      [a],
      [a, b],
      [b, a],
      [b, decal("a", "logo", at(0.3, -0.2))],
      [{ ...b, visible: false }, a],
      [fill("f", [0, 0, 1, 0.5]), a],
      [a],
      [],
    ];
    for (const [revision, layers] of steps.entries()) {
      updates.length = 0;
      engine.setLayers(layers, revision);
      await engine.idle();
      const now = await allTexels(engine);
      expect(patched(known, updates)).toEqual(now);
      expect(updates.every((update) => update.revision === revision)).toBe(true);
      expect(touchesOnlyNear(known, now, updates)).toBe(true);
      known = now;
    }
    expect(known).toEqual((await decodePicture(CHART, "chart")).rgba);
  });

  it("report only where a moved decal was and is, and project that decal alone", async () => {
    const { engine, updates } = await paintablePlane();
    engine.setLayers([decal("a", "logo", at(-0.3, -0.3, 0.1)), decal("b", "logo", at(0.3, 0.3, 0.1))], 1);
    await engine.idle();
    updates.length = 0;
    engine.setLayers([decal("a", "logo", at(-0.25, -0.3, 0.1)), decal("b", "logo", at(0.3, 0.3, 0.1))], 2);
    await engine.idle();
    expect(updates).toHaveLength(1);
    expect(updates[0]).toMatchObject({ projectedLayers: 1, material: 0, revision: 2 });
    const area = (updates[0]?.rects ?? []).reduce((sum, rect) => sum + rect.width * rect.height, 0);
    expect(area).toBeLessThanOrEqual((SIZE * SIZE) / 4);
  });

  it("do not come when nothing changed", async () => {
    const { engine, updates } = await paintablePlane();
    const layers = [decal("a", "logo")];
    engine.setLayers(layers, 1);
    await engine.idle();
    const { projectionCount } = await engine.stats();
    updates.length = 0;
    engine.setLayers(structuredClone(layers), 2);
    await engine.idle();
    expect(updates).toHaveLength(0);
    expect((await engine.stats()).projectionCount).toBe(projectionCount);
  });

  it("show the newest list only, when several came at once", async () => {
    const { engine, updates } = await paintablePlane();
    updates.length = 0;
    for (let i = 1; i <= 20; i++) engine.setLayers([decal("a", "logo", at(i / 50, 0))], i);
    await engine.idle();
    expect(updates.map((update) => update.revision)).toEqual([20]);
  });

  it("go on for other targets while one is being baked", async () => {
    const engine = startHost();
    const meshes = [plane(1, 0), sphere(128, 64, 1)];
    await engine.loadModel({ name: "two.glb", bytes: buildGlb({ meshes, materials: [{}, {}] }) });
    await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
    await engine.openTarget({ material: 0, width: SIZE });
    await engine.idle();
    const events: string[] = [];
    engine.onUpdate((update) => events.push(`update of ${update.material}`));
    const opening = engine.openTarget({ material: 1, width: 2048 }, () => {
      if (events.length === 0) engine.setLayers([decal("a", "logo", { occlusion: "none" })], 1);
    });
    await opening.then(() => events.push("opened 1"));
    expect(events[0]).toBe("update of 0");
  });

  it("report the whole mip chain when asked, each level in place", async () => {
    const { engine, updates } = await paintablePlane();
    updates.length = 0;
    const info = await engine.openTarget({ material: 0, mipmaps: true });
    expect(info.mipLevels).toBe(7);
    await engine.idle();
    const last = updates.flatMap((update) => update.rects.filter((rect) => rect.level === 6));
    expect(last).toMatchObject([{ x: 0, y: 0, width: 1, height: 1 }]);
    const bytes = updates.reduce((sum, update) => sum + update.bytes.length, 0);
    expect(bytes).toBe(4 * ((4 ** 7 - 1) / 3));
  });

  it("no longer reach a listener that unsubscribed", async () => {
    const { engine } = await paintablePlane();
    let count = 0;
    const unsubscribe = engine.onUpdate(() => count++);
    engine.setLayers([fill("f", [1, 0, 0, 1])], 1);
    await engine.idle();
    unsubscribe();
    engine.setLayers([], 2);
    await engine.idle();
    expect(count).toBe(1);
  });
});

describe("layers", () => {
  it("wait for their picture and their target", async () => {
    const engine = startHost();
    engine.setLayers([decal("a", "late")], 7);
    await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
    await engine.openTarget({ material: 0 });
    const before = await engine.hash(0);
    await engine.setAsset("late", { name: "late.png", bytes: LOGO });
    const after = await engine.hash(0);
    expect(after).not.toBe(before);
    await engine.removeAsset("late");
    expect(await engine.hash(0)).toBe(before);
    await engine.setAsset("late", { name: "late.png", bytes: LOGO });
    expect(await engine.hash(0)).toBe(after);
  });

  it("follow their picture when it is replaced", async () => {
    const { engine } = await paintablePlane();
    engine.setLayers([decal("a", "logo", { filter: "nearest" })], 1);
    await engine.setAsset("logo", { name: "red.png", bytes: solidPng(1, 1, RED) });
    expect([...(await engine.readTexels(0, SIZE / 2, SIZE / 2, 1, 1))]).toEqual([...RED]);
  });

  it("are drawn in their order, and the top one wins", async () => {
    const { engine } = await paintablePlane();
    const red = fill("red", [1, 0, 0, 1]);
    const blue = fill("blue", [0, 0, 1, 1]);
    const colour = async (layers: EngineLayer[]): Promise<number[]> => {
      engine.setLayers(layers, 0);
      return [...(await engine.readTexels(0, 5, 5, 1, 1))];
    };
    expect(await colour([red, blue])).toEqual([0, 0, 255, 255]);
    expect(await colour([blue, red])).toEqual([255, 0, 0, 255]);
    expect(await colour([blue, { ...red, visible: false }])).toEqual([0, 0, 255, 255]);
  });

  it("belong to their material alone", async () => {
    const engine = startHost();
    const meshes = [plane(1, 0), { ...plane(1, 1), positions: plane().positions.map((p, i) => (i % 3 === 2 ? 3 : p)) }];
    await engine.loadModel({ name: "two.glb", bytes: buildGlb({ meshes, materials: [{}, {}] }) });
    await engine.openTarget({ material: 0, width: 8 });
    await engine.openTarget({ material: 1, width: 8 });
    engine.setLayers([fill("a", [1, 0, 0, 1], { material: 1 }), fill("b", [0, 1, 0, 1], { material: 5 })], 1);
    expect([...(await engine.readTexels(0, 0, 0, 1, 1))]).toEqual([255, 255, 255, 255]);
    expect([...(await engine.readTexels(1, 0, 0, 1, 1))]).toEqual([255, 0, 0, 255]);
  });

  it("that cannot be drawn are reported once, by id, and leave the others alone", async () => {
    const { engine } = await paintablePlane();
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    const bad = decal("bad", "logo", { projector: { ...FRONT, size: [0, 1, 1] } });
    engine.setLayers([bad, decal("good", "logo", at(0.1, 0.1))], 1);
    const withBad = await engine.hash(0);
    engine.setLayers([bad, decal("good", "logo", at(0.2, 0.1))], 2);
    await engine.idle();
    expect(errors).toEqual([expect.objectContaining({ code: "bad-argument", field: "layers[id=bad]" })]);
    engine.setLayers([decal("good", "logo", at(0.1, 0.1))], 3);
    expect(await engine.hash(0)).toBe(withBad);
    engine.setLayers([decal("bad", "logo")], 4);
    await engine.idle();
    engine.setLayers([bad], 5);
    await engine.idle();
    expect(errors).toHaveLength(2);
  });

  it("of parts that the model does not have are reported with the model, the part, its value and what to do", async () => {
    const { engine } = await paintablePlane();
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    engine.setLayers([fill("f", [1, 0, 0, 1], { parts: { kind: "faces", faces: [0, 99] } })], 1);
    await engine.idle();
    expect(errors).toEqual([
      expect.objectContaining({
        code: "bad-argument",
        subject: "plane.glb",
        field: "layers[id=f].parts.faces[1]",
        value: "99",
        hint: expect.stringContaining("choose its parts anew"),
        reason: "other-model",
      }),
    ]);
  });

  it("leave the base as it was once they are gone", async () => {
    const engine = startHost();
    const meshes = [cylinder(48, 0)];
    await engine.loadModel({ name: "mug.glb", bytes: buildGlb({ ...texturedPlane, meshes }) });
    await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
    await engine.openTarget({ material: 0 });
    const before = await allTexels(engine);
    const front = decal("a", "logo", { projector: { ...FRONT, position: [0, 0, 1], size: [1, 1, 1] } });
    engine.setLayers([front, { ...front, id: "b", lockAlpha: true, wrap: "repeat", flipX: true }], 1);
    expect(await allTexels(engine)).not.toEqual(before);
    engine.setLayers([], 2);
    expect(await allTexels(engine)).toEqual(before);
  });

  it("lie flat in the texture at the angle that many turns leave", async () => {
    const { engine } = await paintablePlane();
    const stamped = async (angle: number): Promise<string> => {
      engine.setLayers(
        [decal("a", "logo", { projector: { kind: "uv", center: [0.5, 0.5], size: [0.6, 0.4], angle } })],
        1,
      );
      return engine.hash(0);
    };
    const turned = await stamped(189);
    expect(await stamped(188)).not.toBe(turned);
    for (const turns of [342_935, 1, -1, -1_000_000]) expect(await stamped(189 + turns * 360)).toBe(turned);
    expect(await stamped(123_456_789)).toBe(turned);
  });

  it("give the same bytes whatever happened before", async () => {
    const layers = [
      fill("f", [0.2, 0.4, 0.6, 0.5]),
      decal("a", "logo", at(0.1, 0.2, 0.6)),
      decal("b", "logo", at(0, 0, 0.3)),
    ];
    const straight = await paintablePlane();
    straight.engine.setLayers(layers, 1);
    const { engine } = await paintablePlane();
    for (const detour of [[...layers].reverse(), [decal("b", "logo", at(0.4, 0.4))], layers.slice(1), layers]) {
      engine.setLayers(detour, 0);
      await engine.idle();
    }
    expect(await engine.hash(0)).toBe(await straight.engine.hash(0));
  });
});

describe("layers that only change places", () => {
  it("are not projected again: neither when their group goes, nor when they come into one, or lie in another order", async () => {
    const { engine } = await paintablePlane();
    const a = decal("a", "logo", at(-0.3, 0.1, 0.4));
    const b = stroke("b", [dab(0, 0), dab(0.2, 0)]);
    const c = decal("c", "logo", at(0.25, -0.2, 0.4));
    const isolated = { isolated: true } as const;
    const orders: EngineLayer[][] = [
      [a, b, c],
      [group("g", [a, b]), c],
      [group("h", [a, group("g", [b])]), c],
      [group("g", [group("h", [b, a], isolated), c])],
      [group("i", [c, b]), a],
      [c, group("j", [b], isolated), a],
      [group("j", [group("k", [b, c, a])])],
      [group("k", [c]), b, a],
      [b, a, c],
    ];
    engine.setLayers(orders[0] as EngineLayer[], 1);
    await engine.idle();
    const { projectionCount } = await engine.stats();
    const { engine: fresh } = await paintablePlane();
    for (const [step, layers] of orders.entries()) {
      engine.setLayers(layers, step + 2);
      fresh.setLayers([], 2 * step + 1);
      await fresh.idle();
      fresh.setLayers(structuredClone(layers), 2 * step + 2);
      expect(await engine.hash(0)).toBe(await fresh.hash(0));
      expect((await engine.stats()).projectionCount, `step ${step}`).toBe(projectionCount);
    }
  });

  it("may come into another group while what they held goes elsewhere, though with it they would lie too deep", async () => {
    const { engine } = await paintablePlane();
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    const nested = (names: readonly number[]): EngineLayer[] =>
      names.reduceRight<EngineLayer[]>((held, name) => [group(`g${name}`, held)], [decal("a", "logo")]);
    const clear = decal("clear", "logo", { opacity: 0 });
    const others = Array.from({ length: 14 }, (_, index) => index + 1);
    engine.setLayers(nested([0, ...others]), 1);
    const hash = await engine.hash(0);
    // Sixteen levels may be. The topmost group goes into two new ones, and those in it change places.
    engine.setLayers([group("new", [group("newer", [group("g0", [clear])])]), ...nested(others.toReversed())], 2);
    expect(await engine.hash(0)).toBe(hash);
    expect(errors).toEqual([]);
  });
});

describe("a step back and forth in a history", () => {
  const projections = async (engine: Awaited<ReturnType<typeof paintablePlane>>["engine"]) =>
    (await engine.stats()).projectionCount;

  it("projects nothing that was there before", async () => {
    const { engine } = await paintablePlane();
    const masked = decal("a", "logo", {
      ...at(0.1, 0.2, 0.6),
      mask: { layers: [stroke("m", [dab(0.1, 0.1)])], invert: false },
    });
    const full = [masked, group("g", [stroke("s", [dab(0, 0), dab(0.2, 0)]), decal("b", "logo", at(-0.2, 0))])];
    engine.setLayers(full, 1);
    const hash = await engine.hash(0);
    const before = await projections(engine);
    for (const less of [[masked], [full[1]], [], [group("g", [decal("b", "logo", at(-0.2, 0))])]]) {
      engine.setLayers(less as EngineLayer[], 2);
      expect(await engine.hash(0)).not.toBe(hash);
      engine.setLayers(full, 3);
      expect(await engine.hash(0)).toBe(hash);
    }
    expect(await projections(engine)).toBe(before);
  });

  it("finds the newest 256 layers that went, and makes the others anew", async () => {
    const { engine } = await paintablePlane();
    const all = Array.from({ length: 300 }, (_, i) => stroke(`s${i}`, [dab((i % 20) / 20 - 0.5, 0, 0.05)]));
    engine.setLayers(all, 1);
    const hash = await engine.hash(0);
    for (let left = all.length - 1; left >= 0; left--) {
      engine.setLayers(all.slice(0, left), 2);
      await engine.idle();
    }
    const before = await projections(engine);
    engine.setLayers(all, 3);
    expect(await engine.hash(0)).toBe(hash);
    expect((await projections(engine)) - before).toBe(300 - 256);
  });

  it("has no picture of a layer that went", async () => {
    const { engine } = await paintablePlane();
    engine.setLayers([stroke("s", [dab(0, 0)])], 1);
    expect(await engine.layerMiniature("s", "layer", 16)).not.toBeNull();
    engine.setLayers([], 2);
    expect(await engine.layerMiniature("s", "layer", 16)).toBeNull();
  });
});

/** What a receiver has after applying updates to the texels that it knew. */
function patched(known: Uint8Array, updates: readonly TargetUpdate[]): Uint8Array {
  const result = known.slice();
  for (const { rects, bytes } of updates) {
    for (const { x, y, width, height, level, byteOffset } of rects) {
      if (level !== 0) continue;
      for (let row = 0; row < height; row++) {
        const line = bytes.subarray(byteOffset + row * width * 4, byteOffset + (row + 1) * width * 4);
        result.set(line, ((y + row) * SIZE + x) * 4);
      }
    }
  }
  return result;
}

/** Whether no rectangle lies wholly where nothing changed, and none overlaps another. */
function touchesOnlyNear(before: Uint8Array, after: Uint8Array, updates: readonly TargetUpdate[]): boolean {
  const seen = new Set<number>();
  return updates.every(({ rects }) =>
    rects.every(({ x, y, width, height }) => {
      let changed = false;
      for (let row = y; row < y + height; row++) {
        for (let column = x; column < x + width; column++) {
          const texel = row * SIZE + column;
          if (seen.has(texel)) return false;
          seen.add(texel);
          for (let i = texel * 4; i < texel * 4 + 4; i++) changed ||= before[i] !== after[i];
        }
      }
      return changed;
    }),
  );
}
