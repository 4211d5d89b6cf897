/** Gives the open model texture coordinates in which its parts share no texels: one step, which an undo takes back. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { MaterialInfo, ModelSource, TargetInfo } from "../../engine/engine-api.ts";
import { SHARED_TEXELS } from "../../engine/shared-texels.ts";
import type { Design, DesignLayer } from "../document/design.ts";
import { materialsIn, walkLayers } from "../document/layer-tree.ts";
import { liesOnTexture } from "../document/mirror-layer.ts";
import type { Strings } from "../strings.ts";
import { type BareModel, takesPaintUnwrapped } from "./bare-model-error.ts";
import { changedModel } from "./changed-model.ts";
import { patchLayers } from "./design-edits.ts";
import type { DesignSession } from "./design-session.ts";
import type { ModelRef } from "./design-state.ts";
import type { EditorState } from "./editor-state.ts";
import type { ModelSession } from "./model-session.ts";
import type { NoticeBoard } from "./notice-board.ts";
import { isCancelled } from "./notices.ts";
import type { Store } from "./store.ts";
import type { TaskHandle, Tasks } from "./tasks.ts";

/** Sides of the new textures, texels: the old one's, within these. */
const LEAST_SIZE = 1024;
const MOST_SIZE = 4096;
/** Of all new textures together, texels: a viewer holds them on the GPU, in 180 MB. A CAD model may have a hundred materials. */
const MOST_TEXELS = 2 ** 25;
/** However many they are. */
const LEAST_OF_MANY = 256;

/** Unwraps materials of a model, and gives it as a GLB. */
export type Unwrapper = (
  source: ModelSource,
  options: { readonly materials: readonly number[]; readonly size: number },
  task: TaskHandle,
  strings: Strings,
) => Promise<Uint8Array<ArrayBuffer>>;

export interface UnwrapCommandParts {
  readonly store: Store<EditorState>;
  readonly session: DesignSession;
  readonly models: ModelSession;
  readonly board: NoticeBoard;
  readonly tasks: Tasks;
  readonly unwrap: Unwrapper;
  /** Lets a model stay in the project of the one whose place it takes. */
  readonly succeed: (before: ModelRef, after: ModelRef) => void;
}

export const sharesTexels = ({ overlappingTexels, coveredTexels }: TargetInfo): boolean =>
  overlappingTexels > SHARED_TEXELS * coveredTexels;

/** Materials that take no paint until they are unwrapped, and those whose parts share texels (of those that are open). */
export function materialsToUnwrap({ model, targets }: Pick<EditorState, "model" | "targets">): number[] {
  const needs = (material: MaterialInfo): boolean => {
    const target = targets.get(material.index);
    return takesPaintUnwrapped(material) || (target !== undefined && sharesTexels(target));
  };
  return (model?.info.materials ?? []).filter(needs).map(({ index }) => index);
}

export class UnwrapCommand {
  readonly #parts: UnwrapCommandParts;

  constructor(parts: UnwrapCommandParts) {
    this.#parts = parts;
  }

  /**
   * Unwraps what `materialsToUnwrap` finds and opens the model so, with its design. What lies on the former coordinates is
   * hidden, not taken away, and the user is told.
   */
  run(): Promise<void> {
    const { store, board } = this.#parts;
    return this.#run(materialsToUnwrap(store.state), () => board.announce(board.strings.announce.unwrapped));
  }

  /** Unwraps what takes no paint until then, and nothing else: what is painted stays on the texture that it has. */
  runForBare(): Promise<void> {
    const { store, board } = this.#parts;
    const { partUnwrapped, partUnwrappedUndo } = board.strings.notices;
    const bare = (store.state.model?.info.materials ?? []).filter(takesPaintUnwrapped).map(({ index }) => index);
    return this.#run(bare, () => board.info({ title: partUnwrapped, message: partUnwrappedUndo }));
  }

  /** @param done tells the user */
  async #run(materials: readonly number[], done: () => void): Promise<void> {
    const { store, session, models, board, succeed } = this.#parts;
    const { strings } = board;
    const before = store.state.model?.ref;
    if (!before || materials.length === 0 || store.state.readonly || store.state.switching) return;
    try {
      const ref = await this.#unwrapped({ ref: before, materials }, this.#size(materials));
      await session.settled();
      // Another model was opened meanwhile: that one is what the user wants to see.
      if (store.state.model?.ref !== before) return;
      const left = session.recordedDesign;
      let { design, hidden } = hideFlat(left, materials);
      // A size that was chosen for the old texture may be too small for all of its parts.
      const settings = new Map([...store.state.targetSettings].filter(([material]) => !materials.includes(material)));
      models.rememberSettings(ref, settings);
      succeed(before, ref);
      const record = (): void => {
        // What was done while the model was being read is on it, too.
        if (session.recordedDesign !== left) ({ design, hidden } = hideFlat(session.recordedDesign, materials));
        session.recordModel(ref, design, strings.steps.unwrap);
      };
      await models.open(ref, design, record, { keepsView: true });
      done();
      if (hidden > 0) {
        board.info({ title: strings.announce.unwrapped, message: strings.notices.flatHidden(hidden), stays: true });
      }
    } catch (thrown) {
      board.error(strings.errors.couldNotUnwrap, thrown);
    }
  }

  /**
   * Unwraps a model that was refused without it, and gives it to `open`; not where another one was opened meanwhile. What is
   * open stays so until then, and where that fails or is cancelled.
   *
   * @param cancelled runs in the latter case
   */
  async openBare(model: BareModel, open: (unwrapped: ModelRef) => Promise<void>, cancelled: () => void): Promise<void> {
    const { store, board } = this.#parts;
    const before = store.state.model?.ref;
    try {
      const unwrapped = await this.#unwrapped(model, sizeFor(model.materials.length, LEAST_SIZE));
      if (store.state.model?.ref === before) await open(unwrapped);
    } catch (thrown) {
      if (isCancelled(thrown)) cancelled();
      else board.error(board.strings.errors.couldNotUnwrap, thrown);
    }
  }

  async #unwrapped({ ref, materials }: BareModel, least: number): Promise<ModelRef> {
    const { board, tasks, unwrap } = this.#parts;
    const { strings } = board;
    const bytes = await tasks.run(strings.tasks.unwrapping, async (task) => {
      for (let size = least; ; size *= 2) {
        try {
          return await unwrap(ref.source, { materials, size }, task, strings);
        } catch (thrown) {
          // Very many parts want more texels for the room between them.
          const isFull = thrown instanceof TexelcastError && thrown.code === "bad-size";
          if (!isFull || sizeFor(materials.length, Math.min(MOST_SIZE, size * 2)) <= size) throw thrown;
        }
      }
    });
    return changedModel(ref, bytes);
  }

  #size(materials: readonly number[]): number {
    const { targets } = this.#parts.store.state;
    const sides = materials.flatMap((material) => {
      const target = targets.get(material);
      return target ? [target.width, target.height] : [];
    });
    return sizeFor(materials.length, Math.min(MOST_SIZE, Math.max(LEAST_SIZE, ...sides)));
  }
}

/** Halves the side until so many textures have room. */
function sizeFor(count: number, side: number): number {
  return side > LEAST_OF_MANY && count * side * side > MOST_TEXELS ? sizeFor(count, side / 2) : side;
}

/** What lies on the texture itself would lie elsewhere on the model. Faces keep their numbers; charts are others. */
function hideFlat(design: Design, materials: readonly number[]): { readonly design: Design; readonly hidden: number } {
  const isBound = (layer: DesignLayer): boolean =>
    liesOnTexture(layer) || (layer.type === "fill" && layer.parts?.kind === "charts");
  const ids = [...walkLayers(design, { strokes: false })]
    .map(({ layer }) => layer)
    .filter((layer) => layer.visible && isBound(layer) && materialsIn(layer).some((own) => materials.includes(own)))
    .map(({ id }) => id);
  return { design: ids.length === 0 ? design : patchLayers(design, ids, { visible: false }), hidden: ids.length };
}
