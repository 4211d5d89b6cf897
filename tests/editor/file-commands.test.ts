import { describe, expect, it } from "vitest";
import type { AssetLibrary } from "../../web/editor/state/asset-library.ts";
import type { DecalCommands } from "../../web/editor/state/decal-commands.ts";
import type { OpenModel } from "../../web/editor/state/design-state.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { FileCommands, type FileCommandsParts } from "../../web/editor/state/file-commands.ts";
import { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { Store } from "../../web/editor/state/store.ts";
import { Tasks } from "../../web/editor/state/tasks.ts";

/** Files as they are chosen, on a model that is open; a picture called "broken" cannot be read. */
function chosen(...names: readonly string[]) {
  const store = new Store<EditorState>({ ...INITIAL_STATE, model: {} as OpenModel });
  const added: string[] = [];
  const library = {
    add: async (name: string) => {
      if (name.startsWith("broken")) throw new Error(`${name} is no picture.`);
      return {};
    },
    release: () => {},
  } as unknown as AssetLibrary;
  const decals = { add: (name: string) => void added.push(name) } as unknown as DecalCommands;
  const board = new NoticeBoard(store);
  const opened: string[] = [];
  const session = { recordsLater: () => {} };
  const palettes = () => ({ open: async ({ name }: File) => void opened.push(name) });
  const parts = { store, library, decals, board, palettes, tasks: new Tasks(store), admission: null, session };
  const files = new FileCommands(parts as unknown as FileCommandsParts);
  return {
    added,
    /** The palettes that were opened. */
    opened,
    told: () => store.state.notices.map(({ title }) => title),
    open: () => files.openFiles(names.map((name) => ({ path: name, file: new File(["bytes"], name) }))),
  };
}

describe("several pictures at once", () => {
  it("are all added but for those that cannot be read, which are named", async () => {
    const { open, added, told } = chosen("broken.png", "a.png", "broken.jpg", "d.svg");
    await open();
    expect(added).toEqual(["a", "d"]);
    expect(told()).toEqual(["Could not open broken.png", "Could not open broken.jpg"]);
  });

  it("are named in one notice where more of them cannot be read than there is room for notices", async () => {
    const { open, added, told } = chosen("broken1.png", "broken2.png", "broken3.png", "a.png", "broken4.png");
    await open();
    expect(added).toEqual(["a"]);
    expect(told()).toEqual(["Could not open broken1.png, broken2.png, broken3.png, broken4.png"]);
  });
});

describe("a palette that is dropped on the page", () => {
  it("is opened as its own button opens it, beside the pictures that came with it", async () => {
    const { open, added, opened, told } = chosen("warm.gpl", "logo.png");
    await open();
    expect([opened, added, told()]).toEqual([["warm.gpl"], ["logo"], []]);
  });
});
