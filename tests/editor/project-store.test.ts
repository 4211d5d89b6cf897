import "fake-indexeddb/auto";
import { forceCloseDatabase, IDBFactory } from "fake-indexeddb";
import { openDB } from "idb";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { encodeDataUri } from "../../web/editor/document/data-uri.ts";
import {
  type Design,
  type DesignLayer,
  makeFillLayer,
  makeGroupLayer,
  makePaintLayer,
  makeStrokeLayer,
  parseDesign,
  serialiseDesign,
} from "../../web/editor/document/index.ts";
import type { ModelRef } from "../../web/editor/state/design-state.ts";
import { ProjectPacker } from "../../web/editor/storage/packed-project.ts";
import type { ProjectContent } from "../../web/editor/storage/project.ts";
import { ProjectStore } from "../../web/editor/storage/project-store.ts";
import { stringsIn } from "../../web/editor/strings.ts";

const LOGO = encodeDataUri("image/png", Uint8Array.of(1, 2, 3, 4));
const SECOND = encodeDataUri("image/png", Uint8Array.of(9, 9, 9));
const PROJECTOR = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] };
const OWN: ModelRef = {
  source: { name: "cup.gltf", bytes: Uint8Array.of(5, 6), resources: new Map([["cup.bin", Uint8Array.of(7)]]) },
  title: "cup.gltf",
  demoId: null,
};

function design(count: number, uri = LOGO): Design {
  const layers = Array.from({ length: count }, () => ({ type: "decal", asset: "logo", projector: PROJECTOR }));
  return parseDesign({
    format: "texelcast-design",
    version: 1,
    assets: { logo: { type: "image/png", uri } },
    layers,
  });
}

/** Each with some 40 kB of text. */
const strokes = (count: number, from = 0) =>
  Array.from({ length: count }, (_, index) =>
    makeStrokeLayer({
      id: `stroke-${from + index}`,
      brush: { tip: "round", color: "#c02050", hardness: 0.5, flow: 0.5 },
      dabs: Array.from({ length: 200 }, (_, dab) => ({
        kind: "planar",
        position: [index, dab, 0],
        rotation: [0, 0, 0, 1],
        size: [1, 1, 1],
        flow: 0.5,
      })),
    }),
  );
const painted = (of: ReturnType<typeof strokes>, below = design(1)): Design => ({
  ...below,
  layers: [...below.layers, makePaintLayer({ id: "paint", strokes: of })],
});

const content = (of: Design, name = "Cup"): ProjectContent => ({
  name,
  design: of,
  model: OWN,
  targets: new Map([[0, { size: 512, gutter: null }]]),
});

let store: ProjectStore;
let packer: ProjectPacker;
let time = 1000;
beforeEach(() => {
  globalThis.indexedDB = new IDBFactory();
  time = 1000;
  store = new ProjectStore(stringsIn("en"), () => time++);
  packer = new ProjectPacker(stringsIn("en"));
});
afterEach(() => {
  vi.restoreAllMocks();
  store.close();
});

const save = async (id: string, of: ProjectContent, seen: number): Promise<number> =>
  store.save(id, await packer.pack(of), seen);

async function tables(): Promise<{ revisions: [string, number][]; blobs: number }> {
  const database = await openDB("texelcast");
  const revisions = (await database.getAllKeys("revisions")) as [string, number][];
  const blobs = await database.count("blobs");
  database.close();
  return { revisions, blobs };
}

/** Every request of this name fails from the `nth` call on, as a full disk would make it. */
function refuse(name: "put" | "add" | "get", error: DOMException, nth = 1): void {
  const original = IDBObjectStore.prototype[name];
  let calls = 0;
  vi.spyOn(IDBObjectStore.prototype, name).mockImplementation(function (this: IDBObjectStore, ...args: never[]) {
    calls += 1;
    if (calls >= nth) throw error;
    return (original as (...args: never[]) => IDBRequest).apply(this, args);
  } as never);
}

describe("a project kept in the browser", () => {
  it("can be deleted where there is no room left for a mark that it is", async () => {
    await save("a", content(design(1)), 0);
    await save("b", content(design(2, SECOND)), 0);
    refuse("put", new DOMException("no space", "QuotaExceededError"));
    expect(await store.remove("a")).toBe(false);
    vi.restoreAllMocks();
    expect((await store.list()).map(({ id }) => id)).toEqual(["b"]);
    expect((await tables()).revisions).toEqual([["b", 1]]);
    expect(await store.remove("b")).toBe(true);
    await store.restore("b");
    expect(await store.list()).toHaveLength(1);
  });

  it("takes up what a page that was left had not saved, and keeps its pictures, model and the save before", async () => {
    await save("a", content(design(1)), 0);
    const words = packer.packText(content(design(2), "Mug"), design(1));
    if (!words) throw new Error("the picture is kept");
    await store.amend("a", { ...words, revision: 1 });
    const loaded = await store.load("a");
    expect([loaded.summary.revision, loaded.summary.name, loaded.summary.layers]).toEqual([2, "Mug", 2]);
    expect(loaded.design).toEqual(design(2));
    expect(loaded.model).toEqual(OWN);
    expect((await tables()).revisions).toEqual([
      ["a", 1],
      ["a", 2],
    ]);
  });

  it("of many strokes has them written once: a save more writes the newest, and all come back", async () => {
    const many = strokes(40);
    await save("a", content(painted(many)), 0);
    const written = vi.spyOn(IDBObjectStore.prototype, "put");
    const bytes = () => written.mock.calls.reduce((sum, [row]) => sum + JSON.stringify(row).length, 0);
    const more = [...many, ...strokes(1, 40)];
    await save("a", content(painted(more)), 1);
    expect(bytes()).toBeLessThan(40 * 40_000 * 0.3);
    const { design: back } = await store.load("a");
    expect(back).toEqual(painted(more));
    // What was read is not written again either, by a page that comes back to it.
    written.mockClear();
    const [below, paint] = back.layers;
    if (!below || paint?.type !== "paint") throw new Error("both layers are there");
    const next = { ...back, layers: [below, { ...paint, strokes: [...paint.strokes, ...strokes(1, 41)] }] };
    packer = new ProjectPacker(stringsIn("en"));
    await save("a", content(next), 2);
    expect(bytes()).toBeLessThan(40 * 40_000 * 0.3);
    expect((await store.load("a")).design).toEqual(next);
    // Steps back, and forth again after what they left behind was given up.
    for (const [seen, of] of [painted(many.slice(0, 5)), painted(many.slice(0, 4)), painted(many)].entries())
      await save("a", content(of), 3 + seen);
    expect((await store.load("a")).design).toEqual(painted(many));
    await store.remove("a");
    await store.sweep(0);
    expect(await tables()).toEqual({ revisions: [], blobs: 0 });
  });

  it("of several paintings, in groups and beside painted masks, gives each its own strokes back, save after save", async () => {
    const mask = (from: number) => ({ invert: false, linked: true, layers: strokes(8, from) });
    const paintings = (count: number): Design => ({
      ...design(1),
      layers: [
        makeGroupLayer({
          id: "group",
          mask: mask(900),
          layers: [
            makePaintLayer({ id: "empty", strokes: [] }),
            makePaintLayer({ id: "first", mask: mask(950), strokes: strokes(count) }),
          ],
        }),
        ...design(1).layers,
        makePaintLayer({ id: "second", strokes: strokes(count + 9, 300) }),
      ],
    });
    let of = paintings(20);
    await save("a", content(of), 0);
    for (const seen of [1, 2]) {
      packer = new ProjectPacker(stringsIn("en"));
      const { design: back } = await store.load("a");
      expect(back).toEqual(of);
      const [group, below, second] = back.layers;
      if (group?.type !== "group" || !below || second?.type !== "paint") throw new Error("all three are there");
      of = {
        ...back,
        layers: [group, below, { ...second, strokes: [...second.strokes, ...strokes(1, 600 + seen)] }],
      };
      await save("a", content(of), seen);
    }
    expect((await store.load("a")).design).toEqual(of);
  });

  it("of many strokes on a mask has them written once too, above what the mask begins with and around what else is on it", async () => {
    const masked = (held: ReturnType<typeof strokes>): Design => {
      const [decal] = design(1).layers;
      const ground = makeFillLayer({ id: "ground", color: "#000000", blend: "erase" });
      const layers = [ground, ...held.slice(0, 10), { ...decal, id: "between" }, ...held.slice(10)];
      return { ...design(1), layers: [{ ...decal, mask: { invert: false, linked: true, layers } } as DesignLayer] };
    };
    const many = strokes(40);
    await save("a", content(masked(many)), 0);
    const next = masked([...many, ...strokes(1, 40)]);
    const kept = masked(many);
    await save("words", content(kept), 0);
    expect(packer.packText(content(next), kept)?.design.length).toBeLessThan(40 * 40_000 * 0.4);
    const written = vi.spyOn(IDBObjectStore.prototype, "put");
    const bytes = () => written.mock.calls.reduce((sum, [row]) => sum + JSON.stringify(row).length, 0);
    await save("a", content(next), 1);
    expect(bytes()).toBeLessThan(40 * 40_000 * 0.4);
    const { design: back } = await store.load("a");
    expect(back).toEqual(next);
    written.mockClear();
    packer = new ProjectPacker(stringsIn("en"));
    const [paint] = painted(strokes(1, 60)).layers.slice(1);
    await save("a", content({ ...back, layers: [...back.layers, paint as DesignLayer] }), 2);
    expect(bytes()).toBeLessThan(40 * 40_000 * 0.4);
    expect((await store.load("a")).design.layers[0]).toEqual(next.layers[0]);
  });

  it("of many strokes lets the page have a turn between them as it is opened", async () => {
    await save("a", content(painted(strokes(40))), 0);
    const reading = vi.spyOn(JSON, "parse");
    const longest: number[] = [];
    let before = 0;
    let waiting = setImmediate(function count() {
      const read = reading.mock.calls.reduce((sum, [text]) => sum + text.length, 0);
      longest.push(read - before);
      before = read;
      waiting = setImmediate(count);
    });
    await store.load("a");
    clearImmediate(waiting);
    expect(Math.max(...longest)).toBeGreaterThan(0);
    expect(Math.max(...longest)).toBeLessThan(40 * 40_000 * 0.3);
  });

  it("takes up last words of many strokes by what is kept of them, and needs nothing else", async () => {
    const many = strokes(40);
    const kept = painted(many);
    await save("a", content(kept), 0);
    const next = painted([...many, ...strokes(1, 40)]);
    const words = packer.packText(content(next), kept);
    if (!words) throw new Error("the picture is kept");
    expect(words.design.length).toBeLessThan(40 * 40_000 * 0.3);
    // A save under way has made more parts, and may never end.
    const further = painted([...many, ...strokes(20, 40)]);
    await packer.pack(content(further));
    const later = packer.packText(content(further), kept);
    if (!later) throw new Error("the picture is kept");
    expect(await store.amend("a", { ...words, revision: 1 })).toBe(true);
    expect((await store.load("a")).design).toEqual(next);
    expect(await store.amend("a", { ...later, revision: 2 })).toBe(true);
    expect((await store.load("a")).design).toEqual(further);
  });

  it("opens as older pages wrote it, all text in one", async () => {
    const whole = painted(strokes(20));
    await save("a", content(whole), 0);
    const database = await openDB("texelcast");
    const row = await database.get("revisions", ["a", 1]);
    const logo = row.blobs.find((blob: string) => row.design.includes(`sha256/${blob}`));
    const old = serialiseDesign(whole).replace(LOGO, `sha256/${logo}`);
    expect(old).not.toContain(LOGO);
    await database.put("revisions", { ...row, design: old, blobs: row.blobs });
    database.close();
    expect((await store.load("a")).design).toEqual(whole);
  });

  it("takes up nothing that does not go on from what is kept", async () => {
    await save("a", content(design(1)), 0);
    const words = packer.packText(content(design(2)), design(1));
    if (!words) throw new Error("the picture is kept");
    expect(packer.packText(content(design(2, SECOND)), design(1))).toBeNull();
    await store.amend("a", { ...words, revision: 1, pictures: ["0".repeat(64)] });
    await store.amend("b", { ...words, revision: 1 });
    await save("a", content(design(3)), 1);
    await save("a", content(design(4)), 2);
    await store.amend("a", { ...words, revision: 1 });
    const { summary } = await store.load("a");
    expect([summary.revision, summary.layers]).toEqual([3, 4]);
    await store.remove("a");
    await store.amend("a", { ...words, revision: 3 });
    await expect(store.load("a")).rejects.toMatchObject({ code: "missing-file" });
  });

  it("is the newest when it was saved or come back to last, which leaves its place in the list", async () => {
    await save("a", content(design(1)), 0);
    await save("b", content(design(2), "Shoe"), 0);
    expect((await store.newest())?.id).toBe("b");
    expect(await store.touch("a")).toEqual({ name: "Cup", revision: 1 });
    expect((await store.newest())?.id).toBe("a");
    expect((await store.list()).map(({ id }) => id)).toEqual(["b", "a"]);
    await store.remove("a");
    expect(await store.touch("a")).toBeNull();
    expect(await store.touch("none")).toBeNull();
    expect((await store.newest())?.id).toBe("b");
  });

  it("is the newest when it was begun or come back to last, though the clock was set back meanwhile", async () => {
    time = 9_000;
    await save("ahead", content(design(1)), 0);
    time = 1_000;
    await save("begun", content(design(1), "Shoe"), 0);
    expect((await store.newest())?.id).toBe("begun");
    time = 1_500;
    await store.touch("ahead");
    expect((await store.newest())?.id).toBe("ahead");
    time = 2_000;
    await store.touch("begun");
    await save("begun", content(design(2), "Shoe"), 1);
    expect((await store.newest())?.id).toBe("begun");
  });

  it("comes back as it was: design, pictures, model with its side files, sizes and name", async () => {
    const saved = content(design(2));
    await save("a", saved, 0);
    const loaded = await store.load("a");
    expect(loaded.design).toEqual(saved.design);
    expect(loaded.model).toEqual(OWN);
    expect(loaded.targets).toEqual(saved.targets);
    expect(loaded.fromBackup).toBe(false);
    expect(loaded.summary).toMatchObject({ name: "Cup", revision: 1, layers: 2, modelTitle: "cup.gltf" });
  });

  it("names a demo without keeping its bytes", async () => {
    const model: ModelRef = { ...OWN, title: "Mug", demoId: "mug" };
    await save("a", { ...content(design(0)), model }, 0);
    expect((await store.load("a")).model).toEqual({ kind: "demo", id: "mug", title: "Mug" });
    expect((await tables()).blobs).toBe(1);
  });

  it("keeps the same picture once, however many projects and saves use it, and drops it with the last of them", async () => {
    await save("a", content(design(1)), 0);
    await save("a", content(design(2)), 1);
    await save("b", content(design(1)), 0);
    expect((await tables()).blobs).toBe(3);
    await save("a", content(design(1, SECOND)), 2);
    await save("a", content(design(2, SECOND)), 3);
    expect((await tables()).blobs).toBe(4);
    await store.remove("b");
    await store.sweep(0);
    expect((await tables()).blobs).toBe(3);
  });

  it("keeps the save before the newest, and no older one", async () => {
    for (let seen = 0; seen < 4; seen++) await save("a", content(design(seen)), seen);
    expect((await tables()).revisions).toEqual([
      ["a", 3],
      ["a", 4],
    ]);
  });

  it("opens the save before when the newest cannot be read, and says so", async () => {
    await save("a", content(design(1)), 0);
    await save("a", content(design(2)), 1);
    const database = await openDB("texelcast");
    await database.put("revisions", { ...(await database.get("revisions", ["a", 2])), design: "{" });
    database.close();
    const loaded = await store.load("a");
    expect(loaded.fromBackup).toBe(true);
    expect(loaded.design.layers).toHaveLength(1);
  });

  it("opens the save before when the browser gives the newest out no more", async () => {
    await save("a", content(design(1)), 0);
    await save("a", content(design(2)), 1);
    const { get } = IDBObjectStore.prototype;
    vi.spyOn(IDBObjectStore.prototype, "get").mockImplementation(function (this: IDBObjectStore, key) {
      const request = get.call(this, key);
      if (Array.isArray(key) && key[1] === 2) this.transaction.abort();
      return request;
    });
    const { design: loaded, fromBackup } = await store.load("a");
    expect(fromBackup).toBe(true);
    expect(loaded.layers).toHaveLength(1);
  });

  it("names what is missing when neither can be read", async () => {
    await save("a", content(design(1)), 0);
    const database = await openDB("texelcast");
    await database.clear("blobs");
    database.close();
    await expect(store.load("a")).rejects.toMatchObject({ code: "missing-file", subject: "Cup", field: "logo" });
    await expect(store.load("b")).rejects.toMatchObject({ code: "missing-file" });
  });

  it("is told with a code where what is kept of its strokes was damaged", async () => {
    await save("a", content(painted(strokes(40))), 0);
    const database = await openDB("texelcast");
    for (const blob of await database.getAll("blobs"))
      if (blob.bytes.length > 1000) await database.put("blobs", { ...blob, bytes: blob.bytes.slice(0, 5000) });
    database.close();
    await expect(store.load("a")).rejects.toMatchObject({
      name: "TexelcastError",
      code: "missing-file",
      subject: "Cup",
    });
  });
});

describe("a good save", () => {
  it("is not overwritten by a design that could not be read again", async () => {
    await save("a", content(design(1)), 0);
    const broken = { ...design(1), layers: [{ type: "decal", id: "x" }] } as unknown as Design;
    await expect(save("a", content(broken), 1)).rejects.toMatchObject({ code: "bad-design" });
    expect((await store.load("a")).design.layers).toHaveLength(1);
  });

  it("stands when the browser's space ends half-way through the next", async () => {
    await save("a", content(design(1)), 0);
    const full = new DOMException("no space", "QuotaExceededError");
    for (let nth = 1; nth <= 3; nth++) {
      refuse("put", full, nth);
      await expect(save("a", content(design(2, SECOND)), 1)).rejects.toMatchObject({ code: "storage-full" });
      vi.restoreAllMocks();
      const { design: kept, summary } = await store.load("a");
      expect([kept.layers.length, summary.revision]).toEqual([1, 1]);
    }
    expect((await tables()).blobs).toBe(3);
    expect(await save("a", content(design(2, SECOND)), 1)).toBe(2);
  });

  it("is not overwritten by a tab that has not seen it", async () => {
    await save("a", content(design(1)), 0);
    await save("a", content(design(2)), 1);
    await expect(save("a", content(design(0)), 1)).rejects.toMatchObject({ code: "storage-conflict" });
    expect((await store.load("a")).design.layers).toHaveLength(2);
  });
});

describe("the list of projects", () => {
  it("has the newest first, with what a list shows", async () => {
    await save("a", content(design(1), "First"), 0);
    await save("b", content(design(2), "Second"), 0);
    await store.setThumbnail("a", "data:image/webp;base64,AA==");
    expect((await store.list()).map(({ name, thumbnail }) => [name, thumbnail])).toEqual([
      ["Second", null],
      ["First", "data:image/webp;base64,AA=="],
    ]);
    await save("a", content(design(2), "First"), 1);
    expect((await store.list())[0]).toMatchObject({ name: "First", thumbnail: "data:image/webp;base64,AA==" });
  });

  it("renames and duplicates", async () => {
    await save("a", content(design(1)), 0);
    await store.rename("a", "Mine");
    expect(await store.nameOf("a")).toBe("Mine");
    const copy = await store.duplicate("a", "Mine, copy");
    await save("a", content(design(3), "Mine"), 1);
    expect((await store.list()).map(({ name }) => name)).toEqual(["Mine", "Mine, copy"]);
    expect((await store.load(copy)).design.layers).toHaveLength(1);
    expect(await save(copy, content(design(2), "Mine, copy"), 1)).toBe(2);
  });

  it("leaves out what was deleted, which can be brought back until it is swept", async () => {
    await save("a", content(design(1)), 0);
    await store.remove("a");
    expect(await store.list()).toEqual([]);
    expect(await store.nameOf("a")).toBeNull();
    await store.sweep();
    await store.restore("a");
    expect(await store.list()).toHaveLength(1);
    await store.remove("a");
    await store.sweep(0);
    await expect(store.restore("a"), "nobody is told that it is back").rejects.toMatchObject({ code: "missing-file" });
    expect(await store.list()).toEqual([]);
    expect(await tables()).toEqual({ revisions: [], blobs: 0 });
  });

  it("frees of what was deleted what it is told, and leaves what another tab may bring back", async () => {
    for (const id of ["a", "b", "c"]) await save(id, content(design(1)), 0);
    await store.remove("a");
    await store.remove("b");
    await store.sweepThese(new Set(["a", "c"]));
    await store.restore("b");
    expect((await store.list()).map(({ id }) => id).sort()).toEqual(["b", "c"]);
    await expect(store.restore("a")).rejects.toMatchObject({ code: "missing-file" });
  });
});

describe("a database that the browser closes", () => {
  /** The first request ends as those do that a browser's forced close meets: with what they belong to. */
  function closeUnderWay(): void {
    const { get } = IDBObjectStore.prototype;
    let closed = false;
    vi.spyOn(IDBObjectStore.prototype, "get").mockImplementation(function (this: IDBObjectStore, key) {
      const request = get.call(this, key);
      if (!closed) this.transaction.abort();
      closed = true;
      return request;
    });
  }

  it("in the midst of an answer is asked once more", async () => {
    await save("a", content(design(1), "Mug"), 0);
    closeUnderWay();
    expect(await store.nameOf("a")).toBe("Mug");
    expect(await store.nameOf("b")).toBeNull();
  });

  it("in the midst of a save is written once more, and once", async () => {
    const revision = await save("a", content(design(1), "Mug"), 0);
    closeUnderWay();
    expect(await save("a", content(design(2), "Mug"), revision)).toBe(revision + 1);
    expect((await tables()).revisions).toEqual([
      ["a", revision],
      ["a", revision + 1],
    ]);
  });

  it("and says so late leaves the one that was opened since", async () => {
    await save("a", content(design(1), "Mug"), 0);
    const opened: IDBDatabase[] = [];
    const { open } = indexedDB;
    const opening = vi.spyOn(indexedDB, "open").mockImplementation((...how) => {
      const request = open.apply(indexedDB, how);
      request.addEventListener("success", () => opened.push(request.result));
      return request;
    });
    store.close();
    await store.list();
    closeUnderWay();
    await store.nameOf("a");
    expect(opened).toHaveLength(2);
    // Its types ask for the class, it for one of it.
    forceCloseDatabase(opened[0] as never);
    await store.list();
    expect(opening).toHaveBeenCalledTimes(2);
  });
});

describe("a browser that keeps nothing", () => {
  it("is told apart from one that is full", async () => {
    vi.spyOn(indexedDB, "open").mockImplementation(() => {
      throw new DOMException("denied", "SecurityError");
    });
    await expect(store.list()).rejects.toMatchObject({ code: "storage-refused", hint: /file/ });
    await expect(save("a", content(design(1)), 0)).rejects.toMatchObject({ code: "storage-refused" });
    vi.restoreAllMocks();
    expect(await save("a", content(design(1)), 0)).toBe(1);
  });

  it("is not waited for when it never answers", async () => {
    vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
    vi.spyOn(indexedDB, "open").mockImplementation(() => new EventTarget() as IDBOpenDBRequest);
    const listing = expect(store.list()).rejects.toMatchObject({ code: "storage-refused", message: /does not answer/ });
    await vi.advanceTimersByTimeAsync(6000);
    await listing;
    vi.useRealTimers();
  });

  it("is told as well where it has no database at all", async () => {
    vi.stubGlobal("indexedDB", undefined);
    await expect(store.list()).rejects.toMatchObject({ code: "storage-refused" });
    vi.unstubAllGlobals();
  });

  it("offers names that no other project has, those of deleted ones among them", async () => {
    await save("a", content(design(1), "Mug"), 0);
    await save("b", content(design(1), "Mug 2"), 0);
    await save("c", content(design(1), "Cup"), 0);
    await store.remove("c");
    expect(await store.freeName("Mug", null)).toBe("Mug 3");
    expect(await store.freeName("Mug", "a")).toBe("Mug");
    expect(await store.freeName("Mug 2", "a")).toBe("Mug 3");
    expect(await store.freeName("Cup", null)).toBe("Cup");
  });
});
