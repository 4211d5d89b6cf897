import "fake-indexeddb/auto";
import { IDBFactory } from "fake-indexeddb";
import { openDB } from "idb";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { type Design, parseDesign } from "../../web/editor/document/index.ts";
import { encodeDataUri } from "../../web/editor/files/data-uri.ts";
import type { ModelRef } from "../../web/editor/state/editor-state.ts";
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

  it("names what is missing when neither can be read", async () => {
    await save("a", content(design(1)), 0);
    const database = await openDB("texelcast");
    await database.clear("blobs");
    database.close();
    await expect(store.load("a")).rejects.toMatchObject({ code: "missing-file", subject: "Cup", field: "logo" });
    await expect(store.load("b")).rejects.toMatchObject({ code: "missing-file" });
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
    await store.sweep();
    await store.restore("a");
    expect(await store.list()).toHaveLength(1);
    await store.remove("a");
    await store.sweep(0);
    await store.restore("a");
    expect(await store.list()).toEqual([]);
    expect(await tables()).toEqual({ revisions: [], blobs: 0 });
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
