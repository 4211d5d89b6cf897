/** The tools and which of them is chosen. Tools register themselves here; the rail and the options bar read it. */
import { LOOK_ONLY } from "../../viewer/look-only.ts";
import type { ModelViewer, TextureView, ToolInput } from "../../viewer/viewer-api.ts";
import { diagonalOf } from "../state/design-state.ts";
import type { EditorState } from "../state/editor-state.ts";
import { letterOf } from "../state/letter-key.ts";
import type { NoticeBoard } from "../state/notice-board.ts";
import type { Store } from "../state/store.ts";
import { isPixelated } from "./pixel-mode.ts";
import { TOOL_IDS, type Tool, type ToolId } from "./tool.ts";
import { brushSizes, DEFAULT_COLORS, type ToolSettings, withRecent } from "./tool-settings.ts";

export interface ToolboxParts {
  readonly viewer: ModelViewer;
  readonly textureView: TextureView;
  readonly store: Store<EditorState>;
  readonly board: NoticeBoard;
}

export class Toolbox {
  readonly #parts: ToolboxParts;
  readonly #tools = new Map<ToolId, Tool>();

  constructor(parts: ToolboxParts) {
    this.#parts = parts;
    let seen = parts.store.state;
    parts.store.subscribe(() => {
      const before = seen;
      seen = parts.store.state;
      if (seen.readonly !== before.readonly) this.#followReadonly(seen.readonly);
      if (seen.model !== before.model) {
        for (const tool of this.#tools.values()) tool.forget?.();
        this.#measure();
      }
      if (seen.targets !== before.targets || seen.toolSettings.pixelMode !== before.toolSettings.pixelMode) {
        this.#showPixels();
      }
      // What the rail no longer offers cannot stay chosen.
      if (!(this.active?.offered?.() ?? true)) this.choose(this.active?.instead ?? "brush");
    });
  }

  /** In the rail's order. */
  get all(): readonly Tool[] {
    return TOOL_IDS.flatMap((id) => this.#tools.get(id) ?? []);
  }

  /** Those that the rail offers now. */
  get offered(): readonly Tool[] {
    if (this.#parts.store.state.readonly) return [];
    return this.all.filter((tool) => tool.offered?.() ?? true);
  }

  /** Undefined before the first one was registered. */
  get active(): Tool | undefined {
    return this.#tools.get(this.#parts.store.state.tool);
  }

  get settings(): ToolSettings {
    return this.#parts.store.state.toolSettings;
  }

  /** Of a brush, on the open model. */
  get sizes(): ReturnType<typeof brushSizes> {
    return brushSizes(diagonalOf(this.#parts.store.state.model));
  }

  /** Whether the shown texture is painted texel by texel: as the user says, else where it is small. */
  get pixelMode(): boolean {
    const { state } = this.#parts.store;
    return isPixelated(state, state.material);
  }

  /** Adds a tool, or takes the place of one of the same id. */
  register(...tools: readonly Tool[]): void {
    for (const tool of tools) this.#tools.set(tool.id, tool);
  }

  /** An unknown id changes nothing. */
  choose(id: ToolId): void {
    const { store, board } = this.#parts;
    const tool = this.#tools.get(id);
    if (!tool || id === store.state.tool || store.state.readonly) return;
    this.finish();
    this.active?.deactivate?.();
    store.set({ tool: id });
    this.#use(tool.input);
    tool.activate?.();
    board.announce(board.strings.tools.chosen(tool.label(board.strings)));
  }

  configure(settings: Partial<ToolSettings>): void {
    this.#parts.store.set({ toolSettings: { ...this.settings, ...settings } });
  }

  /** Makes a colour the one that is painted with, and remembers it. */
  useColor(color: string): void {
    this.configure({ color, recent: withRecent(this.settings.recent, color) });
  }

  swapColors(): void {
    const { color, background } = this.settings;
    this.configure({ color: background, background: color });
  }

  resetColors(): void {
    this.configure(DEFAULT_COLORS);
  }

  /** Records what the chosen tool has under way. */
  finish(): void {
    this.active?.finish?.();
  }

  /** Takes back what the chosen tool has under way; false where nothing is. */
  cancel(): boolean {
    return this.active?.cancel?.() ?? false;
  }

  /** Escape where something is under way, the chosen tool's keys, and those that choose tools and colours. True when the key was one. */
  handleKey(event: KeyboardEvent): boolean {
    if (event.altKey) return false;
    if (event.key === "Escape" && this.cancel()) return true;
    if (this.active?.key?.(event, this.#viewOf(event))) return true;
    if (event.shiftKey) return false;
    const key = letterOf(event).toUpperCase();
    const meant = this.offered.filter(({ shortcut }) => shortcut === key);
    // Tools that share a key take turns.
    const tool = meant[(meant.findIndex(({ id }) => id === this.active?.id) + 1) % meant.length];
    if (tool) this.choose(tool.id);
    else if (key === "X") this.swapColors();
    else if (key === "D") this.resetColors();
    else return false;
    return true;
  }

  #viewOf(event: KeyboardEvent): "model" | "texture" | null {
    const path = event.composedPath();
    if (path.includes(this.#parts.viewer.element)) return "model";
    return path.includes(this.#parts.textureView.element) ? "texture" : null;
  }

  /** The views' pointer is the chosen tool's, or nobody's while the design is only looked at. */
  #followReadonly(readonly: boolean): void {
    const { active } = this;
    if (readonly) active?.deactivate?.();
    this.#use(readonly ? LOOK_ONLY : (active?.input ?? null));
    if (!readonly) active?.activate?.();
  }

  #use(input: ToolInput | null): void {
    const { viewer, textureView, store } = this.#parts;
    viewer.setTool(input);
    textureView.setTool(input, (uv) => {
      const { material } = store.state;
      return material === null ? null : viewer.surface.atUv(material, uv);
    });
  }

  #showPixels(): void {
    const { state } = this.#parts.store;
    for (const material of state.targets.keys()) {
      const byUser = this.settings.pixelMode;
      this.#parts.viewer.setPixelated(material, byUser ?? (isPixelated(state, material) || null));
    }
  }

  /** A size in metres means nothing on a model of another scale. */
  #measure(): void {
    if (!this.#parts.store.state.model) return;
    this.configure({ size: this.sizes.usual, pixelMode: null });
  }
}
