import { expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { AssetLibrary } from "../../web/editor/state/asset-library.ts";
import { DesignSession } from "../../web/editor/state/design-session.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { Store } from "../../web/editor/state/store.ts";
import { ToldError } from "../../web/editor/strings/told-error.ts";
import { Desk } from "../../web/element/desk/desk.ts";
import type { DeskHooks } from "../../web/element/desk/desk-settings.ts";
import { shippedFont, Texts } from "../../web/element/desk/texts.ts";
import { english } from "../../web/element/words/english.ts";
import type { Engine, EngineText, TargetInfo } from "../../web/engine/engine-api.ts";
import { readShippedFont } from "../../web/engine/shipped-fonts.ts";
import type { ModelViewer } from "../../web/viewer/viewer-api.ts";
import { FRONT } from "../support/layers.ts";

const FONT = await readShippedFont("bebas-neue-400");

interface Engineered {
  readonly refuses: boolean;
  readonly misses?: TexelcastError | null;
  /** Letters that it cannot draw. */
  readonly lacks?: string;
}

/** A desk whose engine keeps fonts, and measures words unless it `refuses`. */
function deskWithFonts({ refuses, misses = null, lacks = "" }: Engineered) {
  const has = new Set<string>();
  let slow: string | null = null;
  let arrive = (): void => undefined;
  const arrival = new Promise<void>((resolve) => {
    arrive = resolve;
  });
  const measured = {
    waitFor: (font: string): void => {
      slow = font;
    },
    arrive: () => arrive(),
  };
  const engine = {
    setFont: async (key: string) => {
      has.add(key);
      return { name: "Hand" };
    },
    removeAsset: async (key: string) => void has.delete(key),
    setLayers: () => undefined,
    measureText: async ({ font, text }: EngineText) => {
      if (font === slow) await arrival;
      if (misses) throw misses;
      if (refuses || [...text].some((letter) => lacks.includes(letter)))
        throw new TexelcastError("bad-font", "The letters cannot be drawn.");
      return { width: 2, height: 1, inkWidth: 2, inkHeight: 1 };
    },
  } as unknown as Engine;
  const viewer = {
    setDecals: () => undefined,
    surfaceAtCentre: () => null,
    landing: () => null,
  } as unknown as ModelViewer;
  const model = {
    info: { materials: [{ index: 0 }], boundsMin: [0, 0, 0], boundsMax: [1, 1, 1] },
  } as unknown as EditorState["model"];
  const store = new Store<EditorState>({ ...INITIAL_STATE, model });
  const library = new AssetLibrary(engine);
  const session = new DesignSession({ engine, viewer, library, store, later: () => undefined });
  const hooks = {
    settings: () => ({ readonly: false, maxDecals: null, beforeAccept: null, words: english }),
    changed: () => undefined,
    selected: () => undefined,
    announce: () => undefined,
  } as unknown as DeskHooks;
  const desk = new Desk({ engine, viewer, store, library, session, hooks, loadHands: async () => viewer as never });
  return { desk, texts: new Texts(desk), has, measured };
}

const WORDS = { font: FONT, projector: FRONT, material: 0 };

it("a font brought with words that could not be put on is let go", async () => {
  const { texts, has } = deskWithFonts({ refuses: true });
  await expect(texts.add("Hello", WORDS)).rejects.toThrow("cannot be drawn");
  expect([...has]).toEqual([]);
});

it("a font brought with words stays as long as they can be brought back, and no longer", async () => {
  const { desk, texts, has } = deskWithFonts({ refuses: false });
  await texts.add("Hello", WORDS);
  expect(has.size).toBe(1);
  desk.session.travelTo(desk.session.position - 1);
  expect(has.size).toBe(1);
  desk.record({ ...desk.design, layers: [] }, "another way");
  expect([...has]).toEqual([]);
});

it("words that are being typed when others are put on stay, as a step of their own", async () => {
  const { desk, texts } = deskWithFonts({ refuses: false });
  const said = (): unknown[] => desk.shown.layers.map((layer) => layer.type === "text" && layer.text);
  const id = await texts.add("one", { projector: FRONT, material: 0 });
  await texts.change(id, { text: "one more" }, false);
  await texts.add("two", { projector: FRONT, material: 0 });
  expect(said()).toEqual(["one more", "two"]);
  desk.travel(-1);
  expect(said()).toEqual(["one more"]);
});

it("a font that cannot be fetched is told in a customer's words, and to the page with its address", async () => {
  const address = "https://shop.example/assets/Lobster.ttf";
  const misses = new TexelcastError("missing-file", `The font could not be read from ${address}: 404.`, {
    ...{ subject: address, reason: "not-loaded", hint: "Check its address." },
  });
  const { desk, texts } = deskWithFonts({ refuses: false, misses });
  const before = desk.design;
  const refusal = await texts.add("Hello", { projector: FRONT, material: 0 }).catch((thrown: unknown) => thrown);
  expect(refusal).toBeInstanceOf(ToldError);
  expect(refusal).toMatchObject({ code: "missing-file", reason: "not-loaded", subject: address, cause: misses });
  const { message, hint } = refusal as ToldError;
  expect(`${message} ${hint}`).not.toMatch(/http|address/);
  expect(hint).toMatch(/try again/);
  expect(desk.design).toBe(before);
});

it("new words are white on a dark product, and as the page says where it says so", async () => {
  const { desk, texts } = deskWithFonts({ refuses: false });
  Object.assign(desk.engine, { readTexels: async () => new Uint8Array([10, 10, 40, 255]) });
  Object.assign(desk.viewer, { surface: { near: () => ({ material: 0, uv: [0.5, 0.5] }) } });
  const colors = (): unknown[] => desk.design.layers.map((layer) => layer.type === "text" && layer.color);
  await texts.add("unknown", { projector: FRONT, material: 0 });
  desk.store.set({ targets: new Map([[0, { width: 64, height: 64 } as TargetInfo]]) });
  await texts.add("white", { projector: FRONT, material: 0 });
  await texts.add("red", { projector: FRONT, material: 0, color: "#aa0000" });
  expect(colors()).toEqual(["#1a1a1a", "#ffffff", "#aa0000"]);
});

const planar = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;

it.each<[string, object]>([
  ["projector.kind", { projector: { kind: "x" } }],
  ["projector.kind", { projector: {} }],
  ["projector", { projector: 5 }],
  ["projector.position", { projector: { kind: "planar" } }],
  ["projector.position[0]", { projector: { ...planar, position: [Number.NaN, 0, 0] } }],
  ["projector.rotation", { projector: { ...planar, rotation: [0, 0, 0, 0] } }],
  ["projector.size[1]", { projector: { ...planar, size: [1, -1, 1] } }],
  ["projector.size[0]", { projector: { ...planar, size: [1e20, 1, 1] } }],
  ["material", { material: "0" }],
  ["material", { material: 0.5 }],
  ["material", { material: 9 }],
  ["position", { position: [0, 0] }],
  ["width", { width: 1e10 }],
  ["width", { width: Number.NaN }],
  ["curve", { curve: 1000 }],
  ["curve", { curve: Number.NaN }],
  ["name", { name: 5 }],
  ["color", { color: "red" }],
])(
  "what a page says wrongly of new words is refused by its name, and nothing is put on: %s, %j",
  async (field, options) => {
    const { desk, texts, has } = deskWithFonts({ refuses: false });
    const before = desk.design;
    const refusal = await texts.add("Hello", { ...WORDS, ...options } as object).catch((thrown: unknown) => thrown);
    expect(refusal).toMatchObject({ code: "bad-argument", field });
    expect(desk.design).toBe(before);
    expect(has.size).toBe(0);
  },
);

it("a text wears what was chosen last, though a font that was chosen before comes later", async () => {
  const { desk, texts, measured } = deskWithFonts({ refuses: false });
  const id = await texts.add("Hello", WORDS);
  const before = desk.design;
  measured.waitFor("texelcast:fonts/lobster-400");
  const slow = texts.change(id, { font: shippedFont("lobster-400"), curve: 20 }, true);
  await texts.change(id, { font: shippedFont("inter-400") }, true);
  measured.arrive();
  await slow;
  const [layer] = desk.design.layers;
  expect(desk.design).not.toBe(before);
  expect(layer).toMatchObject({ curve: 20 });
  expect(layer?.type === "text" && desk.design.assets[layer.font]?.uri).toBe("texelcast:fonts/inter-400");
});

/** What the product says after texts that were typed one after another, each before the one before was measured. */
async function typedOn(before: string, typed: readonly string[], last: "typed" | "left" = "typed"): Promise<unknown> {
  const { desk, texts } = deskWithFonts({ refuses: false, lacks: "🦊🐻" });
  const id = await texts.add(before, WORDS);
  const told = await Promise.allSettled(
    typed.map((text, index) => texts.change(id, { text }, last === "left" && index === typed.length - 1)),
  );
  expect(told.at(-1)?.status, "the customer is told of a letter that could not be drawn").toBe("rejected");
  const [layer] = desk.shown.layers;
  return layer?.type === "text" && layer.text;
}

it("letters that are typed after one that cannot be drawn stay, and that one goes", async () => {
  expect(await typedOn("Ada", ["Ada🦊", "Ada🦊s"])).toBe("Adas");
  expect(await typedOn("Ada", ["Ada🦊", "Ada🦊s", "Ada🦊s"], "left")).toBe("Adas");
  expect(await typedOn("Ada", ["Ada🦊", "Ada🦊🐻", "Ada🦊🐻s", "Ada🦊🐻st"])).toBe("Adast");
  expect(await typedOn("Ada", ["Adax", "Ada🦊x", "Ada🦊yx"])).toBe("Adayx");
  expect(await typedOn("Ada", ["Ada🦊", "xAda🦊", "xda🦊"])).toBe("xda");
  expect(await typedOn("Ada", ["Ada🦊", "Ada🐻", "Ada🐻s"])).toBe("Adas");
});

it("what is put in at once with a letter that cannot be drawn goes with it", async () => {
  expect(await typedOn("Ada", ["Ada and a 🦊", "Ada and a 🦊!"])).toBe("Ada!");
});
