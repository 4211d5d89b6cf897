import { describe, expect, it } from "vitest";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { Store } from "../../web/editor/state/store.ts";

describe("when the user works on", () => {
  const work = () => {
    const store = new Store<EditorState>(INITIAL_STATE);
    const board = new NoticeBoard(store);
    const titles = (): string[] => store.state.notices.map(({ title }) => title);
    return { store, board, titles };
  };

  it("what was only worth a glance goes, and errors and what stays do not", () => {
    const { store, board, titles } = work();
    board.info({ title: "Glance", message: "" });
    board.info({ title: "Stays", message: "", stays: true });
    board.error("Error", new Error("It failed."));
    board.dismissInfos(store.state.notices);
    expect(titles()).toEqual(["Stays", "Error"]);
  });

  it("what that very work has brought about is read, even where it was told of before", () => {
    const { store, board, titles } = work();
    board.info({ title: "Before", message: "" });
    board.info({ title: "Again", message: "" });
    const before = store.state.notices;
    board.info({ title: "Again", message: "" });
    board.info({ title: "Made for another model", message: "" });
    board.dismissInfos(before);
    expect(titles()).toEqual(["Again", "Made for another model"]);
  });
});
