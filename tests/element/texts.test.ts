import { expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { AssetLibrary } from "../../web/editor/state/asset-library.ts";
import { DesignSession } from "../../web/editor/state/design-session.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { Store } from "../../web/editor/state/store.ts";
import { Desk } from "../../web/element/desk/desk.ts";
import type { DeskHooks } from "../../web/element/desk/desk-settings.ts";
import { Texts } from "../../web/element/desk/texts.ts";
import { english } from "../../web/element/words/english.ts";
import type { Engine } from "../../web/engine/engine-api.ts";
import { readShippedFont } from "../../web/engine/shipped-fonts.ts";
import type { ModelViewer } from "../../web/viewer/viewer-api.ts";
import { FRONT } from "../support/layers.ts";

const FONT = await readShippedFont("bebas-neue-400");

/** A desk whose engine keeps fonts, and measures words unless it `refuses`. */
function deskWithFonts({ refuses }: { refuses: boolean }) {
  const has = new Set<string>();
  const engine = {
    setFont: async (key: string) => {
      has.add(key);
      return { name: "Hand" };
    },
    removeAsset: async (key: string) => void has.delete(key),
    setLayers: () => undefined,
    measureText: async () => {
      if (refuses) throw new TexelcastError("bad-font", "The letters cannot be drawn.");
      return { width: 2, height: 1, inkWidth: 2, inkHeight: 1 };
    },
  } as unknown as Engine;
  const viewer = { setDecals: () => undefined, surfaceAtCentre: () => null } as unknown as ModelViewer;
  const store = new Store<EditorState>(INITIAL_STATE);
  const library = new AssetLibrary(engine);
  const session = new DesignSession({ engine, viewer, library, store, later: () => undefined });
  const hooks = {
    settings: () => ({ readonly: false, maxDecals: null, beforeAccept: null, words: english }),
    changed: () => undefined,
    selected: () => undefined,
    announce: () => undefined,
  } as unknown as DeskHooks;
  const desk = new Desk({ engine, viewer, store, library, session, hooks, loadHands: async () => viewer as never });
  return { desk, texts: new Texts(desk), has };
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
