import { createHash } from "node:crypto";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { type Design, emptyDesign, makeTextLayer } from "../../web/editor/document/index.ts";
import { countedName } from "../../web/editor/files/counted-name.ts";
import type { ModelRef } from "../../web/editor/state/design-state.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { Store } from "../../web/editor/state/store.ts";
import { shippedFont } from "../../web/editor/state/text-commands.ts";
import { Autosave } from "../../web/editor/storage/autosave.ts";
import type { LastWords, Unmeasured } from "../../web/editor/storage/last-words.ts";
import type { PackedProject } from "../../web/editor/storage/packed-project.ts";
import type { TabPlace } from "../../web/editor/storage/tab-memory.ts";
import { stringsIn } from "../../web/editor/strings.ts";

const modelRef = (title: string, demoId: string | null): ModelRef => ({
  source: { name: `${title}.glb`, bytes: Uint8Array.of(title.length) },
  title,
  demoId,
});

const plain = makeTextLayer({
  id: "words",
  text: "",
  font: "inter",
  projector: { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] },
});

/** A page with an autosave, and everything that it was told. */
function page() {
  const store = new Store<EditorState>(INITIAL_STATE);
  let recorded: { design: Design; model: ModelRef | null } = { design: emptyDesign(), model: null };
  const saves: { id: string; packed: PackedProject; seen: number }[] = [];
  const told: string[] = [];
  const taken = new Set<string>();
  const touched: string[] = [];
  const keeps: (() => void)[] = [];
  /** What other hands made of projects that are kept: null for a deleted one. */
  const rows = new Map<string, { name: string; revision: number } | null>();
  const remembered: TabPlace[] = [];
  /** By project: what was noted of it in leaving the page. */
  const noted = new Map<string, LastWords>();
  let refusal: TexelcastError | null = null;
  /** Name of the only project that the refusal is of; null for every one. */
  let refusedName: string | null = null;
  const waiting: { current: Unmeasured | null } = { current: null };
  const autosave = new Autosave({
    store,
    strings: stringsIn("en"),
    recorded: () => recorded,
    projects: {
      save: async (id, packed, seen) => {
        const refused = refusedName === null || packed.name === refusedName ? refusal : null;
        if (refused?.code === "storage-conflict") refusal = null;
        if (refused) throw refused;
        saves.push({ id, packed, seen });
        rows.set(id, { name: packed.name, revision: seen + 1 });
        return seen + 1;
      },
      touch: async (id) => {
        touched.push(id);
        return rows.get(id) ?? null;
      },
      freeName: async (name) => countedName(name, taken),
      nameOf: async (id) => rows.get(id)?.name ?? null,
      setThumbnail: async (id) => {
        told.push(`picture of ${id}`);
      },
    },
    lock: { take: async () => true },
    tab: { remember: (place) => remembered.push(place) },
    lastWords: {
      note: (project, words) => {
        noted.set(project, words);
        return true;
      },
      forget: (project) => noted.delete(project),
    },
    unmeasured: () => waiting.current,
    thumbnail: async () => "data:image/webp;base64,AA==",
    notices: {
      refused: ({ code }, left) => {
        const words = left === null ? code : `${code}: ${left.name}`;
        told.push(words);
        return () => told.push(`no longer ${words}`);
      },
      restored: (left) => told.push(left === null ? "restored" : `restored: ${left.name}`),
      copied: (name) => told.push(`copied: ${name}`),
      deleted: (keep) => {
        told.push("deleted");
        keeps.push(keep);
      },
    },
  });
  const open = (ref: ModelRef, design = emptyDesign()): void => {
    recorded = { design, model: ref };
    store.set({ model: { ref, info: {} as never }, design, designName: ref.title });
  };
  /** One step of the history. */
  const step = (assets = recorded.design.assets): Design => {
    const design = { ...recorded.design, assets, layers: [...recorded.design.layers] };
    recorded = { ...recorded, design };
    store.set({ design });
    return design;
  };
  const settle = async (milliseconds: number): Promise<void> => {
    await vi.advanceTimersByTimeAsync(milliseconds);
  };
  const refuse = (error: TexelcastError | null, name: string | null = null): void => {
    refusal = error;
    refusedName = name;
  };
  return {
    store,
    autosave,
    saves,
    told,
    keeps,
    taken,
    touched,
    rows,
    remembered,
    noted,
    waiting,
    open,
    step,
    settle,
    refuse,
  };
}

beforeEach(() => {
  vi.useFakeTimers();
  // A digest at once: for one from another thread, or for code that is loaded, a stopped clock would not wait.
  const { crypto } = globalThis;
  vi.stubGlobal("crypto", {
    getRandomValues: (array: Uint8Array<ArrayBuffer>) => crypto.getRandomValues(array),
    subtle: { digest: async (_: string, bytes: Uint8Array) => createHash("sha256").update(bytes).digest() },
  });
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

describe("autosave", () => {
  it("does not keep a demo that nothing was changed on, and keeps it from the first change on", async () => {
    const { open, step, settle, saves, store } = page();
    open(modelRef("Mug", "mug"));
    await settle(5000);
    expect([saves.length, store.state.keeping]).toEqual([0, "untouched"]);
    step();
    await settle(1000);
    expect([saves.length, store.state.keeping]).toEqual([1, "kept"]);
  });

  it("keeps the user's own model as soon as it is open", async () => {
    const { open, settle, saves } = page();
    open(modelRef("Cup", null));
    await settle(1000);
    expect(saves.map(({ seen, packed }) => [seen, packed.name, packed.model.kind])).toEqual([[0, "Cup", "files"]]);
  });

  it("notes in leaving the page what is not kept yet, until it is saved", async () => {
    const { autosave, open, step, settle, saves, noted } = page();
    open(modelRef("Cup", null));
    await settle(1000);
    expect([autosave.leave(), noted.size]).toEqual([true, 0]);
    step();
    expect(autosave.leave()).toBe(true);
    const [first] = saves;
    expect([...noted].map(([id, { revision, name }]) => [id, revision, name])).toEqual([[first?.id, 1, "Cup"]]);
    await settle(1000);
    expect([saves.length, noted.size]).toEqual([2, 0]);
  });

  it("notes words that are not measured yet in the box that they had, until what is saved has them", async () => {
    const { autosave, open, settle, step, noted, waiting } = page();
    const words = { ...plain, text: "Ada" };
    open(modelRef("Cup", null), {
      ...emptyDesign(),
      assets: { inter: shippedFont("inter-700").asset },
      layers: [words],
    });
    await settle(1000);
    waiting.current = { id: words.id, before: { text: "Ada" }, after: { text: "Grace" } };
    expect(autosave.leave()).toBe(true);
    const [note] = noted.values();
    expect(note?.unmeasured).toEqual(waiting.current);
    expect(JSON.parse(note?.design ?? "").layers).toMatchObject([{ text: "Grace", projector: words.projector }]);
    step();
    await settle(1000);
    expect(noted.size).toBe(1);
    waiting.current = null;
    step();
    await settle(1000);
    expect(noted.size).toBe(0);
  });

  it("cannot note what nothing is kept of yet, what was refused, and what needs a picture that is not kept", async () => {
    const { autosave, open, step, settle, store, refuse, noted } = page();
    open(modelRef("Cup", null));
    await Promise.resolve();
    expect(autosave.leave()).toBe(false);
    await settle(1000);
    const design = step({ logo: { type: "image/png", uri: "data:image/png;base64,AQID" } });
    expect(autosave.leave()).toBe(false);
    await settle(1000);
    expect(store.state.keeping).toBe("kept");
    step(design.assets);
    expect(autosave.leave()).toBe(true);
    await settle(1000);
    refuse(new TexelcastError("storage-full", "full"));
    step();
    await settle(1000);
    expect([autosave.leave(), noted.size]).toEqual([false, 0]);
  });

  it("makes the project's picture anew once a gesture is over, and not in its midst", async () => {
    const { open, step, settle, store, told } = page();
    open(modelRef("Cup", null));
    await settle(100);
    const design = step();
    store.set({ design: { ...design } });
    await settle(5000);
    expect(told).toEqual([]);
    store.set({ design });
    await settle(2000);
    expect(told).toEqual([expect.stringMatching(/^picture of /)]);
  });

  it("keeps the first step at once, and many that follow each other with few saves, of which the last is the newest", async () => {
    const { open, step, settle, saves, autosave } = page();
    open(modelRef("Cup", null));
    await settle(1);
    expect(saves).toHaveLength(1);
    for (let i = 0; i < 50; i++) {
      step();
      await settle(10);
    }
    await settle(1000);
    expect(saves.length).toBeLessThan(5);
    expect(saves.map(({ seen }) => seen)).toEqual(saves.map((_, index) => index));
    expect(autosave.pending).toBe(false);
  });

  it("waits while one model takes the place of another", async () => {
    const { open, settle, saves, store } = page();
    store.set({ switching: true });
    open(modelRef("Cup", null));
    await settle(1000);
    expect(saves).toHaveLength(0);
    store.set({ switching: false });
    await settle(1000);
    expect(saves).toHaveLength(1);
  });

  it("begins another project with another model, and goes on with the first when its model is back", async () => {
    const { open, step, settle, saves, autosave } = page();
    const cup = modelRef("Cup", null);
    open(cup);
    await settle(1000);
    open(modelRef("Shoe", null));
    await settle(1000);
    open(cup, { ...emptyDesign() });
    step();
    await settle(1000);
    const [first, second, third] = saves;
    expect(second?.id).not.toBe(first?.id);
    expect([third?.id, third?.seen]).toEqual([first?.id, 1]);
    expect(autosave.projectId).toBe(first?.id);
  });

  it("makes the project that an undo brings back the one that was open last, with nothing of it left to save", async () => {
    const { open, settle, saves, touched, remembered } = page();
    const [cup, cups] = [modelRef("Cup", null), emptyDesign()];
    open(cup, cups);
    await settle(1000);
    open(modelRef("Shoe", null));
    await settle(1000);
    open(cup, cups);
    await settle(1000);
    const [first, second] = saves;
    expect(touched.at(-1)).toBe(first?.id);
    expect(remembered.at(-1)).toEqual({ project: first?.id });
    expect(remembered).toContainEqual({ project: second?.id });
    expect(saves).toHaveLength(2);
  });

  it("remembers a demo that nothing was changed on as what this tab shows, and its project from the first change on", async () => {
    const { open, step, settle, saves, remembered } = page();
    open(modelRef("Mug", "mug"));
    await settle(1000);
    expect(remembered.at(-1)).toEqual({ demo: "mug" });
    step();
    await settle(1000);
    expect(remembered.at(-1)).toEqual({ project: saves[0]?.id });
  });

  it("remembers of a copy that nothing was changed on what it is a copy of, and then the copy", async () => {
    const { open, step, settle, saves, remembered, autosave } = page();
    const [mug, design] = [modelRef("Mug", "mug"), emptyDesign()];
    autosave.adopt({ name: "Mug", design, model: mug, targets: new Map() }, "copy", 0, "first");
    open(mug, design);
    await settle(1000);
    expect([saves.length, remembered.at(-1)]).toEqual([0, { project: "first" }]);
    step();
    await settle(1000);
    expect([saves.length, remembered.at(-1)]).toEqual([1, { project: "copy" }]);
  });

  it("saves a step that another model followed before its time had come, and has the other open last", async () => {
    const { open, step, settle, saves, touched, autosave } = page();
    const shoe = modelRef("Shoe", null);
    open(shoe);
    await settle(1000);
    const cup = modelRef("Cup", null);
    open(cup);
    await settle(1000);
    const [first, second] = saves;
    step();
    await settle(1);
    step();
    await settle(1);
    open(shoe);
    await settle(2000);
    expect(autosave.projectId).toBe(first?.id);
    expect(saves.at(-1)).toMatchObject({ id: first?.id });
    expect(saves.filter(({ id }) => id === second?.id).map(({ seen }) => seen)).toEqual([0, 1, 2]);
    expect(touched.at(-1)).toBe(first?.id);
  });

  it("does not say of a project that was deleted meanwhile that it is kept, and takes over a name given meanwhile", async () => {
    const { open, settle, saves, rows, store, step } = page();
    const [cup, shoe] = [modelRef("Cup", null), modelRef("Shoe", null)];
    const [cups, shoes] = [emptyDesign(), emptyDesign()];
    open(cup, cups);
    await settle(1000);
    open(shoe, shoes);
    await settle(1000);
    const [first, second] = saves;
    rows.set(first?.id ?? "", null);
    open(cup, cups);
    await settle(1000);
    expect([saves.length, store.state.keeping]).toEqual([2, "untouched"]);
    step();
    await settle(1000);
    expect(saves[2]?.id).not.toBe(first?.id);
    rows.set(second?.id ?? "", { name: "Boot", revision: 1 });
    open(shoe, shoes);
    await settle(1000);
    expect(store.state.designName).toBe("Boot");
    expect(saves).toHaveLength(3);
  });

  it("counts the saves of a project once, though it is in the history twice: as it was, and as it was opened again", async () => {
    const { open, step, settle, saves, told, autosave } = page();
    const cup = modelRef("Cup", null);
    open(cup);
    await settle(1000);
    const [first] = saves;
    const again = modelRef("Cup", null);
    const design = emptyDesign();
    autosave.adopt({ name: "Cup", design, model: again, targets: new Map() }, first?.id ?? "", 1);
    open(again, design);
    step();
    await settle(1000);
    open(cup);
    await settle(1000);
    expect(saves.map(({ id, seen }) => [id, seen])).toEqual([0, 1, 2].map((seen) => [first?.id, seen]));
    expect(told.filter((word) => word.startsWith("copied"))).toEqual([]);
  });

  it("saves at once when asked", async () => {
    const { open, step, settle, saves, autosave } = page();
    open(modelRef("Cup", null));
    await settle(1);
    step();
    await autosave.flush();
    expect(saves).toHaveLength(2);
    await autosave.flush();
    expect(saves).toHaveLength(2);
  });

  it("has one save under way at a time, however many ask for one meanwhile", async () => {
    const { open, step, settle, saves, autosave } = page();
    open(modelRef("Cup", null));
    await settle(1);
    step();
    const first = autosave.flush();
    step();
    await Promise.all([first, autosave.flush(), autosave.flush()]);
    expect(saves.map(({ seen }) => seen)).toEqual([0, 1, 2]);
    expect(autosave.pending).toBe(false);
  });

  it("says once that the browser refuses, tries again by itself, and says when it works again", async () => {
    const { open, step, settle, saves, told, refuse, store } = page();
    refuse(new TexelcastError("storage-full", "full"));
    open(modelRef("Cup", null));
    await settle(1000);
    step();
    await settle(60_000);
    expect(told).toEqual(["storage-full"]);
    expect(store.state.keeping).toBe("refused");
    refuse(null);
    await settle(20_000);
    expect(saves).toHaveLength(1);
    expect(told.slice(0, 3)).toEqual(["storage-full", "no longer storage-full", "restored"]);
    expect(store.state.keeping).toBe("kept");
  });

  it("says by its name that a project which was left is not kept, while the open one is, until it is kept, too", async () => {
    const { open, step, settle, saves, told, refuse, store, autosave } = page();
    const pictures = () => told.filter((words) => !words.startsWith("picture"));
    refuse(new TexelcastError("storage-full", "full"), "Shoe");
    open(modelRef("Shoe", null));
    await settle(1000);
    open(modelRef("Cup", null));
    await settle(1000);
    expect(pictures()).toEqual(["storage-full", "no longer storage-full", "storage-full: Shoe"]);
    expect(store.state.keeping).toBe("kept");
    // Each step of what is kept says nothing anew, and is not held up by what is not.
    for (let steps = 0; steps < 5; steps++) {
      step();
      await settle(1000);
      expect(autosave.pending).toBe(false);
    }
    await settle(60_000);
    expect(pictures()).toHaveLength(3);
    expect(saves.map(({ packed }) => packed.name)).toEqual(Array(6).fill("Cup"));
    expect(autosave.leaves).toBe(true);

    refuse(null);
    await settle(20_000);
    expect(saves.at(-1)?.packed.name).toBe("Shoe");
    expect(pictures().slice(3)).toEqual(["no longer storage-full: Shoe", "restored: Shoe"]);
    expect(autosave.leaves).toBe(false);
  });

  it("a project that is not kept and was left is taken as kept once it is in a file, and as open once an undo brings it back", async () => {
    const { open, settle, told, refuse, autosave, store, saves } = page();
    const pictures = () => told.filter((words) => !words.startsWith("picture"));
    const [shoe, cup] = [modelRef("Shoe", null), modelRef("Cup", null)];
    const shoes = emptyDesign();
    refuse(new TexelcastError("storage-full", "full"), "Shoe");
    open(shoe, shoes);
    await settle(1000);
    open(cup);
    await settle(1000);
    autosave.inFile(shoe);
    expect(autosave.leaves).toBe(false);
    expect(pictures().slice(3)).toEqual(["no longer storage-full: Shoe"]);
    await settle(60_000);
    expect(pictures()).toHaveLength(4);

    open(shoe, shoes);
    await settle(1000);
    expect(pictures().slice(4)).toEqual(["storage-full"]);
    expect(store.state.keeping).toBe("refused");
    refuse(null);
    await settle(20_000);
    expect(saves.at(-1)?.packed.name).toBe("Shoe");
    expect(store.state.keeping).toBe("kept");
  });

  it("goes on as a copy when another tab has saved the project meanwhile", async () => {
    const { open, step, settle, saves, told, refuse, store } = page();
    open(modelRef("Cup", null));
    await settle(1000);
    refuse(new TexelcastError("storage-conflict", "changed"));
    step();
    await settle(1000);
    expect(told).toContain("copied: Cup (copy)");
    expect(store.state.designName).toBe("Cup (copy)");
    const [first, second] = saves;
    expect(second?.id).not.toBe(first?.id);
    expect(second?.packed.name).toBe("Cup (copy)");
  });

  it("keeps the name that the project was given elsewhere meanwhile, and has it on the page, but for one given here", async () => {
    const { open, step, settle, saves, store, rows } = page();
    open(modelRef("Cup", null));
    await settle(1000);
    const id = saves[0]?.id as string;
    rows.set(id, { name: "Gift", revision: 1 });
    step();
    await settle(1000);
    expect([saves.at(-1)?.packed.name, store.state.designName, store.state.keeping]).toEqual(["Gift", "Gift", "kept"]);
    expect(saves).toHaveLength(2);
    rows.set(id, { name: "Elsewhere", revision: 2 });
    store.set({ designName: "Here" });
    await settle(1000);
    expect([saves.at(-1)?.packed.name, store.state.designName]).toEqual(["Here", "Here"]);
  });

  it("makes the project's picture once the steps pause", async () => {
    const { open, step, settle, told, autosave } = page();
    open(modelRef("Cup", null));
    for (let i = 0; i < 5; i++) {
      step();
      await settle(500);
    }
    expect(told).toEqual([]);
    await settle(3000);
    expect(told).toEqual([`picture of ${autosave.projectId}`]);
  });

  it("begins anew under another id when the open project was deleted", async () => {
    const { open, step, settle, saves, autosave, store } = page();
    open(modelRef("Cup", null));
    await settle(1000);
    autosave.forget(saves[0]?.id ?? "");
    await settle(1000);
    expect([saves.length, store.state.keeping]).toEqual([1, "untouched"]);
    step();
    await settle(1000);
    expect(saves[1]?.id).not.toBe(saves[0]?.id);
    expect(saves[1]?.seen).toBe(0);
  });

  it("tells, once the page is seen again, that another tab has deleted the project, and keeps it anew if asked to", async () => {
    const { open, settle, saves, autosave, rows, told, keeps, store } = page();
    open(modelRef("Cup", null));
    await settle(1000);
    await autosave.seenAgain();
    expect(told).not.toContain("deleted");
    rows.clear();
    await Promise.all([autosave.seenAgain(), autosave.seenAgain()]);
    await autosave.seenAgain();
    await settle(1000);
    expect(told.filter((word) => word === "deleted")).toHaveLength(1);
    expect([saves.length, store.state.keeping]).toEqual([1, "untouched"]);
    keeps[0]?.();
    await settle(1000);
    expect([saves.length, store.state.keeping, saves[1]?.seen]).toEqual([2, "kept", 0]);
    expect(saves[1]?.id).not.toBe(saves[0]?.id);
  });

  it("shows the name that another tab has given to the project once the page is seen again, and saves nothing for it", async () => {
    const { open, settle, saves, autosave, rows, store } = page();
    open(modelRef("Cup", null));
    await settle(1000);
    rows.set(saves[0]?.id as string, { name: "Gift", revision: 1 });
    await autosave.seenAgain();
    await settle(1000);
    expect([saves.length, store.state.designName, store.state.keeping]).toEqual([1, "Gift", "kept"]);
  });

  it("a step that is not saved yet brings back a project that another tab has deleted, and nothing is told", async () => {
    const { open, step, settle, saves, autosave, rows, told } = page();
    open(modelRef("Cup", null));
    await settle(1000);
    rows.clear();
    step();
    await autosave.seenAgain();
    await settle(1000);
    expect(told).not.toContain("deleted");
    expect(saves.map(({ id }) => id)).toEqual([saves[0]?.id, saves[0]?.id]);
  });

  it("gives a new project a name that no other has, on the page too, and asks no more once it is kept", async () => {
    const { open, step, settle, saves, store, taken } = page();
    taken.add("Mug").add("Mug 2");
    open(modelRef("Mug", null));
    await settle(1000);
    expect(saves.at(-1)?.packed.name).toBe("Mug 3");
    expect(store.state.designName).toBe("Mug 3");
    taken.add("Mug 3");
    step();
    await settle(1000);
    expect(saves.map(({ packed }) => packed.name)).toEqual(["Mug 3", "Mug 3"]);
  });
});
