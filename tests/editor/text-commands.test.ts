import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { emptyDesign, makeTextLayer, type TextLayer } from "../../web/editor/document/index.ts";
import { AssetLibrary } from "../../web/editor/state/asset-library.ts";
import type { DecalCommands } from "../../web/editor/state/decal-commands.ts";
import { addOnTop, layerById } from "../../web/editor/state/design-edits.ts";
import { DesignSession } from "../../web/editor/state/design-session.ts";
import type { OpenModel } from "../../web/editor/state/design-state.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { Store } from "../../web/editor/state/store.ts";
import { Tasks } from "../../web/editor/state/tasks.ts";
import { shippedFont, TextCommands, type TextCommandsParts } from "../../web/editor/state/text-commands.ts";
import { runsPastEdge, shareOfModel } from "../../web/editor/state/text-troubles.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import type { Engine, EngineText, PlanarProjector, Projector, TargetInfo } from "../../web/engine/engine-api.ts";
import type { ModelViewer, SurfaceHit } from "../../web/viewer/viewer-api.ts";
import { FRONT } from "../support/layers.ts";

const INTER = shippedFont("inter-700");
const LOBSTER = shippedFont("lobster-400");

const BOUNDS = { boundsMin: [-99, -99, -99], boundsMax: [99, 99, 99] };
const words = stringsIn("en").text;

/** An engine whose fonts come when the test says so: its measures wait until then. */
function waitingEngine() {
  const waiting: { readonly words: EngineText; readonly end: (failed?: Error) => void }[] = [];
  const measureText = (words: EngineText) =>
    new Promise((resolve, reject) => {
      const room = { width: words.text.length, height: 1, missing: [] };
      waiting.push({ words, end: (failed) => (failed ? reject(failed) : resolve(room)) });
    });
  /** Ends the measures that wait, or those that `which` says. */
  const arrive = async (which: (words: EngineText) => boolean = () => true, failed?: Error): Promise<void> => {
    for (let more = true; more; ) {
      const ended = waiting.filter(({ words }) => which(words));
      for (const each of ended) waiting.splice(waiting.indexOf(each), 1);
      for (const each of ended) each.end(failed);
      // What follows one may ask for the next.
      await new Promise((resolve) => setTimeout(resolve, 0));
      more = waiting.some(({ words }) => which(words));
    }
  };
  return { measureText, arrive };
}

/** An editor with two texts, "Ada" and "Eve", whose fonts are slow. */
function twoTexts() {
  const { measureText, arrive } = waitingEngine();
  const product = { color: [255, 255, 255], read: Promise.resolve() };
  const readTexels = async (): Promise<Uint8Array> => {
    await product.read;
    return new Uint8Array([...product.color, 255]);
  };
  const engine = { measureText, readTexels, setLayers: () => {}, removeAsset: async () => {} } as unknown as Engine;
  const surface = { near: () => ({ material: 0, uv: [0.5, 0.5] }) };
  const viewer = { setDecals: () => {}, materialsReached: () => [0], surface } as unknown as ModelViewer;
  const store = new Store<EditorState>({ ...INITIAL_STATE, model: { info: BOUNDS } as unknown as OpenModel });
  store.set({ targets: new Map([[0, { width: 64, height: 64 } as TargetInfo]]) });
  const library = new AssetLibrary(engine);
  const session = new DesignSession({ engine, viewer, library, store, later: () => {} });
  const board = new NoticeBoard(store);
  const hits: unknown[] = [];
  const texts = new TextCommands({
    ...{ engine, viewer, session, store, board, library },
    admission: null,
    tasks: new Tasks(store),
    decals: {
      placed: (_id: string, projector: Projector) => ({ projector }),
      laid: (_layer: TextLayer, box: object) => box,
      placeFor: (_aspect: number, spot: SurfaceHit | null) => ({ projector: FRONT, spot }),
      addLayer: (...[{ projector, spot }, label, make]: Parameters<DecalCommands["addLayer"]>) => {
        hits.push(spot);
        const { design, layer: added } = make("new", projector, 0);
        session.record(addOnTop(design, added), label);
      },
    },
  } as unknown as TextCommandsParts);
  const put = (id: string, text: string): TextLayer =>
    makeTextLayer({ id, name: text, text, font: INTER.name, projector: FRONT });
  session.record(
    { ...emptyDesign(), assets: { [INTER.name]: INTER.asset }, layers: [put("a", "Ada"), put("b", "Eve")] },
    "open",
  );
  const layer = (id: string): TextLayer => layerById(session.recordedDesign, id) as TextLayer;
  const fontOf = (id: string): string | undefined => session.recordedDesign.assets[layer(id).font]?.uri;
  const told = (): string[] => store.state.notices.map(({ message }) => message);
  const titles = (): string[] => store.state.notices.map(({ title }) => title);
  const working = (): string[] => store.state.tasks.map(({ label }) => label);
  return { session, texts, arrive, layer, fontOf, told, titles, hits, working, product };
}

const isLobster = ({ font }: EngineText): boolean => font === LOBSTER.asset.uri;

describe("a change of a text whose font is still being fetched", () => {
  it("is recorded when the font comes, whatever else was changed in the meantime", async () => {
    const { session, texts, arrive, layer, fontOf } = twoTexts();
    void texts.change("a", { fontAsset: LOBSTER }, "font");
    void texts.change("b", { text: "Eva" }, "words");
    void texts.change("a", { align: "right" }, "align");
    session.record({ ...session.recordedDesign, layers: [{ ...layer("a"), opacity: 0.5 }, layer("b")] }, "opacity");
    await arrive((words) => !isLobster(words));
    await arrive();
    expect(session.recording).toBe(false);
    expect(fontOf("a")).toBe(LOBSTER.asset.uri);
    expect(layer("a")).toMatchObject({ align: "right", opacity: 0.5 });
    expect(layer("b").text).toBe("Eva");
    expect(session.steps.labels.slice(2)).toEqual(["opacity", "words", "align", "font"]);
  });

  it("is not taken back by a change that was asked for before it", async () => {
    const { texts, arrive, fontOf } = twoTexts();
    void texts.change("a", { fontAsset: LOBSTER }, "font");
    void texts.change("a", { fontAsset: INTER }, "font");
    await arrive((words) => !isLobster(words));
    await arrive(isLobster);
    expect(fontOf("a")).toBe(INTER.asset.uri);
  });

  it("leaves what is shown of a later one, and its text when that is gone", async () => {
    const { session, texts, arrive, layer, fontOf } = twoTexts();
    void texts.change("a", { fontAsset: LOBSTER }, "font");
    void texts.preview("b", { text: "Eva Maria" });
    await arrive();
    expect(fontOf("a")).toBe(LOBSTER.asset.uri);
    expect(layer("b").text).toBe("Eve");
    expect(layerById(session.design, "b")).toMatchObject({ text: "Eva Maria" });

    void texts.change("b", { fontAsset: LOBSTER, text: "Evelyn" }, "font");
    session.record({ ...session.recordedDesign, layers: [layer("a")] }, "delete");
    const before = session.recordedDesign;
    await arrive();
    expect(session.recordedDesign).toBe(before);
  });

  it("is told of where the font cannot be had, and the changes after it are recorded all the same", async () => {
    const { texts, arrive, layer, fontOf, told } = twoTexts();
    void texts.change("a", { fontAsset: LOBSTER }, "font");
    void texts.change("b", { text: "Eva" }, "words");
    await arrive(isLobster, new TexelcastError("io", "No font."));
    await arrive();
    expect(told()).toEqual(["No font."]);
    expect(fontOf("a")).toBe(INTER.asset.uri);
    expect(layer("b").text).toBe("Eva");
  });

  it("can be noted by a page that is left, but not where others wait with it", async () => {
    const { texts, arrive } = twoTexts();
    void texts.change("a", { text: "Adam" }, "words");
    expect(texts.unmeasured).toEqual({ id: "a", before: { text: "Ada" }, after: { text: "Adam" } });
    void texts.change("b", { text: "Eva" }, "words");
    expect(texts.unmeasured).toBeNull();
    await arrive();
    expect(texts.unmeasured).toBeNull();
  });
});

describe("a text whose font is still being fetched", () => {
  it("is put on the design as it is when the font comes, and what is saved waits for it", async () => {
    const { session, texts, arrive, layer, fontOf } = twoTexts();
    void texts.add(null, LOBSTER);
    expect(session.recording).toBe(true);
    session.record({ ...session.recordedDesign, layers: [layer("b")] }, "delete");
    await arrive();
    expect(session.recording).toBe(false);
    expect(session.recordedDesign.layers.map(({ id }) => id).sort()).toEqual(["b", "new"]);
    expect(fontOf("new")).toBe(LOBSTER.asset.uri);
  });

  it("asked for again meanwhile, is one text, where it was asked for last, and once it is there another one can follow", async () => {
    const { session, texts, arrive, hits } = twoTexts();
    const [there, elsewhere] = [{ place: 1 }, { place: 2 }] as unknown as SurfaceHit[];
    void texts.add(there, LOBSTER);
    void texts.add(elsewhere, LOBSTER);
    void texts.add(null, LOBSTER);
    await arrive();
    expect(session.recordedDesign.layers).toHaveLength(3);
    expect(hits).toEqual([elsewhere]);
    void texts.add(null, LOBSTER);
    await arrive();
    expect(hits).toEqual([elsewhere, null]);
  });

  it("is white where the product is dark, at the place that was named last, also while the product is looked at", async () => {
    const { texts, arrive, layer, hits, product } = twoTexts();
    product.color = [12, 12, 14];
    let look = (): void => {};
    product.read = new Promise((resolve) => {
      look = resolve;
    });
    const elsewhere = { place: 2 } as unknown as SurfaceHit;
    const added = texts.add(null, LOBSTER);
    await arrive();
    void texts.add(elsewhere, LOBSTER);
    look();
    await added;
    expect(hits).toEqual([elsewhere]);
    expect(layer("new").color).toBe("#ffffff");
  });

  it("asked for in another font, is another text", async () => {
    const { texts, arrive, hits } = twoTexts();
    void texts.add(null, LOBSTER);
    void texts.add(null, INTER);
    await arrive();
    expect(hits).toEqual([null, null]);
  });

  it("is told of as work in progress, as is a change of font, until it is there", async () => {
    const { texts, arrive, working } = twoTexts();
    void texts.add(null, LOBSTER);
    expect(working()).toEqual(["Setting the words"]);
    await arrive();
    expect(working()).toEqual([]);
    void texts.change("a", { fontAsset: LOBSTER }, "font");
    expect(working()).toEqual(["Setting the words"]);
    await arrive();
    expect(working()).toEqual([]);
  });

  it("lies close in its box where that is when the font comes", async () => {
    const { session, texts, arrive, layer } = twoTexts();
    void texts.fitBox(layer("a"));
    const moved: PlanarProjector = { ...FRONT, position: [7, 8, 9] };
    session.record({ ...session.recordedDesign, layers: [{ ...layer("a"), projector: moved }, layer("b")] }, "move");
    await arrive();
    const { projector } = layer("a");
    expect(projector).toMatchObject({ position: [7, 8, 9] });
    expect(projector.kind === "planar" && projector.size[0] / projector.size[1]).toBeCloseTo("Ada".length);
  });
});

describe("words on a label", () => {
  /** Text "a" round a mug of radius 1, close about "Ada". */
  function onLabel(height: number) {
    const made = twoTexts();
    const { session, layer } = made;
    const arc = (("Ada".length * height) / Math.PI) * 180;
    const projector: Projector = { ...ROUND, height, arc };
    const label = { ...layer("a"), fontSize: 1, projector };
    session.record({ ...session.recordedDesign, layers: [label, layer("b")] }, "wrap");
    const type = async (text: string): Promise<void> => {
      const changed = made.texts.change("a", { text }, "words");
      await made.arrive();
      await changed;
    };
    return { ...made, type };
  }
  const ROUND = { kind: "cylindrical", position: [0, 0, 0], rotation: [0, 0, 0, 1], radius: 1, depth: 0.1 } as const;

  it("that go more than once round it are told, once, and not those that go round it less", async () => {
    const { type, titles, layer } = onLabel(0.25);
    await type("Ada Lovelace");
    expect(titles()).toEqual([]);
    await type("Ada Lovelace, Countess of Somewhere");
    expect(titles()).toEqual([words.longTitle]);
    expect(layer("a").projector).toMatchObject({ arc: 360 });
    await type("Ada Lovelace, Countess of Somewhere Else");
    expect(titles()).toEqual([words.longTitle]);
  });

  it("are larger than the model where they are higher than it along the label's axis", () => {
    const model = { info: BOUNDS } as unknown as OpenModel;
    const label = { ...ROUND, height: 99, arc: 90 };
    expect(shareOfModel(model, label)).toBe(0.5);
    expect(shareOfModel(model, { ...label, rotation: [0.5, 0.5, 0.5, 0.5], height: 396 })).toBe(2);
  });
});

describe("a text in a box", () => {
  it("runs past the edge where nothing lies below one of its sides, and only there", () => {
    const layer = { projector: { ...FRONT, size: [2, 1, 1] }, fontSize: 1, backfaces: false } as const;
    /** A surface between two places along X. */
    const onSurface = (low: number, high: number): boolean =>
      runsPastEdge(
        {
          materialsReached: (projector) => {
            if (projector.kind !== "planar") throw new Error("A box is asked for.");
            const { position, size } = projector;
            return position[0] + size[0] / 2 > low && position[0] - size[0] / 2 < high ? [0] : [];
          },
        },
        layer,
      );
    const [x] = FRONT.position;
    expect(onSurface(x - 1, x + 1)).toBe(false);
    expect(onSurface(x - 0.7, x + 1)).toBe(true);
    expect(onSurface(x - 1, x + 0.7)).toBe(true);
    // A letter's edge beyond it is none that anybody misses.
    expect(onSurface(x - 0.9, x + 0.9)).toBe(false);
  });
});
