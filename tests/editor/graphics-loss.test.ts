import { expect, test } from "vitest";
import { INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { tellOfLostGraphics } from "../../web/editor/state/graphics-loss.ts";
import { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { Store } from "../../web/editor/state/store.ts";
import { EventHub } from "../../web/viewer/event-hub.ts";
import type { ModelViewerEvents, TextureViewEvents } from "../../web/viewer/viewer-api.ts";

test("of graphics that both views have lost there is one notice, until both have theirs again", () => {
  const store = new Store(INITIAL_STATE);
  const [viewer, textureView] = [new EventHub<ModelViewerEvents>(), new EventHub<TextureViewEvents>()];
  tellOfLostGraphics({ viewer, textureView, board: new NoticeBoard(store), keep: async () => {} });
  const told = (): string[] => store.state.notices.map(({ title }) => title);

  textureView.emit("graphics", { lost: true });
  viewer.emit("graphics", { lost: true });
  expect(told()).toEqual(["The texture’s view has stopped"]);
  textureView.emit("graphics", { lost: false });
  expect(told()).toHaveLength(1);
  viewer.emit("graphics", { lost: false });
  expect(told()).toEqual([]);
});
