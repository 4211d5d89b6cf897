/** What tools work with. */
import type { Engine } from "../../engine/engine-api.ts";
import type { ModelViewer, TextureView } from "../../viewer/viewer-api.ts";
import type { AssetLibrary } from "../state/asset-library.ts";
import type { BareParts } from "../state/bare-parts.ts";
import type { DecalReach } from "../state/decal-reach.ts";
import type { DesignSession } from "../state/design-session.ts";
import type { EditorState } from "../state/editor-state.ts";
import type { NoticeBoard } from "../state/notice-board.ts";
import type { Store } from "../state/store.ts";
import type { Toolbox } from "./toolbox.ts";

export interface ToolContext {
  readonly engine: Engine;
  readonly viewer: ModelViewer;
  readonly textureView: TextureView;
  readonly session: DesignSession;
  readonly library: AssetLibrary;
  readonly store: Store<EditorState>;
  readonly board: NoticeBoard;
  readonly tools: Toolbox;
  readonly reach: DecalReach;
  readonly bare: BareParts;
}
