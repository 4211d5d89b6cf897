import { afterEach, describe, expect, it, vi } from "vitest";
import { Target } from "../../web/core/target.ts";
import type { EngineDab, EnginePictureBrush } from "../../web/engine/engine-api.ts";
import { createEngineClient } from "../../web/engine/engine-client.ts";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import type { ClientMessage } from "../../web/engine/engine-protocol.ts";
import { dab, decal, fill, stroke } from "../support/layers.ts";
import { buildGlb } from "../support/model-builder.ts";
import { allTexels, at, endHosts, LOGO, paintablePlane, SIZE, texturedPlane } from "../support/painted-plane.ts";
import { ThreadWorker } from "../support/thread-worker.ts";

afterEach(() => {
  endHosts();
  vi.restoreAllMocks();
});

/** A row of dabs from left to right. */
const row = (count: number): EngineDab[] =>
  Array.from({ length: count }, (_, i) => dab(-0.4 + 0.04 * i, 0.1, 0.2, 0.5));
const middle = async (engine: { readTexels: Awaited<ReturnType<typeof paintablePlane>>["engine"]["readTexels"] }) => [
  ...(await engine.readTexels(0, SIZE / 2, SIZE / 2, 1, 1)),
];

describe("a stroke", () => {
  it("is painted with the round brush's colour, and its opacity counts once", async () => {
    const { engine } = await paintablePlane();
    const brush = { tip: "round", color: [1, 0, 0, 1], hardness: 1, flow: 1 } as const;
    engine.setLayers([fill("f", [1, 1, 1, 1]), stroke("s", [dab(0, 0), dab(0, 0)], { brush })], 1);
    expect(await middle(engine)).toEqual([255, 0, 0, 255]);
    engine.setLayers([fill("f", [1, 1, 1, 1]), stroke("s", [dab(0, 0), dab(0, 0)], { brush, opacity: 0.5 })], 2);
    expect(await middle(engine)).toEqual([255, 128, 128, 255]);
  });

  it("has as sharp a rim under a dab of a thousand texels as under a small one", async () => {
    const { engine } = await paintablePlane();
    const size = 1024;
    await engine.openTarget({ material: 0, width: size, height: size, base: [1, 1, 1, 1] });
    for (const across of [60, 500, 970]) {
      engine.setLayers([stroke("s", [dab(0, 0, across / size)])], across);
      const texels = await engine.readTexels(0, 0, 0, size, size);
      const red = texels.filter((_, at) => at % 4 === 0);
      // A band of three texels or less along the rim.
      expect(red.filter((value) => value !== 0 && value !== 255).length).toBeLessThan(3 * Math.PI * across);
      expect(red.filter((value) => value === 0).length).toBeGreaterThan(Math.PI * (across / 2 - 2) ** 2);
    }
  });

  it.each([
    [0, 6],
    [0, 40],
    [0.5, 6],
    [0.5, 12],
    [0.9, 9],
    [0.9, 20],
    [1, 12],
    [1, 20],
    [1, 40],
    [1, 100],
  ])(
    "of a round dab of hardness %d, %d texels wide, is the disc that the design's page tells, to 40 dB",
    async (hardness, across) => {
      const { engine } = await paintablePlane();
      const size = 128;
      await engine.openTarget({ material: 0, width: size, height: size, base: [1, 1, 1, 1] });
      const brush = { tip: "round", color: [0, 0, 0, 1], hardness, flow: 1 } as const;
      const [x, y] = [0.013, -0.021];
      engine.setLayers([stroke("s", [dab(x, y, across / size)], { brush })], 1);
      const texels = await engine.readTexels(0, 0, 0, size, size);
      const alphaAt = (radius: number): number => {
        if (radius >= 1 || radius <= hardness) return radius <= hardness ? 1 : 0;
        const t = (radius - hardness) / (1 - hardness);
        return 1 - t * t * (3 - 2 * t);
      };
      const samples = 16;
      let squares = 0;
      let painted = 0;
      for (let texel = 0; texel < size * size; texel++) {
        let sum = 0;
        for (let sample = 0; sample < samples * samples; sample++) {
          const u = ((texel % size) + ((sample % samples) + 0.5) / samples) / size;
          const v = (Math.floor(texel / size) + (Math.floor(sample / samples) + 0.5) / samples) / size;
          sum += alphaAt((Math.hypot(u - 0.5 - x, 0.5 - v - y) * 2 * size) / across);
        }
        const expected = 255 * (1 - sum / (samples * samples));
        const actual = texels[texel * 4] ?? 0;
        if (expected > 254.5 && actual === 255) continue;
        painted++;
        squares += (actual - expected) ** 2;
      }
      expect(10 * Math.log10((255 * 255 * painted) / squares)).toBeGreaterThan(40);
    },
  );

  it("of one picture dab is the decal of that picture", async () => {
    const { engine } = await paintablePlane();
    engine.setLayers([decal("a", "logo", at(0.1, 0.2, 0.5))], 1);
    const expected = await engine.hash(0);
    const brush: EnginePictureBrush = { tip: "picture", asset: "logo", color: null, flow: 1 };
    engine.setLayers([stroke("a", [dab(0.1, 0.2, 0.5)], { brush })], 2);
    expect(await engine.hash(0)).toBe(expected);
    engine.setLayers([stroke("a", [dab(0.1, 0.2, 0.5)], { brush: { ...brush, color: [0, 0, 1, 1] } })], 3);
    expect(await engine.hash(0)).not.toBe(expected);
    engine.setLayers([decal("a", "logo", at(0.1, 0.2, 0.5))], 4);
    expect(await engine.hash(0)).toBe(expected);
  });

  it("of many dabs is painted in turns, in which the engine goes on with other things, and ends as in one", async () => {
    const dabs = Array.from({ length: 1000 }, (_, i) => dab(-0.4 + 0.0008 * i, 0.1, 0.02, 0.5));
    const whole = await paintablePlane();
    whole.engine.setLayers([stroke("s", dabs)], 1);
    const expected = await whole.engine.hash(0);
    const { engine } = await paintablePlane();
    // Each look at the time finds the turn over.
    let now = 0;
    vi.spyOn(performance, "now").mockImplementation(() => (now += 1000));
    let turn = 0;
    const count = (): void => void (++turn < 100 && setImmediate(count));
    setImmediate(count);
    const update = Target.prototype.update;
    const turns = new Set<number>();
    vi.spyOn(Target.prototype, "update").mockImplementation(function (this: Target, ...args) {
      turns.add(turn);
      return update.apply(this, args);
    });
    engine.setLayers([stroke("s", dabs)], 1);
    expect(await engine.hash(0)).toBe(expected);
    expect(turns.size).toBeGreaterThan(1);
  });

  it("waits for its picture", async () => {
    const { engine } = await paintablePlane();
    const before = await engine.hash(0);
    engine.setLayers([stroke("s", [dab(0, 0)], { brush: { tip: "picture", asset: "late", color: null, flow: 1 } })], 1);
    expect(await engine.hash(0)).toBe(before);
    await engine.setAsset("late", { name: "late.png", bytes: LOGO });
    expect(await engine.hash(0)).not.toBe(before);
  });

  it("that grows tells the core its new dabs alone, and only their tiles change", async () => {
    const { engine, updates } = await paintablePlane();
    const dabs = row(12);
    engine.setLayers([stroke("s", dabs.slice(0, 6))], 1);
    await engine.idle();
    const added = vi.spyOn(Target.prototype, "addDabs");
    const cleared = vi.spyOn(Target.prototype, "clearDabs");
    updates.length = 0;
    engine.setLayers([stroke("s", dabs.slice(0, 7))], 2);
    await engine.idle();
    // The same numbers in other objects are the same dabs.
    engine.setLayers([structuredClone(stroke("s", dabs))], 3);
    await engine.idle();
    expect(added.mock.calls.map(([, list]) => list.length)).toEqual([1, 5]);
    expect(cleared).not.toHaveBeenCalled();
    expect(updates[0]?.projectedTexels).toBeLessThan(15 * 15);
    expect(updates[0]?.compositedTexels).toBeLessThanOrEqual(4 * 256);
    const grown = await engine.hash(0);
    const whole = await paintablePlane();
    whole.engine.setLayers([stroke("s", dabs)], 1);
    expect(await whole.engine.hash(0)).toBe(grown);
  });

  it("that loses or changes a dab begins anew", async () => {
    const { engine } = await paintablePlane();
    const dabs = row(6);
    const seen: string[] = [];
    for (const list of [dabs, dabs.slice(0, 5), [dab(0, 0), ...dabs.slice(1)], [], dabs]) {
      engine.setLayers([stroke("s", list)], 1);
      seen.push(await engine.hash(0));
      const fresh = await paintablePlane();
      fresh.engine.setLayers([stroke("s", list)], 1);
      expect(await fresh.engine.hash(0)).toBe(seen.at(-1));
    }
    expect(new Set(seen).size).toBe(4);
  });

  it("with a dab that cannot be painted is reported once by its layer, and comes back when it is mended", async () => {
    const { engine } = await paintablePlane();
    const before = await allTexels(engine);
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    const dabs = row(3);
    const bad = { ...dab(0, 0), flow: 2 };
    engine.setLayers([stroke("s", dabs)], 1);
    const good = await engine.hash(0);
    for (let i = 0; i < 3; i++) {
      engine.setLayers([stroke("s", [...dabs, bad])], 2 + i);
      await engine.idle();
    }
    expect(errors).toEqual([expect.objectContaining({ code: "bad-argument", field: "layers[id=s]" })]);
    expect(errors[0]?.message).toContain("dabs[0]: flow is 2");
    expect(await allTexels(engine)).toEqual(before);
    engine.setLayers([stroke("s", dabs)], 9);
    expect(await engine.hash(0)).toBe(good);
  });
});

describe("a stroke on its way to the worker", () => {
  async function startClient() {
    const workers: ThreadWorker[] = [];
    const engine = createEngineClient({
      createWorker: () => {
        workers.push(new ThreadWorker());
        return workers.at(-1) as unknown as Worker;
      },
    });
    await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
    await engine.openTarget({ material: 0 });
    await engine.idle();
    return { engine, workers };
  }

  const sentDabs = (messages: readonly ClientMessage[] = []) =>
    messages.flatMap((message) =>
      message.type === "layers"
        ? message.layers.flatMap((layer) =>
            layer.type === "stroke" ? [[layer.dabs.kept, layer.dabs.added.length]] : [],
          )
        : [],
    );

  it("takes its new dabs alone, and is painted as in this thread", async () => {
    const { engine, workers } = await startClient();
    const host = createEngineHost();
    await host.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
    await host.openTarget({ material: 0 });
    const dabs = row(10);
    for (const [revision, count] of [4, 5, 10, 10, 3].entries()) {
      const layers = [fill("f", [1, 1, 1, 0.5]), stroke("s", dabs.slice(0, count))];
      engine.setLayers(layers, revision);
      host.setLayers(layers, revision);
      expect(await engine.hash(0)).toBe(await host.hash(0));
    }
    expect(sentDabs(workers[0]?.received)).toEqual([
      [0, 4],
      [4, 1],
      [5, 5],
      [10, 0],
      [3, 0],
    ]);
    host.dispose();
    engine.dispose();
  });

  it("is told whole to a worker that replaces another", async () => {
    const { engine, workers } = await startClient();
    const dabs = row(10);
    engine.setLayers([stroke("s", dabs)], 1);
    const before = await engine.hash(0);
    engine.onError(() => undefined);
    workers[0]?.fail("out of memory");
    expect(await engine.hash(0)).toBe(before);
    expect(sentDabs(workers[1]?.received)).toEqual([[0, 10]]);
    engine.dispose();
  });
});
