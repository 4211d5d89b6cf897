/** Says when the browser has taken a view's graphics away and keeps them, and takes it back when they return after all. */
import type { ModelViewer, TextureView } from "../../viewer/viewer-api.ts";
import type { NoticeBoard } from "./notice-board.ts";

export interface GraphicsLossParts {
  readonly viewer: Pick<ModelViewer, "on">;
  readonly textureView: Pick<TextureView, "on">;
  readonly board: NoticeBoard;
  /** Keeps what is not kept yet; the page is loaded again after it, whatever became of it: it asks by itself then. */
  readonly keep: () => Promise<unknown>;
}

/** Views mostly lose theirs together: one notice is for both. */
export function tellOfLostGraphics({ viewer, textureView, board, keep }: GraphicsLossParts): void {
  const lostOnes = new Set<"graphicsLost" | "flatGraphicsLost">();
  let notice = 0;
  const follow = (title: "graphicsLost" | "flatGraphicsLost", lost: boolean): void => {
    if (!lost) {
      if (lostOnes.delete(title) && lostOnes.size === 0) board.dismiss(notice);
      return;
    }
    lostOnes.add(title);
    if (lostOnes.size > 1) return;
    const words = board.strings.notices;
    const run = (): void => void keep().then(reloadPage, reloadPage);
    notice = board.info({
      ...{ title: words[title], message: words.graphicsLostBody, hint: words.graphicsLostHint, stays: true },
      action: { label: words.reload, run },
    });
  };
  viewer.on("graphics", ({ lost }) => follow("graphicsLost", lost));
  textureView.on("graphics", ({ lost }) => follow("flatGraphicsLost", lost));
}

const reloadPage = (): void => location.reload();
