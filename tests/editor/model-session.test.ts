import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { type Design, emptyDesign, makeDecalLayer } from "../../web/editor/document/index.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { ModelSession } from "../../web/editor/state/model-session.ts";
import { Store } from "../../web/editor/state/store.ts";
import { Tasks } from "../../web/editor/state/tasks.ts";
import type { UpdateRouter } from "../../web/editor/state/update-router.ts";
import type { Engine, ModelInfo, TargetInfo, TargetOptions } from "../../web/engine/engine-api.ts";
import type { ModelViewer } from "../../web/viewer/viewer-api.ts";
import { FRONT } from "../support/layers.ts";

const USUAL_SIDE = 1024;

interface Baking {
  readonly material: number;
  finish(): void;
}

/** An open model of three materials, of which the first has a target, and an engine whose bakes end when they are told to. */
function session({
  showFlat = async () => undefined,
  outline = () => undefined,
  opened = [],
  height = 1,
  viewer = {},
  showWholeTexture = () => undefined,
}: {
  readonly showFlat?: (target: TargetInfo) => Promise<void>;
  /** Told of the materials whose outlines are asked for. */
  readonly outline?: (material: number) => void;
  /** Materials of the next model, and its height; the open one's is 1. */
  readonly opened?: readonly object[];
  readonly height?: number;
  readonly viewer?: Partial<ModelViewer>;
  readonly showWholeTexture?: () => void;
} = {}) {
  const store = new Store<EditorState>(INITIAL_STATE);
  const tasks = new Tasks(store);
  const baked: [material: number, side: number][] = [];
  const bakes: Baking[] = [];
  let begun = (): void => undefined;
  const engine = {
    uvTriangles: async (material: number) => {
      outline(material);
      return new Float32Array();
    },
    loadModel: async () => ({ name: "b.glb", materials: opened, ...roomOf(height), glb: new Uint8Array(8) }),
    openTarget: ({ material, width = USUAL_SIDE }: TargetOptions, _: unknown, signal: AbortSignal) =>
      new Promise((resolve, reject) => {
        signal.addEventListener("abort", () => reject(new TexelcastError("cancelled", "Cancelled.")));
        const finish = (): void => {
          baked.push([material, width]);
          resolve({ material, width, height: width });
        };
        bakes.push({ material, finish });
        begun();
      }),
  } as unknown as Engine;
  const router = { bind: () => undefined, clear: () => undefined, showInTextureView: showFlat, showWholeTexture };
  const models = new ModelSession({
    engine,
    viewer: viewer as ModelViewer,
    router: router as unknown as UpdateRouter,
    store,
    tasks,
    send: () => undefined,
    coming: () => undefined,
  });
  const ref = { source: { name: "a.glb", bytes: new Uint8Array() }, title: "a", demoId: null };
  const materials = [0, 1, 2].map((index) => ({ index, refusal: null }));
  store.set({
    model: { ref, info: { materials, ...roomOf(1) } as never },
    material: 0,
    targets: new Map([[0, { material: 0, width: USUAL_SIDE } as TargetInfo]]),
  });
  /** The next bake that the engine is asked for. */
  const nextBake = async (): Promise<Baking> => {
    while (bakes.length === 0) {
      await new Promise<void>((resolve) => {
        begun = resolve;
      });
    }
    return bakes.shift() as Baking;
  };
  const finish = async (material: number): Promise<void> => {
    const bake = await nextBake();
    expect(bake.material).toBe(material);
    bake.finish();
  };
  return { store, models, baked, nextBake, finish };
}

const roomOf = (height: number) => ({ boundsMin: [0, 0, 0], boundsMax: [1, height, 1] });

function designOn(...materials: number[]): Design {
  const layers = materials.map((material) =>
    makeDecalLayer({ id: `on ${material}`, asset: "picture", projector: FRONT, material }),
  );
  return { ...emptyDesign(), layers };
}

const HALF = { size: USUAL_SIDE / 2, gutter: null };

describe("the targets of the open model", () => {
  it("are prepared for a design also where another texture gets its size meanwhile", async () => {
    const { store, models, baked, nextBake, finish } = session();
    const ensured = models.ensureTargets(designOn(1, 2));
    const first = await nextBake();
    const configured = models.configure(0, HALF);
    first.finish();
    await finish(2);
    await finish(0);
    await Promise.all([ensured, configured]);
    expect(baked).toEqual([
      [1, USUAL_SIDE],
      [2, USUAL_SIDE],
      [0, HALF.size],
    ]);
    expect([...store.state.targets.keys()]).toEqual([0, 1, 2]);
  });

  it("are prepared once, in the newest size, where one of them gets its size while it is prepared", async () => {
    const { store, models, baked, nextBake, finish } = session();
    const ensured = models.ensureTargets(designOn(1, 2));
    await nextBake();
    const configured = models.configure(1, HALF);
    await finish(2);
    await finish(1);
    await Promise.all([ensured, configured]);
    expect(baked).toEqual([
      [2, USUAL_SIDE],
      [1, HALF.size],
    ]);
    expect(store.state.targets.get(1)).toMatchObject({ width: HALF.size });
  });

  it("follow the newest of several sizes alone", async () => {
    const { models, baked, nextBake, finish } = session();
    const older = models.configure(0, HALF);
    await nextBake();
    const newer = models.configure(0, { size: 256, gutter: null });
    await expect(older).rejects.toMatchObject({ code: "cancelled" });
    await finish(0);
    await newer;
    expect(baked).toEqual([[0, 256]]);
  });

  it("are all opened anew in another usual size, but for one that gets its own meanwhile", async () => {
    const { store, models, baked, nextBake, finish } = session();
    store.set({ usualTarget: { size: 256, gutter: null } });
    const reopened = [0, 1].map((material) => models.reopen(material));
    await nextBake();
    const configured = models.configure(0, HALF);
    await expect(reopened[0]).rejects.toMatchObject({ code: "cancelled" });
    await finish(1);
    await finish(0);
    await Promise.all([reopened[1], configured]);
    expect(baked).toEqual([
      [1, 256],
      [0, HALF.size],
    ]);
  });

  it("are opened anew for the flat view where their texels cannot be had, so that it gets a whole picture in the end", async () => {
    const { store, models, baked, finish } = session({
      showFlat: () => Promise.reject(new TexelcastError("out-of-budget", "Too large.")),
    });
    store.set({ material: 1 });
    const shown = models.showMaterial(0);
    await finish(0);
    await shown;
    expect(store.state.material).toBe(0);
    expect(baked).toEqual([[0, USUAL_SIDE]]);
  });

  it("are prepared once where a layer on one of them is chosen, so that the flat view shows it, too", async () => {
    const { models, baked, finish } = session();
    const ensured = models.ensureTargets(designOn(1));
    const shown = models.showMaterial(1);
    await finish(1);
    await Promise.all([ensured, shown]);
    expect(baked).toEqual([[1, USUAL_SIDE]]);
  });

  it("come into the flat view where that turns to one of them while it is prepared", async () => {
    const flat: number[] = [];
    const { models, nextBake } = session({ showFlat: async ({ material }) => void flat.push(material) });
    const ensured = models.ensureTargets(designOn(1));
    const bake = await nextBake();
    const shown = models.showMaterial(1);
    bake.finish();
    await Promise.all([ensured, shown]);
    expect(flat).toEqual([1]);
  });

  it("have their outlines asked for where the flat view shows them alone", async () => {
    const outlined: number[] = [];
    const { models, finish } = session({ outline: (material) => void outlined.push(material) });
    const ensured = models.ensureTargets(designOn(1, 2));
    await finish(1);
    await finish(2);
    await ensured;
    expect(outlined).toEqual([]);
    await models.showMaterial(2);
    expect(outlined).toEqual([2]);
  });

  it("say so where the user cancels what a design needs", async () => {
    const { store, models, nextBake } = session();
    const ensured = models.ensureTargets(designOn(1));
    await nextBake();
    store.state.tasks[0]?.cancel?.();
    await expect(ensured).rejects.toMatchObject({ code: "cancelled" });
    expect(store.state.targets.has(1)).toBe(false);
  });
});

describe("a model in place of another", () => {
  /** What the views are brought back to by a model so high, opened over one of whose two parts one is hidden. */
  async function seen(height: number) {
    const brought: unknown[] = [];
    const viewer: Partial<ModelViewer> = {
      setModel: async () => undefined,
      keepCamera: () => () => void brought.push("camera"),
      setHiddenParts: (ids) => void brought.push([...ids]),
    };
    const showWholeTexture = () => void brought.push("whole texture");
    const opened = [{ index: 0, refusal: null }];
    const { store, models, finish } = session({ opened, height, viewer, showWholeTexture });
    const parts = [{}, {}] as unknown as EditorState["shown"]["parts"];
    store.set({ shown: { ...store.state.shown, parts, hidden: new Set([1]) } });
    // As whoever shows parts does.
    let model = store.state.model;
    store.subscribe(() => {
      if (store.state.model === model) return;
      model = store.state.model;
      store.set({ shown: { ...store.state.shown, parts, hidden: new Set() } });
    });
    const ref = { source: { name: "b.glb", bytes: new Uint8Array() }, title: "b", demoId: null };
    const opening = models.open(ref, emptyDesign(), () => undefined, { keepsView: true });
    await finish(0);
    await opening;
    return { brought, hidden: [...store.state.shown.hidden] };
  }

  it("has its texture prepared while the view still reads it, and bound once the view has it", async () => {
    let isRead = (): void => undefined;
    const viewer = { setModel: () => new Promise<void>((resolve) => (isRead = resolve)) };
    const { store, models, finish, baked } = session({ opened: [{ index: 0, refusal: null }], viewer });
    const ref = { source: { name: "b.glb", bytes: new Uint8Array() }, title: "b", demoId: null };
    const before = store.state.model;
    const opening = models.open(ref, emptyDesign(), () => undefined);
    await finish(0);
    expect(baked).toEqual([[0, USUAL_SIDE]]);
    expect(store.state.model).toBe(before);
    isRead();
    await opening;
    expect([...store.state.targets.keys()]).toEqual([0]);
    expect(store.state.model?.ref).toBe(ref);
  });

  it("is kept without the GLB that the view was given, which the one before brings again where it comes back", async () => {
    const given: number[] = [];
    const viewer: Partial<ModelViewer> = {
      setModel: async ({ glb }: ModelInfo) => void given.push(glb.length),
      keepCamera: () => () => undefined,
      setHiddenParts: () => undefined,
    };
    const { store, models, nextBake, finish } = session({ opened: [{ index: 0, refusal: null }], viewer });
    const ref = { source: { name: "b.glb", bytes: new Uint8Array() }, title: "b", demoId: null };
    const opening = models.open(ref, emptyDesign(), () => undefined);
    await finish(0);
    await opening;
    expect(store.state.model?.info.glb).toHaveLength(0);
    const second = models.open(ref, emptyDesign(), () => undefined);
    await nextBake();
    store.state.tasks[0]?.cancel?.();
    await finish(0);
    await expect(second).rejects.toMatchObject({ code: "cancelled" });
    expect(given).toEqual([8, 8, 8]);
  });

  it("is seen as that is where it takes the same room, without the parts that are hidden", async () => {
    expect(await seen(1)).toEqual({ brought: ["camera", [1]], hidden: [1] });
  });

  it("is seen whole, and from the front where it takes another room, and so is its texture", async () => {
    expect(await seen(2)).toEqual({ brought: ["whole texture"], hidden: [] });
  });
});

describe("a model none of whose materials takes paint", () => {
  const refused = (index: number, code: string) => ({ index, name: "", refusal: { code, message: `It has ${code}.` } });
  const ref = { source: { name: "b.glb", bytes: new Uint8Array() }, title: "b", demoId: null };

  it("is refused for what can be helped, with the materials that unwrapping would help", async () => {
    const { store, models } = session({
      opened: [refused(0, "no-triangles"), refused(1, "no-uvs"), refused(2, "no-uvs")],
    });
    store.set({ model: null });
    await expect(models.open(ref, emptyDesign(), () => undefined)).rejects.toMatchObject({
      ...{ code: "no-uvs", subject: "b.glb", message: "It has no-uvs." },
      model: { ref, materials: [1, 2] },
    });
  });

  it("is refused for what it lacks where unwrapping would not help", async () => {
    const { store, models } = session({ opened: [refused(0, "no-triangles")] });
    store.set({ model: null });
    const opening = models.open(ref, emptyDesign(), () => undefined);
    await expect(opening).rejects.toMatchObject({ code: "no-triangles", subject: "b.glb" });
    await expect(opening).rejects.not.toHaveProperty("model");
  });
});
