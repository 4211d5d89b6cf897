import { expect, it, vi } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { emptyDesign } from "../../web/editor/document/index.ts";
import { INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { EngineTrouble } from "../../web/editor/state/engine-trouble.ts";
import { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { Store } from "../../web/editor/state/store.ts";
import type { EngineStats } from "../../web/engine/engine-api.ts";

const TOO_LARGE = new TexelcastError("out-of-budget", "The tiles of the layers need 1100 MiB of 1024.");

/** A page whose engine draws or refuses what it is told, as the test says. */
function page() {
  const store = new Store(INITIAL_STATE);
  const drawn = vi.fn(async (): Promise<void> => undefined);
  const undo = vi.fn();
  const engine = { idle: drawn, stats: async () => ({}) as EngineStats };
  const trouble = new EngineTrouble({ engine, board: new NoticeBoard(store), store, send: () => undefined, undo });
  const tell = async (): Promise<void> => {
    trouble.tell(TOO_LARGE);
    await new Promise((resolve) => setTimeout(resolve));
  };
  const told = () => store.state.notices.map(({ title, action }) => [title, action?.label]);
  const change = async (fits: boolean): Promise<void> => {
    if (!fits) drawn.mockRejectedValueOnce(TOO_LARGE);
    store.set({ design: { ...emptyDesign() } });
    await new Promise((resolve) => setTimeout(resolve));
  };
  return { store, tell, undo, told, change, drawn };
}

it("tells of layers that need more memory than there is by that, with the step back, until they need it no longer", async () => {
  const { store, tell, undo, told, change } = page();
  await tell();
  const notice = [["The layers need more memory than there is", "Undo the last step"]];
  expect(told()).toEqual(notice);
  store.state.notices[0]?.action?.run();
  expect(undo).toHaveBeenCalledOnce();

  await change(false);
  await tell();
  expect(told()).toEqual(notice);
  await change(true);
  expect(told()).toEqual([]);
  await tell();
  expect(told()).toEqual(notice);
});

it("asks the engine nothing more where there is memory for all", async () => {
  const { tell, change, drawn } = page();
  await tell();
  await change(true);
  expect(drawn).toHaveBeenCalledOnce();
  await change(true);
  expect(drawn).toHaveBeenCalledOnce();
});
