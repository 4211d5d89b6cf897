/** Says when the browser has taken the graphics away and keeps them, and takes it back when they return after all. */
import type { ModelViewer } from "../../viewer/viewer-api.ts";
import type { NoticeBoard } from "./notice-board.ts";

export interface GraphicsLossParts {
  readonly viewer: Pick<ModelViewer, "on">;
  readonly board: NoticeBoard;
  /** Keeps what is not kept yet; the page is loaded again after it, whatever became of it: it asks by itself then. */
  readonly keep: () => Promise<unknown>;
}

export function tellOfLostGraphics({ viewer, board, keep }: GraphicsLossParts): void {
  let notice = 0;
  viewer.on("graphics", ({ lost }) => {
    if (!lost) {
      board.dismiss(notice);
      return;
    }
    const { graphicsLost, graphicsLostBody, graphicsLostHint, reload } = board.strings.notices;
    const run = (): void => void keep().then(reloadPage, reloadPage);
    notice = board.info({
      ...{ title: graphicsLost, message: graphicsLostBody, hint: graphicsLostHint, stays: true },
      action: { label: reload, run },
    });
  });
}

const reloadPage = (): void => location.reload();
