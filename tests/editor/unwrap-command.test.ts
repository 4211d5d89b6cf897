import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { ModelRef, OpenModel } from "../../web/editor/state/design-state.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { Store } from "../../web/editor/state/store.ts";
import { Tasks } from "../../web/editor/state/tasks.ts";
import { UnwrapCommand, type UnwrapCommandParts, type Unwrapper } from "../../web/editor/state/unwrap-command.ts";

const refOf = (name: string): ModelRef => ({ source: { name, bytes: new Uint8Array() }, title: name, demoId: null });

/** A model is open; what is unwrapped comes as `unwrap` says. */
function page(unwrap: (size: number) => Promise<Uint8Array<ArrayBuffer>>) {
  const open = { ref: refOf("mug.glb"), info: {} } as OpenModel;
  const store = new Store<EditorState>({ ...INITIAL_STATE, model: open });
  const board = new NoticeBoard(store);
  const unwrapper: Unwrapper = (_, { size }) => unwrap(size);
  const parts = { store, board, tasks: new Tasks(store), unwrap: unwrapper };
  const command = new UnwrapCommand(parts as unknown as UnwrapCommandParts);
  const opened: string[] = [];
  const openBare = (count = 1): Promise<void> =>
    command.openBare(
      { ref: refOf("chair.gltf"), materials: Array.from({ length: count }, (_, i) => i) },
      async ({ source }) => void opened.push(source.name),
      () => void opened.push("cancelled"),
    );
  return { store, opened, openBare, told: () => store.state.notices.map(({ title, code }) => [title, code]) };
}

const GLB = new Uint8Array();

describe("a model that was refused for lack of texture coordinates", () => {
  it("is opened as a GLB once it is unwrapped", async () => {
    const { openBare, opened, told } = page(async () => GLB);
    await openBare();
    expect([opened, told()]).toEqual([["chair.glb"], []]);
  });

  it("is not opened over a model that came meanwhile", async () => {
    let finish = (_: Uint8Array<ArrayBuffer>): void => undefined;
    const { store, openBare, opened, told } = page(
      () =>
        new Promise((resolve) => {
          finish = resolve;
        }),
    );
    const done = openBare();
    store.set({ model: { ref: refOf("lamp.glb"), info: {} } as OpenModel });
    finish(GLB);
    await done;
    expect([opened, told()]).toEqual([[], []]);
  });

  it("says why it could not be unwrapped, and only hears of it where that was cancelled", async () => {
    for (const [code, ended, notices] of [
      ["bad-size", [], [["Could not unwrap the model", "bad-size"]]],
      ["cancelled", ["cancelled"], []],
    ] as const) {
      const { openBare, opened, told } = page(() => Promise.reject(new TexelcastError(code, "No.")));
      await openBare();
      expect([opened, told()]).toEqual([ended, notices]);
    }
  });

  it("gets a larger texture where its parts do not fit, as large as a viewer holds", async () => {
    const sizes: number[] = [];
    const least = (enough: number) => async (size: number) => {
      sizes.push(size);
      if (size < enough) throw new TexelcastError("bad-size", "No.");
      return GLB;
    };
    const many = page(least(2048));
    await many.openBare();
    expect([many.opened, many.told()]).toEqual([["chair.glb"], []]);
    const tooMany = page(least(8192));
    await tooMany.openBare();
    await tooMany.openBare(8);
    expect([tooMany.opened, tooMany.told()]).toEqual([[], [["Could not unwrap the model", "bad-size"]]]);
    expect(sizes).toEqual([1024, 2048, 1024, 2048, 4096, 1024, 2048]);
  });

  it("gets smaller textures the more materials it has", async () => {
    const sizes: number[] = [];
    const { openBare } = page(async (size) => {
      sizes.push(size);
      return GLB;
    });
    for (const count of [1, 32, 33, 129, 2000]) await openBare(count);
    expect(sizes).toEqual([1024, 1024, 512, 256, 256]);
  });
});
