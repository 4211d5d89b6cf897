/** What an engine is asked in a way that its types do not allow: told by name, in its own thread as by its worker, and nothing is lost. */
import { afterEach, describe, expect, it } from "vitest";
import type { Engine } from "../../web/engine/engine-api.ts";
import { createEngineClient } from "../../web/engine/engine-client.ts";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { createEngine } from "../../web/package/core.ts";
import { fill } from "../support/layers.ts";
import { buildGlb, plane } from "../support/model-builder.ts";
import { solidPng } from "../support/png-file.ts";
import { ThreadWorker } from "../support/thread-worker.ts";
import { LEFT_HALF, zones } from "../support/zones.ts";

const MODEL = { name: "plane.glb", bytes: buildGlb({ meshes: [plane(1, 0)], materials: [{}] }) };
const DOOR: Record<string, () => Engine> = {
  "in its own thread": () => createEngineHost(),
  "by its worker": () => createEngineClient({ createWorker: () => new ThreadWorker() as never }),
};

let engine: Engine;
afterEach(() => (engine as Engine | undefined)?.dispose());

const errors: Error[] = [];
async function open(door: string): Promise<string> {
  engine = (DOOR[door] as () => Engine)();
  errors.length = 0;
  engine.onError((error) => errors.push(error));
  await engine.loadModel(MODEL);
  await engine.openTarget({ material: 0, width: 16 });
  engine.setLayers([fill("f", [0, 0, 1, 0.5])], 1);
  return await engine.hash(0);
}

/** As a script without types calls it. */
type Loose = Record<keyof Engine, (...values: unknown[]) => Promise<unknown>>;

const box = { kind: "box", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] };
const BAD: readonly (readonly [
  what: string,
  call: (engine: Loose) => Promise<unknown>,
  field: string,
  value?: string,
])[] = [
  ["no options of a target", (it) => it.openTarget(), "material"],
  ["null for a target's options", (it) => it.openTarget(null), "material"],
  ["null as base", (it) => it.openTarget({ material: 0, base: null }), "base", "null"],
  ["a base without bytes", (it) => it.openTarget({ material: 0, base: { name: "a.png", bytes: undefined } }), "bytes"],
  [
    "a buffer as a base's bytes",
    (it) => it.openTarget({ material: 0, width: 8, base: { name: "a.png", bytes: new ArrayBuffer(4) } }),
    "bytes",
    "[object ArrayBuffer]",
  ],
  [
    "side files in an object",
    (it) => it.loadModel({ ...MODEL, resources: { "a.bin": new Uint8Array(4) } }),
    "resources",
  ],
  ["a side file of no bytes", (it) => it.loadModel({ ...MODEL, resources: new Map([["a.bin", "text"]]) }), "bytes"],
  ["a material where a list of them is asked for", (it) => it.exportGlb(0), "materials", "0"],
  ["words where a list of materials is asked for", (it) => it.exportUsdz("all"), "materials", "all"],
  ["another view of a map", (it) => it.viewMap(0, "depth"), "view", "depth"],
  ["no view of a map", (it) => it.viewMap(0), "view", "undefined"],
  ["another map of the print", (it) => it.printMap(0, "ink"), "kind", "ink"],
  ["zones in a list", (it) => it.setZones([LEFT_HALF]), "zones"],
  ["no list of zones", (it) => it.setZones({ ...zones(), zones: LEFT_HALF }), "zones.zones", "object"],
  ["zones without a DPI", (it) => it.setZones({ ...zones(), dpi: undefined }), "zones.dpi", "undefined"],
  ["a scale of 0", (it) => it.setZones(zones({}, { printScale: 0 })), "zones.printScale", "0"],
  ["null for a zone", (it) => it.setZones({ ...zones(), zones: [null] }), "zones.zones[0]", "null"],
  [
    "a zone of another shape",
    (it) => it.setZones(zones({ shape: { kind: "disc" } as never })),
    "zones.zones[0].shape.kind",
    "disc",
  ],
  [
    "a zone's corner that is none",
    (it) => it.setZones(zones({ shape: { kind: "uv", polygon: [[0, 0], [1, 0], 5] } as never })),
    "zones.zones[0].shape.polygon[2]",
    "5",
  ],
  ["a zone's bleed in words", (it) => it.setZones(zones({ bleed: "3 mm" as never })), "zones.zones[0].bleed", "3 mm"],
  [
    "a box of two sides",
    (it) => it.setZones(zones({ shape: { ...box, size: [1, 1] } as never })),
    "zones.zones[0].shape.size",
    "[1, 1]",
  ],
];

describe.each(Object.keys(DOOR))("an engine that is asked %s", (door) => {
  for (const [what, call, field, value] of BAD) {
    it(`refuses ${what} by its field, and goes on`, async () => {
      const painted = await open(door);
      const refused = { name: "TexelcastError", code: "bad-argument", field, ...(value && { value }) };
      await expect(call(engine as never)).rejects.toMatchObject(refused);
      expect(await engine.hash(0)).toBe(painted);
      expect(errors).toEqual([]);
    });
  }

  it("takes no zones for an end of zones", async () => {
    const painted = await open(door);
    for (const _again of [1, 2]) {
      await engine.setZones(undefined as never);
      expect(await engine.hash(0)).toBe(painted);
      await engine.setZones(zones());
      expect(await engine.hash(0)).not.toBe(painted);
    }
    expect(errors).toEqual([]);
  });
});

it("bytes that were given away to another thread are told as what cannot be sent", async () => {
  const painted = await open("by its worker");
  const bytes = solidPng(2, 2, [1, 2, 3, 255]);
  structuredClone(bytes, { transfer: [bytes.buffer] });
  await expect(engine.setAsset("logo", { name: "logo.png", bytes })).rejects.toMatchObject({
    code: "bad-argument",
    message: expect.stringMatching(/detached/),
  });
  expect(await engine.hash(0)).toBe(painted);
});

it.each([
  [{ memoryBudgetMib: "512" }, "memoryBudgetMib", "512"],
  [{ memoryBudgetMib: Number.NaN }, "memoryBudgetMib", "NaN"],
  [{ memoryBudgetMib: -1 }, "memoryBudgetMib", "-1"],
  [{ createWorker: "worker.js" }, "createWorker", "worker.js"],
])("no engine begins with the options %j", async (options, field, value) => {
  const createWorker = () => new ThreadWorker() as never;
  const begin = async (): Promise<void> => {
    engine = createEngine({ createWorker, ...options } as never);
    await engine.stats();
  };
  await expect(begin()).rejects.toMatchObject({ name: "TexelcastError", code: "bad-argument", field, value });
});
