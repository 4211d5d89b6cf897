/** What every desk has of a design under edit, a shop's too: the design is the truth, the rest is chosen or derived. */
import type { ModelInfo, ModelSource, TargetInfo } from "../../engine/engine-api.ts";
import { type Design, emptyDesign } from "../document/design.ts";
import { DEFAULT_BUDGET } from "./history.ts";

/** A model as it was given: what an undo across models needs to bring it back. Identity tells two apart. */
export interface ModelRef {
  readonly source: ModelSource;
  /** As the page names it. */
  readonly title: string;
  /** Null for the user's own files. */
  readonly demoId: string | null;
}

/** One step of the history. */
export interface Snapshot {
  readonly design: Design;
  readonly model: ModelRef | null;
}

export interface OpenModel {
  readonly ref: ModelRef;
  readonly info: ModelInfo;
}

/** The steps that can be gone to, for the history panel. */
export interface HistorySteps {
  /** What led to each, the oldest first; "" for the one that the history began with. */
  readonly labels: readonly string[];
  /** Place of the present one among them. */
  readonly position: number;
  /** Steps that were dropped because they no longer fitted the budget. */
  readonly dropped: number;
  /** Bytes: what the steps hold beyond the present design, and may hold. */
  readonly heldBytes: number;
  readonly budget: number;
}

export interface DesignState {
  /** The design is looked at, and nothing that a user does changes it. */
  readonly readonly: boolean;
  readonly model: OpenModel | null;
  readonly design: Design;
  /** The layer that the properties, the gizmo and the brush are about; always one of `selection`. */
  readonly selectedId: string | null;
  /** Ids of all chosen layers, which acts on layers are for. */
  readonly selection: readonly string[];
  /** Id of the layer whose mask the brush paints on; null: it paints on the layer itself. */
  readonly editingMask: string | null;
  /** The material that the texture view and the target settings are about; null without a paintable one. */
  readonly material: number | null;
  readonly targets: ReadonlyMap<number, TargetInfo>;
  readonly undoLabel: string | null;
  readonly redoLabel: string | null;
  readonly history: HistorySteps;
  readonly unsaved: boolean;
  /** While one model takes the place of another: the design must not be edited against the wrong one. */
  readonly switching: boolean;
}

export const INITIAL_DESIGN_STATE: DesignState = {
  readonly: false,
  model: null,
  design: emptyDesign(),
  selectedId: null,
  selection: [],
  editingMask: null,
  material: null,
  targets: new Map(),
  undoLabel: null,
  redoLabel: null,
  history: { labels: [""], position: 0, dropped: 0, heldBytes: 0, budget: DEFAULT_BUDGET },
  unsaved: false,
  switching: false,
};

/** Metres from corner to corner of the model's box: what steps and sizes of new things go by. 1 without a model. */
export function diagonalOf(model: OpenModel | null): number {
  if (!model) return 1;
  const { boundsMin: low, boundsMax: high } = model.info;
  return Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) || 1;
}
