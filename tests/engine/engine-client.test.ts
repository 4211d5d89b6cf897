import { afterEach, describe, expect, it, onTestFinished, vi } from "vitest";
import type { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { Engine, EngineLayer, TargetUpdate } from "../../web/engine/engine-api.ts";
import { createEngineClient } from "../../web/engine/engine-client.ts";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { decal, FRONT, fill, group } from "../support/layers.ts";
import { buildGlb, plane, sphere } from "../support/model-builder.ts";
import { paintPng, solidPng } from "../support/png-file.ts";
import { ThreadWorker } from "../support/thread-worker.ts";
import { zones } from "../support/zones.ts";

const SIZE = 64;
const LOGO = paintPng(16, 16, (x, y) => [255 - x, y * 9, 40, 200]);
const MODEL = buildGlb({ meshes: [plane(1, 0)], materials: [{}] });

let client: Engine | null = null;
afterEach(() => client?.dispose());

/** A client whose workers the test can look at; the newest is the last. */
function start(makeWorker: (index: number) => ThreadWorker = () => new ThreadWorker()): {
  engine: Engine;
  workers: ThreadWorker[];
} {
  const workers: ThreadWorker[] = [];
  const engine = createEngineClient({
    createWorker: () => {
      const worker = makeWorker(workers.length);
      workers.push(worker);
      return worker as unknown as Worker;
    },
  });
  client = engine;
  return { engine, workers };
}

async function openPlane(engine: Engine): Promise<void> {
  await engine.loadModel({ name: "plane.glb", bytes: MODEL });
  await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
  await engine.openTarget({ material: 0, width: SIZE });
}

describe("the engine's client", () => {
  it("tells what is no layer and no text by its field, as the engine in its own thread does, and goes on", async () => {
    const { engine } = start();
    const good = decal("decal", "logo");
    const unusable: [unknown, string, string][] = [
      [null, "layers", "null"],
      [[good, null], "layers[1]", "null"],
      [[{ ...good, opacity: "most" }], "layers[0].opacity", "most"],
      [[{ ...good, mask: {} }], "layers[0].mask.layers", "undefined"],
      [[{ ...good, projector: { ...FRONT, position: [1, 2] } }], "layers[0].projector.position", "[1, 2]"],
      [[{ ...good, type: "group", layers: [null] }], "layers[0].layers[0]", "null"],
      [[{ ...good, type: "stroke" }], "layers[0].brush", "undefined"],
      [[{ ...good, type: "sticker" }], "layers[0].type", "sticker"],
      [[{ ...good, blend: "soft" }], "layers[0].blend", "soft"],
      [[good, { ...good }], "layers[1].id", "decal"],
      [[{ ...good, id: "other", mask: { layers: [good] } }, good], "layers[1].id", "decal"],
      [[{ ...good, id: undefined }], "layers[0].id", "undefined"],
      [[good, { ...good, id: "" }], "layers[1].id", ""],
      [[{ ...good, opacity: () => 1 }], "layers[0].opacity", expect.stringMatching(/undefined|=>/)],
      [[{ ...good, occlusion: "auto" }], "layers[0].occlusion", "auto"],
      [[{ ...good, projector: { ...FRONT, kind: "flat" } }], "layers[0].projector.kind", "flat"],
    ];
    const words = { text: "Moin", font: "texelcast:fonts/inter-700", fontSize: 1, letterSpacing: 0, align: "left" };
    const text = { ...words, curve: 0, color: [0, 0, 0, 1], outline: null };
    for (const each of [engine, createEngineHost()]) {
      await openPlane(each);
      each.setLayers([good], 1);
      const painted = await each.hash(0);
      for (const [layers, field, value] of unusable) {
        each.setLayers(layers as never, 2);
        await expect(each.idle()).rejects.toMatchObject({ code: "bad-argument", field, value });
        each.setLayers([good], 3);
        expect(await each.hash(0)).toBe(painted);
      }
      const unreadable: [unknown, string, string][] = [
        [null, "text", "null"],
        [{ ...text, text: 5 }, "text.text", "5"],
        [{ ...text, fontSize: 0 }, "text.fontSize", "0"],
        [{ ...text, outline: { width: 1 } }, "text.outline.color", "undefined"],
      ];
      for (const [look, field, value] of unreadable) {
        const measured = each.measureText(look as never);
        await expect(measured).rejects.toMatchObject({ code: "bad-argument", field, value });
      }
      expect(await each.measureText(text as never)).toMatchObject({ missing: [] });
    }
  });

  it("draws layers that hold functions or are a framework's proxies as plain ones, and those that come after them", async () => {
    const { engine } = start();
    await openPlane(engine);
    const good = decal("decal", "logo");
    engine.setLayers([good], 1);
    const painted = await engine.hash(0);
    for (const odd of [{ ...good, onPick: () => 1 }, new Proxy(good, {})]) {
      engine.setLayers([], 2);
      expect(await engine.hash(0)).not.toBe(painted);
      engine.setLayers([odd, fill("below", [0, 0, 1, 0])], 3);
      expect(await engine.hash(0)).toBe(painted);
      engine.setLayers([good], 4);
      expect(await engine.hash(0)).toBe(painted);
    }
  });

  it("refuses layers that hold themselves and functions besides, and draws those that come after them", async () => {
    const { engine } = start();
    await openPlane(engine);
    const good = decal("decal", "logo");
    engine.setLayers([good], 1);
    const painted = await engine.hash(0);
    const self: EngineLayer[] = [];
    self.push(group("round", self));
    const tied: Record<string, unknown> = { ...good, onPick: () => 1 };
    tied.owner = tied;
    for (const odd of [self, [tied as never]]) {
      engine.setLayers(odd, 2);
      await expect(engine.hash(0)).rejects.toMatchObject({
        name: "TexelcastError",
        code: "bad-argument",
        field: "layers",
      });
      engine.setLayers([good], 3);
      expect(await engine.hash(0)).toBe(painted);
    }
  });

  it("refuses a call that no worker can be sent, and goes on", async () => {
    const { engine } = start();
    await openPlane(engine);
    const refused = (field: string) => ({ name: "TexelcastError", code: "bad-argument", field });
    await expect(engine.setZones(new Proxy(zones(), {}))).rejects.toMatchObject(refused("setZones"));
    await expect(engine.openTarget({ material: 0, base: (() => 1) as never })).rejects.toMatchObject(
      refused("openTarget"),
    );
    await expect(engine.idle()).resolves.toBeUndefined();
  });

  it("refuses what is no file by its field, as the engine in its own thread does, and goes on", async () => {
    const { engine } = start();
    const unusable: [unknown, string, string][] = [
      [undefined, "name", "[object Undefined]"],
      [{ bytes: MODEL }, "name", "[object Undefined]"],
      [{ name: "plane.glb" }, "bytes", "[object Undefined]"],
      [{ name: "plane.glb", bytes: MODEL.slice().buffer }, "bytes", "[object ArrayBuffer]"],
      [{ name: "plane.glb", bytes: "glTF" }, "bytes", "[object String]"],
    ];
    for (const each of [engine, createEngineHost()]) {
      for (const [file, field, value] of unusable) {
        const refused = { code: "bad-argument", field, value };
        await expect(each.loadModel(file as never)).rejects.toMatchObject(refused);
        await expect(each.setAsset("logo", file as never)).rejects.toMatchObject(refused);
        await expect(each.setFont("font", file as never)).rejects.toMatchObject(refused);
      }
      await openPlane(each);
    }
  });

  it("gives the same results as the engine in its own thread", async () => {
    const { engine } = start();
    const host = createEngineHost();
    for (const each of [engine, host]) {
      await openPlane(each);
      each.setLayers([fill("f", [0, 0, 1, 0.25]), decal("d", "logo")], 1);
    }
    expect(await engine.hash(0)).toBe(await host.hash(0));
    expect(await engine.readTexels(0, 8, 8, 4, 4)).toEqual(await host.readTexels(0, 8, 8, 4, 4));
    expect(await engine.viewMap(0, "positions")).toEqual(await host.viewMap(0, "positions"));
    expect(await engine.uvTriangles(0)).toEqual(await host.uvTriangles(0));
    expect(await engine.exportPng(0)).toEqual(await host.exportPng(0));
    expect(await engine.exportGlb()).toEqual(await host.exportGlb());
    expect((await engine.stats()).bakeCount).toBe(1);
    for (const each of [engine, host]) await each.setZones(zones());
    expect(await engine.hash(0)).toBe(await host.hash(0));
    expect(await engine.printReport()).toEqual(await host.printReport());
    expect(await engine.printMap(0, "dpi")).toEqual(await host.printMap(0, "dpi"));
    const shares: number[] = [];
    const print = await engine.exportPrint({ size: 100, zone: "left" }, (share) => shares.push(share));
    expect(print).toEqual(await host.exportPrint({ size: 100, zone: "left" }));
    expect(shares.at(-1)).toBe(1);
    host.dispose();
  });

  it("leaves the caller's buffers alone", async () => {
    const { engine } = start();
    const model = MODEL.slice();
    const logo = LOGO.slice();
    const base = { name: "base.png", bytes: solidPng(2, 2, [1, 2, 3, 255]) };
    const resources = new Map([["unused.bin", new Uint8Array(4)]]);
    await engine.loadModel({ name: "plane.glb", bytes: model, resources });
    await engine.setAsset("logo", { name: "logo.png", bytes: logo });
    await engine.openTarget({ material: 0, base });
    expect(model).toEqual(MODEL);
    expect(logo).toEqual(LOGO);
    expect(base.bytes.length).toBeGreaterThan(0);
    expect(resources.get("unused.bin")).toHaveLength(4);
  });

  it("sends no more of a large buffer than the part that is meant", async () => {
    const { engine, workers } = start();
    const large = new Uint8Array(1 << 20);
    large.set(MODEL, 5000);
    await engine.loadModel({ name: "part.glb", bytes: large.subarray(5000, 5000 + MODEL.length) });
    const call = workers[0]?.received.find((message) => message.type === "call");
    expect(call).toMatchObject({ call: { name: "loadModel" } });
    const [source] = (call as { call: { args: [{ bytes: Uint8Array }] } }).call.args;
    expect(source.bytes.buffer.byteLength).toBe(MODEL.length);
  });

  it("brings errors across whole", async () => {
    const { engine } = start();
    const attempt = engine.setAsset("logo", { name: "logo.txt", bytes: new TextEncoder().encode("text") });
    await expect(attempt).rejects.toMatchObject({ code: "bad-picture", subject: "logo.txt", hint: /PNG/ });
    await expect(engine.openTarget({ material: 0 })).rejects.toMatchObject({
      code: "no-model",
      name: "TexelcastError",
    });
  });

  it("reports a bake's progress, and cancels it", async () => {
    const { engine } = start();
    await engine.loadModel({ name: "ball.glb", bytes: buildGlb({ meshes: [sphere(96, 48)] }) });
    const shares: number[] = [];
    await engine.openTarget({ material: 0, width: 512 }, (share) => shares.push(share));
    expect(shares.at(-1)).toBe(1);
    const before = await engine.hash(0);
    const cancel = new AbortController();
    const opening = engine.openTarget({ material: 0, width: 4096 }, () => cancel.abort(), cancel.signal);
    await expect(opening).rejects.toMatchObject({ code: "cancelled", name: "AbortError" });
    await expect(engine.openTarget({ material: 0 }, undefined, AbortSignal.abort())).rejects.toMatchObject({
      code: "cancelled",
    });
    expect(await engine.hash(0)).toBe(before);
  });

  it("sends one list of layers at a time, and then the newest", async () => {
    const { engine, workers } = start();
    await openPlane(engine);
    const updates: TargetUpdate[] = [];
    engine.onUpdate((update) => updates.push(update));
    for (let i = 1; i <= 50; i++)
      engine.setLayers([decal("d", "logo", { projector: { ...FRONT, position: [i / 100, 0, 0] } })], i);
    const sent = workers[0]?.received.filter(({ type }) => type === "layers");
    expect(sent).toHaveLength(1);
    await engine.idle();
    expect(workers[0]?.received.filter(({ type }) => type === "layers").length).toBeLessThanOrEqual(2);
    expect(updates.at(-1)?.revision).toBe(50);
  });

  it("has a call see the layers that were set before it, even those that wait", async () => {
    const { engine } = start();
    await openPlane(engine);
    engine.setLayers([fill("f", [1, 0, 0, 1])], 1);
    engine.setLayers([fill("f", [0, 1, 0, 1])], 2);
    expect([...(await engine.readTexels(0, 0, 0, 1, 1))]).toEqual([0, 255, 0, 255]);
  });

  it("has reported every update when idle resolves, with bytes that belong to the receiver", async () => {
    const { engine } = start();
    const updates: TargetUpdate[] = [];
    engine.onUpdate((update) => updates.push(update));
    await openPlane(engine);
    await engine.idle();
    expect(updates).toHaveLength(1);
    updates[0]?.bytes.fill(7);
    expect([...(await engine.readTexels(0, 0, 0, 1, 1))]).toEqual([255, 255, 255, 255]);
  });

  it("reports a layer that cannot be drawn", async () => {
    const { engine } = start();
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    await openPlane(engine);
    engine.setLayers([decal("bad", "logo", { opacity: 2 })], 1);
    await engine.idle();
    expect(errors).toEqual([expect.objectContaining({ code: "bad-argument", field: "layers[id=bad]" })]);
  });

  it("rejects everything once it was ended", async () => {
    const { engine, workers } = start();
    const waiting = engine.stats();
    engine.dispose();
    await expect(waiting).rejects.toMatchObject({ code: "disposed" });
    await expect(engine.loadModel({ name: "m.glb", bytes: MODEL })).rejects.toMatchObject({ code: "disposed" });
    expect(workers[0]?.terminated).toBe(true);
    engine.setLayers([], 1);
    engine.dispose();
  });
});

describe("a worker that crashes", () => {
  it("is replaced, and the new one is told everything and asked again what was not answered", async () => {
    const { engine, workers } = start();
    await openPlane(engine);
    await engine.setAsset("gone", { name: "gone.png", bytes: LOGO });
    await engine.removeAsset("gone");
    await engine.setZones(zones());
    engine.setLayers([decal("d", "logo"), decal("e", "gone")], 4);
    const before = await engine.hash(0);
    const picture = await engine.exportPng(0);
    const errors: TexelcastError[] = [];
    const updates: TargetUpdate[] = [];
    engine.onError((error) => errors.push(error as TexelcastError));
    engine.onUpdate((update) => updates.push(update));

    const waiting = engine.exportPng(0);
    workers[0]?.fail("out of memory");
    expect(await waiting).toEqual(picture);
    expect(errors).toMatchObject([{ code: "engine-crashed", message: "The engine crashed: out of memory." }]);
    expect(workers).toHaveLength(2);
    expect(workers[0]?.terminated).toBe(true);
    expect(await engine.hash(0)).toBe(before);
    expect(updates.at(-1)?.revision).toBe(4);
    const texels = updates[0]?.rects.reduce((sum, rect) => sum + rect.width * rect.height, 0);
    expect(texels).toBe(SIZE * SIZE);
    expect(errors).toHaveLength(1);
  });

  it("takes with it a call that was under way in two crashes, and no other", async () => {
    const { engine, workers } = start();
    await openPlane(engine);
    const before = await engine.hash(0);
    const deadly = engine.exportGlb();
    workers[0]?.fail("once");
    const [harmless] = [engine.stats()];
    workers[1]?.fail("twice");
    await expect(deadly).rejects.toMatchObject({ code: "engine-crashed", message: /twice/ });
    expect((await harmless).bakeCount).toBe(1);
    expect(await engine.hash(0)).toBe(before);
  });

  it("that never begins, as its page's policy forbids it, is told once: by what waits for it", async () => {
    const { engine, workers } = start(() => new ThreadWorker(false));
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    const opening = openPlane(engine);
    for (let i = 0; i < 2; i++) workers.at(-1)?.fail("");
    await expect(opening).rejects.toMatchObject({
      code: "engine-crashed",
      message: expect.stringContaining("worker-src"),
    });
    expect(errors).toEqual([]);
    workers.at(-1)?.fail("");
    expect(errors).toMatchObject([{ code: "engine-halted" }]);
  });

  it("in whose place none gets what it needs is told once, and replaced as soon as there is something else to draw", async () => {
    const { engine, workers } = start();
    await openPlane(engine);
    const layers = [decal("d", "logo")];
    engine.setLayers(layers, 1);
    const before = await engine.hash(0);
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    workers[0]?.fail("gone");
    const worker = workers[1];
    const answer = worker?.onmessage;
    const error = {
      code: "missing-file",
      message: "The engine's WebAssembly could not be read.",
      reason: "not-loaded",
    };
    for (const { type, id } of (worker?.received ?? []) as { type: string; id: number }[]) {
      if (type === "call") answer?.({ data: { type: "failure", id, error } } as MessageEvent);
    }
    await expect(engine.stats()).rejects.toMatchObject({ code: "missing-file" });
    expect(errors.map((each) => (each as TexelcastError).code)).toEqual(["engine-crashed", "missing-file"]);
    engine.setLayers([...layers], 2);
    expect(workers).toHaveLength(3);
    expect(await engine.hash(0)).toBe(before);
    expect(errors).toHaveLength(2);
  });

  it("brings over a model that was being opened when it crashed, and a wish that was cancelled is over", async () => {
    const { engine, workers } = start();
    const opening = openPlane(engine);
    workers[0]?.fail("early");
    await opening;
    expect(await engine.hash(0)).toMatch(/^[0-9a-f]{16}$/);
    const cancel = new AbortController();
    const bake = engine.openTarget({ material: 0, width: 2048 }, undefined, cancel.signal);
    cancel.abort();
    workers[1]?.fail("again");
    await expect(bake).rejects.toMatchObject({ code: "cancelled" });
  });

  it("counts as crashed when the core inside it trapped", async () => {
    const { engine, workers } = start();
    await openPlane(engine);
    const worker = workers[0];
    const answer = worker?.onmessage;
    const stats = engine.stats();
    const id = worker?.received.at(-1);
    const error = { code: "engine-crashed", message: "The engine crashed: unreachable." };
    answer?.({ data: { type: "failure", id: (id as { id: number }).id, error } } as MessageEvent);
    expect((await stats).bakeCount).toBe(1);
    expect(workers).toHaveLength(2);
    expect(await engine.hash(0)).toMatch(/^[0-9a-f]{16}$/);
  });

  it("does not bring back what failed before, or what was closed", async () => {
    const { engine, workers } = start();
    await openPlane(engine);
    await engine.openTarget({ material: 0, width: 9000 }).catch(() => undefined);
    await engine.closeTarget(0);
    workers[0]?.fail("gone");
    await engine.idle();
    const calls = (workers[1]?.received ?? []).flatMap((message) =>
      message.type === "call" ? [message.call.name] : [],
    );
    // One idle is the client's own, to know when everything is drawn again.
    expect(calls).toEqual(["loadModel", "setAsset", "idle", "idle"]);
  });

  it("is not replaced after three crashes in a row, which every call says until there is something else to draw", async () => {
    let broken = true;
    const { engine, workers } = start(() => new ThreadWorker(!broken));
    broken = false;
    const errors: TexelcastError[] = [];
    engine.onError((error) => errors.push(error as TexelcastError));
    workers[0]?.fail("at the start");
    await openPlane(engine);
    const layers = [decal("d", "logo")];
    engine.setLayers(layers, 1);
    const before = await engine.hash(0);
    broken = true;
    engine.setLayers([fill("deadly", [1, 0, 0, 1])], 2);
    for (let i = 0; i < 3; i++) workers.at(-1)?.fail("again");
    expect(workers).toHaveLength(4);
    expect(errors.map(({ code }) => code)).toEqual([
      "engine-crashed",
      "engine-crashed",
      "engine-crashed",
      "engine-halted",
    ]);
    await expect(engine.stats()).rejects.toMatchObject({ code: "engine-halted", hint: /Undo/ });
    broken = false;
    engine.setLayers(layers, 3);
    expect(workers).toHaveLength(5);
    expect(await engine.hash(0)).toBe(before);
  });

  it("can be cured by another model", async () => {
    let broken = false;
    const { engine, workers } = start(() => new ThreadWorker(!broken));
    await openPlane(engine);
    broken = true;
    for (let i = 0; i < 3; i++) workers.at(-1)?.fail("again");
    broken = false;
    await openPlane(engine);
    expect(await engine.hash(0)).toMatch(/^[0-9a-f]{16}$/);
  });

  it("leaves the model that it had where the other one that shall cure it cannot be loaded", async () => {
    let broken = false;
    const { engine, workers } = start(() => new ThreadWorker(!broken));
    await openPlane(engine);
    engine.setLayers([decal("d", "logo")], 1);
    const before = await engine.hash(0);
    broken = true;
    for (let i = 0; i < 3; i++) workers.at(-1)?.fail("again");
    broken = false;
    const other = engine.loadModel({ name: "broken.glb", bytes: new TextEncoder().encode("glTF?") });
    await expect(other).rejects.toMatchObject({ code: "bad-container" });
    expect(await engine.hash(0)).toBe(before);
    workers.at(-1)?.fail("once more");
    expect(await engine.hash(0)).toBe(before);
  });

  it("says no more once it was replaced", async () => {
    const { engine, workers } = start();
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    const first = workers[0];
    first?.fail("once");
    first?.fail("twice");
    await engine.idle();
    expect(errors).toHaveLength(1);
    expect(workers).toHaveLength(2);
  });
});

describe("a worker that is gone without a word", () => {
  it("is missed when it does not answer, and nothing is lost", async () => {
    vi.useFakeTimers({ toFake: ["setInterval", "clearInterval", "performance"] });
    onTestFinished(() => {
      vi.useRealTimers();
    });
    const { engine, workers } = start();
    await openPlane(engine);
    engine.setLayers([decal("d", "logo")], 1);
    const before = await engine.hash(0);
    const errors: TexelcastError[] = [];
    engine.onError((error) => errors.push(error as TexelcastError));
    workers[0]?.silence();
    const waiting = engine.hash(0);
    vi.advanceTimersByTime(15_000);
    expect(workers).toHaveLength(1);
    vi.advanceTimersByTime(15_000);
    expect(workers).toHaveLength(2);
    expect(await waiting).toBe(before);
    expect(errors).toMatchObject([{ code: "engine-crashed", message: /did not answer/ }]);
  });

  it("is not missed for the hours in which the whole machine slept", async () => {
    vi.useFakeTimers({ toFake: ["setInterval", "clearInterval"] });
    let [clock, slept] = [0, 0];
    const now = vi.spyOn(performance, "now").mockImplementation(() => clock + slept);
    onTestFinished(() => {
      vi.useRealTimers();
      now.mockRestore();
    });
    const { engine, workers } = start();
    await openPlane(engine);
    workers[0]?.silence();
    const waiting = engine.hash(0);
    const pass = (seconds: number): void => {
      for (let i = 0; i < seconds; i++, clock += 1000) vi.advanceTimersByTime(1000);
    };
    pass(6);
    slept = 8 * 3600_000;
    pass(6);
    expect(workers, "it may answer yet").toHaveLength(1);
    pass(18);
    expect(workers).toHaveLength(2);
    await waiting;
  });

  it("is left in peace while nobody waits for it, and while its thread answers", async () => {
    vi.useFakeTimers({ toFake: ["setInterval", "clearInterval", "performance"] });
    onTestFinished(() => {
      vi.useRealTimers();
    });
    const { engine, workers } = start();
    await openPlane(engine);
    vi.advanceTimersByTime(600_000);
    const pings = (): number => workers[0]?.received.filter(({ type }) => type === "ping").length ?? 0;
    expect(pings()).toBe(0);
    await engine.idle();
    expect(workers).toHaveLength(1);
  });

  it("is replaced without a word where its page was held still in the midst of its work, and asked again, however often", async () => {
    const page = new EventTarget();
    vi.stubGlobal("document", page);
    onTestFinished(() => {
      vi.unstubAllGlobals();
    });
    const wakes = (): boolean => page.dispatchEvent(new Event("resume"));
    const { engine, workers } = start();
    await openPlane(engine);
    engine.setLayers([decal("d", "logo")], 1);
    const before = await engine.hash(0);
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    await engine.idle();
    wakes();
    expect(workers, "one that has answered everything is left in peace").toHaveLength(1);
    for (const worker of workers) worker.silence();
    const waiting = engine.hash(0);
    for (let i = 1; i <= 4; i++) {
      wakes();
      expect(workers).toHaveLength(1 + i);
    }
    expect(await waiting).toBe(before);
    expect(errors).toEqual([]);
    engine.dispose();
    wakes();
    expect(workers).toHaveLength(5);
  });
});
