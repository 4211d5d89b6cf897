/** `window.texelcast`: the page's engine for tests. docs/test-handle.md is its manual; what is there stays. */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Design } from "../editor/document/index.ts";
import type { Editor } from "../editor/state/editor.ts";
import type { Engine, EngineStats } from "../engine/engine-api.ts";

export interface TestHandleStats extends EngineStats {
  /** Revision of the newest design given to the engine, and of the newest update shown. */
  readonly revision: number;
  readonly shownRevision: number;
  /** Updates that reached the views. */
  readonly updates: number;
  /** Of the newest update. */
  readonly engineMilliseconds: number;
  readonly uploadMilliseconds: number;
  readonly frames: number;
}

export interface TestHandle {
  /** Resolves once the first model is open, or the page has said why it is not. */
  readonly ready: Promise<void>;
  /** Resolves when no work is under way and the views show the newest design. */
  idle(): Promise<void>;
  /** Resolves once the newest recorded step is kept in the browser, or was refused by it. */
  kept(): Promise<void>;
  /** Texels of the shown material's target: RGBA, straight alpha, row 0 at the top. */
  readTexels(x: number, y: number, width: number, height: number): Promise<Uint8Array>;
  /** FNV-1a, 64 bits, 16 hex digits; the whole target without a region. */
  hash(region?: { x: number; y: number; width: number; height: number }): Promise<string>;
  /** The document, with what a gesture under way shows. */
  design(): Design;
  select(id: string | null): void;
  stats(): Promise<TestHandleStats>;
  /** Where a point of model space stands on the page, client pixels; null behind the camera. */
  project(x: number, y: number, z: number): { x: number; y: number } | null;
  readonly engine: Engine;
}

declare global {
  interface Window {
    texelcast: TestHandle;
  }
}

export function makeTestHandle(editor: Editor, ready: Promise<void>): TestHandle {
  const material = (): number => {
    const shown = editor.store.state.material;
    if (shown === null) throw new TexelcastError("no-model", "No model is open, so there are no texels to read.");
    return shown;
  };
  return {
    ready,
    engine: editor.engine,
    idle: async () => {
      do {
        await editor.idle();
        await nextFrame();
      } while (editor.textureView.isBehind);
    },
    kept: () => editor.autosave.flush(),
    readTexels: async (x, y, width, height) => editor.engine.readTexels(material(), x, y, width, height),
    hash: async (region) => editor.engine.hash(material(), region),
    design: () => editor.session.design,
    select: (id) => editor.layers.select(id),
    project: (x, y, z) => editor.viewer.clientPosition([x, y, z]),
    stats: async () => {
      const { update, uploadMilliseconds, updates } = editor.figures.state;
      return {
        ...(await editor.engine.stats()),
        revision: editor.session.revision,
        shownRevision: update?.revision ?? 0,
        updates,
        engineMilliseconds: update?.milliseconds ?? 0,
        uploadMilliseconds,
        frames: editor.viewer.statistics.frames,
      };
    },
  };
}

/** Settles once what asked for a frame before has had it; at once where nobody sees the page, which gets none. */
const nextFrame = (): Promise<void> =>
  new Promise((resolve) => {
    if (document.hidden) resolve();
    else requestAnimationFrame(() => resolve());
  });
