/** Shows another variant of the open model's materials, as one step; what was painted on the one before goes along. */
import type { ModelSource } from "../../engine/engine-api.ts";
import { type Variants, variantsOf, withVariant } from "../../engine/material-variants.ts";
import { type Design, layerMaterials, materialsOf } from "../document/design.ts";
import { mapLayers, walkLayers } from "../document/layer-tree.ts";
import { changedModel } from "./changed-model.ts";
import type { DesignSession } from "./design-session.ts";
import type { ModelRef } from "./design-state.ts";
import type { EditorState, TargetSettings } from "./editor-state.ts";
import type { ModelSession } from "./model-session.ts";
import type { NoticeBoard } from "./notice-board.ts";
import type { Store } from "./store.ts";

export interface VariantCommandParts {
  readonly store: Store<EditorState>;
  readonly session: DesignSession;
  readonly models: ModelSession;
  readonly board: NoticeBoard;
  /** Lets a model stay in the project of the one whose place it takes. */
  readonly succeed: (before: ModelRef, after: ModelRef) => void;
}

type Moved = ReadonlyMap<number, readonly number[]>;

export class VariantCommand {
  readonly #parts: VariantCommandParts;
  readonly #known = new WeakMap<ModelSource, { readonly variants: Variants | null }>();

  constructor(parts: VariantCommandParts) {
    this.#parts = parts;
  }

  /** Of the open model; null: it has none. */
  get variants(): Variants | null {
    const source = this.#parts.store.state.model?.ref.source;
    if (!source) return null;
    const known = this.#known.get(source) ?? { variants: readable(source) };
    this.#known.set(source, known);
    return known.variants;
  }

  /** @param variant its place among the variants; null: the file's own look */
  async show(variant: number | null): Promise<void> {
    const { store, session, models, board, succeed } = this.#parts;
    const { strings } = board;
    const before = store.state.model?.ref;
    if (!before || store.state.readonly || store.state.switching) return;
    try {
      await session.settled();
      if (store.state.model?.ref !== before) return;
      const { glb, moved, isRenaming } = withVariant(before.source, variant);
      const ref = changedModel(before, glb);
      const left = session.recordedDesign;
      const design = carried(left, moved, isRenaming);
      models.rememberSettings(ref, carriedSettings(store.state.targetSettings, moved));
      succeed(before, ref);
      const record = (): void => {
        // What was done while the model was being read is on it, too.
        const { recordedDesign } = session;
        const newest = recordedDesign === left ? design : carried(recordedDesign, moved, isRenaming);
        session.recordModel(ref, newest, strings.steps.variant);
      };
      await models.open(ref, design, record, { keepsView: true });
    } catch (thrown) {
      board.error(strings.errors.couldNotOpen(before.title), thrown);
    }
  }
}

/** What is wrong with a model is told where it is opened. */
function readable(source: ModelSource): Variants | null {
  try {
    return variantsOf(source);
  } catch {
    return null;
  }
}

/** Layers on the materials that are there now. Faces have numbers in their own material alone: where those change, they are hidden. */
function carried(design: Design, moved: Moved, isRenaming: boolean): Design {
  const ids = new Set([...walkLayers(design)].map(({ layer }) => layer.id));
  return mapLayers(design, ids, (layer) => {
    if (!("material" in layer)) return layer;
    const own = materialsOf(layer);
    if (!own.some((material) => moved.has(material))) return layer;
    const materials = new Set(own.flatMap((material) => moved.get(material) ?? [material]));
    const [first = 0, ...others] = [...materials].sort((a, b) => a - b);
    // Parts are of one material, and lie elsewhere where its faces are counted anew.
    if (layer.type === "fill" && layer.parts !== null && !isRenaming)
      return { ...layer, material: first, visible: false };
    return { ...layer, material: layerMaterials([first, ...others]) };
  });
}

function carriedSettings(
  settings: ReadonlyMap<number, TargetSettings>,
  moved: Moved,
): ReadonlyMap<number, TargetSettings> {
  return new Map(
    [...settings].flatMap(([material, own]) =>
      (moved.get(material) ?? [material]).map((place): [number, TargetSettings] => [place, own]),
    ),
  );
}
