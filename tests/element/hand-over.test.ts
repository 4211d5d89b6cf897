import { describe, expect, it } from "vitest";
import { emptyDesign, makeFillLayer, makeTextLayer, type TextLayer } from "../../web/editor/document/index.ts";
import { AssetLibrary } from "../../web/editor/state/asset-library.ts";
import { addOnTop, layerById } from "../../web/editor/state/design-edits.ts";
import { DesignSession } from "../../web/editor/state/design-session.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { Store } from "../../web/editor/state/store.ts";
import { Desk } from "../../web/element/desk/desk.ts";
import type { DeskSettings } from "../../web/element/desk/desk-settings.ts";
import { submitDetail } from "../../web/element/desk/hand-over.ts";
import { Texts } from "../../web/element/desk/texts.ts";
import { english } from "../../web/element/words/english.ts";
import type { Engine, EngineLayer } from "../../web/engine/engine-api.ts";
import type { ModelViewer } from "../../web/viewer/viewer-api.ts";
import { FRONT } from "../support/layers.ts";

const FONT = { type: "font/ttf", uri: "texelcast:fonts/inter-700" } as const;
const wordsOf = (layers: readonly unknown[]): unknown[] => layers.map((layer) => (layer as TextLayer).text);

/** A desk with a text on it, whose engine measures when it is told to and prints the words that it was given last. */
function deskWithText() {
  let layers: readonly EngineLayer[] = [];
  const printing: (() => void)[] = [];
  const waiting: (() => void)[] = [];
  const engine = {
    setLayers: (given: readonly EngineLayer[]) => {
      layers = given;
    },
    measureText: () =>
      new Promise((resolve) => waiting.push(() => resolve({ width: 2, height: 1, inkWidth: 2, inkHeight: 1 }))),
    exportPrint: async () => {
      const printed = JSON.stringify(layers);
      printing.shift()?.();
      return { sha256: printed };
    },
    idle: async () => undefined,
  } as unknown as Engine;
  const viewer = { setDecals: () => undefined } as unknown as ModelViewer;
  const store = new Store<EditorState>(INITIAL_STATE);
  const library = new AssetLibrary(engine);
  const session = new DesignSession({ engine, viewer, library, store, later: () => undefined });
  const settings = { readonly: false, maxDecals: null, size: null, words: english } as unknown as DeskSettings;
  const hooks = { settings: () => settings, changed: () => undefined, selected: () => undefined };
  const desk = new Desk({
    ...{ engine, viewer, store, library, session },
    loadHands: async () => viewer,
    hooks: {
      ...hooks,
      failed: () => undefined,
      graphicsLost: () => undefined,
      warn: () => undefined,
      progress: () => undefined,
      announce: () => undefined,
    },
  });
  const text = makeTextLayer({ id: "words", text: "Your text", font: "inter", projector: FRONT });
  desk.record({ ...emptyDesign(), assets: { inter: FONT }, layers: [text] }, "begin");
  return {
    desk,
    texts: new Texts(desk),
    mode: { desk, idle: () => desk.settled() },
    /** Answers all measures that were asked for. */
    measured: () => {
      for (const each of waiting.splice(0)) each();
    },
    /** Does something while the next texture is being printed. */
    whilePrinting: (act: () => void) => printing.push(act),
  };
}

describe("what is handed in", () => {
  it("holds the words whose typing ended with the press on the button, in the design and the texture alike", async () => {
    const { desk, texts, mode, measured } = deskWithText();
    void texts.change("words", { text: "Ada" }, true);
    const handedIn = submitDetail(mode, async () => undefined);
    measured();
    const detail = await handedIn;
    expect(wordsOf(detail.design.layers)).toEqual(["Ada"]);
    expect(detail.texture.sha256).toContain('"Ada"');
    expect(wordsOf(desk.design.layers)).toEqual(["Ada"]);
  });

  it("holds words that are still being typed, as a step that can be undone", async () => {
    const { desk, texts, mode, measured } = deskWithText();
    void texts.change("words", { text: "Grace" }, false);
    measured();
    const detail = await submitDetail(mode, async () => undefined);
    expect(wordsOf(detail.design.layers)).toEqual(["Grace"]);
    expect(detail.texture.sha256).toContain('"Grace"');
    desk.travel(-1);
    expect(wordsOf(desk.design.layers)).toEqual(["Your text"]);
    // The field says the same once more when it loses the focus: no step.
    desk.travel(1);
    await texts.change("words", { text: "Grace" }, true);
    desk.travel(-1);
    expect(wordsOf(desk.design.layers)).toEqual(["Your text"]);
  });

  it("is made anew where the customer goes on while it is printed", async () => {
    const { desk, mode, whilePrinting } = deskWithText();
    whilePrinting(() => desk.change<TextLayer>("words", { text: "Second thoughts" }, true));
    const detail = await submitDetail(mode, async () => undefined);
    expect(wordsOf(detail.design.layers)).toEqual(["Second thoughts"]);
    expect(detail.texture.sha256).toContain('"Second thoughts"');
  });
});

describe("words that are typed", () => {
  it("are not lost where another layer comes in while they are measured", async () => {
    const { desk, texts, measured } = deskWithText();
    const change = texts.change("words", { text: "Ada" }, true);
    desk.record(addOnTop(desk.design, makeFillLayer({ id: "fill", color: "#ffffff" })), "fill");
    measured();
    await change;
    expect(desk.design.layers.map(({ id }) => id).sort()).toEqual(["fill", "words"]);
    expect((layerById(desk.design, "words") as TextLayer).text).toBe("Ada");
  });

  it("are not lost where the next change of them is begun while they are measured", async () => {
    const { desk, texts, measured } = deskWithText();
    const typed = texts.change("words", { text: "Ada" }, true);
    const coloured = texts.change("words", { color: "#ff0000" }, true);
    measured();
    await typed;
    measured();
    await coloured;
    expect(layerById(desk.design, "words")).toMatchObject({ text: "Ada", color: "#ff0000" });
  });
});
