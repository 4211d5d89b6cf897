import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { encodeDataUri } from "../../web/editor/document/data-uri.ts";
import {
  type Design,
  type DesignAsset,
  emptyDesign,
  makeDecalLayer,
  makeTextLayer,
  serialiseDesign,
} from "../../web/editor/document/index.ts";
import type { Admission } from "../../web/editor/state/admission.ts";
import type { AssetLibrary } from "../../web/editor/state/asset-library.ts";
import { ClipboardCommands, type ClipboardCommandsParts } from "../../web/editor/state/clipboard-commands.ts";
import type { OpenModel } from "../../web/editor/state/design-state.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { Store } from "../../web/editor/state/store.ts";
import { Tasks } from "../../web/editor/state/tasks.ts";

const projector = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;
const picture = (...bytes: number[]): DesignAsset => ({
  type: "image/png",
  uri: encodeDataUri("image/png", new Uint8Array(bytes)),
});
const CLIP: Design = {
  ...emptyDesign(),
  assets: {
    known: picture(1),
    strange: picture(2, 2),
    inter: { type: "font/ttf", uri: "texelcast:fonts/inter-700" },
  },
  layers: [
    makeDecalLayer({ id: "a", asset: "known", projector }),
    makeDecalLayer({ id: "b", asset: "strange", projector }),
    makeTextLayer({ id: "c", text: "Ada", font: "inter", projector }),
  ],
};

/** A clipboard in an editor whose library has the picture "known"; what is put, asked and told by it. */
function clipboardWith(admission: Admission | null, state: Partial<EditorState> = {}) {
  const store = new Store<EditorState>({ ...INITIAL_STATE, model: {} as OpenModel, ...state });
  const put: Design[] = [];
  const released: string[] = [];
  const parts = {
    store,
    admission,
    board: new NoticeBoard(store),
    tasks: new Tasks(store),
    session: { recordsLater: () => {} },
    layers: { put: (clip: Design) => void put.push(clip) },
    library: {
      engineKey: ({ uri }: DesignAsset) => (uri === CLIP.assets.known?.uri ? "picture-1" : undefined),
      adopt: async (design: Design) => design,
      release: (assets: Iterable<DesignAsset>) => void released.push(...[...assets].map(({ uri }) => uri)),
    } as unknown as AssetLibrary,
  };
  const clipboard = new ClipboardCommands(parts as unknown as ClipboardCommandsParts);
  const told = (): string[] => store.state.notices.map(({ title, message }) => `${title}: ${message}`);
  return { paste: () => clipboard.paste(serialiseDesign(CLIP)), put, released, told };
}

describe("layers from the clipboard", () => {
  it("come with the pictures as the page around admits them; those that it has seen are not asked about again", async () => {
    const asked: string[] = [];
    const { paste, put } = clipboardWith({
      checkRoom: (more) => void asked.push(`room for ${more}`),
      admit: async (kind, name, bytes) => {
        asked.push(`${kind} ${name}: ${bytes.join()}`);
        return new Uint8Array([7]);
      },
    });
    await paste();
    expect(asked).toEqual(["room for 3", "picture strange: 2,2", "room for 3"]);
    expect(put).toHaveLength(1);
    expect(put[0]?.assets).toEqual({ ...CLIP.assets, strange: picture(7) });
  });

  it.each(["checkRoom", "admit"] as const)("are not put where the page around refuses them by %s", async (by) => {
    const refusal = new TexelcastError("refused", "Not here.");
    const { paste, put, told } = clipboardWith({
      checkRoom: () => {
        if (by === "checkRoom") throw refusal;
      },
      admit: async () => {
        throw refusal;
      },
    });
    await paste();
    expect(put).toEqual([]);
    expect(told()).toEqual(["Could not paste: Not here."]);
  });

  it("are put as they are where there is no page around, and let go of afterwards", async () => {
    const { paste, put, released } = clipboardWith(null);
    await paste();
    expect(put).toEqual([CLIP]);
    expect(released).toEqual(Object.values(CLIP.assets).map(({ uri }) => uri));
  });

  it("are not put where the design is only looked at, nor without a model, and the user is told", async () => {
    for (const state of [{ readonly: true }, { model: null }]) {
      const { paste, put, told } = clipboardWith(null, state);
      await paste();
      expect(put).toEqual([]);
      expect(told()).toHaveLength(1);
    }
  });
});
