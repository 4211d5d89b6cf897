/** What the page shows, as one immutable value. The design in it is the truth; the rest is view state or derived. */
import type { ModelInfo, ModelSource, TargetInfo, TargetUpdate } from "../../engine/engine-api.ts";
import { type Design, emptyDesign } from "../document/design.ts";
import type { DemoCatalogue } from "../files/demo-catalogue.ts";
import type { ProjectSummary } from "../storage/project.ts";
import type { Language } from "../strings/language.ts";
import type { LaidOpen, ToolId } from "../tools/tool.ts";
import { INITIAL_TOOL_SETTINGS, type ToolSettings } from "../tools/tool-settings.ts";
import { DEFAULT_BUDGET } from "./history.ts";
import type { Notice } from "./notices.ts";
import {
  NO_ANIMATION,
  NO_PARTS,
  type ShownAnimation,
  type ShownParts,
  type TextureMode,
  USUAL_VIEW,
  type ViewSettings,
} from "./view-state.ts";

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

/** Null: the engine's default (the model's own picture size; gutter in proportion to the size). */
export interface TargetSettings {
  readonly size: number | null;
  readonly gutter: number | null;
}

export const DEFAULT_TARGET: TargetSettings = { size: null, gutter: null };

export interface Task {
  readonly id: number;
  readonly label: string;
  /** 0 to 1; null while nothing is known. */
  readonly share: number | null;
  readonly cancel: (() => void) | null;
  /** Set once the task has lasted long enough to be worth showing. */
  readonly visible: boolean;
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

/** A project in the list of those that the browser keeps. */
export interface ListedProject extends ProjectSummary {
  /** In this tab, or in another one. */
  readonly open: "here" | "elsewhere" | null;
  /** Deleted a moment ago, and can be brought back. */
  readonly deleted: boolean;
}

export interface EditorState {
  /** What the editor says is in this language. */
  readonly language: Language;
  /** The design is looked at, and nothing that a user does changes it. */
  readonly readonly: boolean;
  readonly model: OpenModel | null;
  readonly design: Design;
  /** Stem of the file that "Save" writes. */
  readonly designName: string;
  /** The layer that the properties, the gizmo and the brush are about; always one of `selection`. */
  readonly selectedId: string | null;
  /** Ids of all chosen layers, which acts on layers are for. */
  readonly selection: readonly string[];
  /** Ids of the groups whose layers the list does not show. */
  readonly collapsed: ReadonlySet<string>;
  /** Id of the layer whose mask the brush paints on; null: it paints on the layer itself. */
  readonly editingMask: string | null;
  /** Id of the text that was put on the model just now, and whose words are to be typed. */
  readonly textToType: string | null;
  /** The material that the texture view and the target settings are about; null without a paintable one. */
  readonly material: number | null;
  readonly targets: ReadonlyMap<number, TargetInfo>;
  /** Of the targets that nobody has set otherwise. */
  readonly usualTarget: TargetSettings;
  readonly targetSettings: ReadonlyMap<number, TargetSettings>;
  readonly undoLabel: string | null;
  readonly redoLabel: string | null;
  readonly history: HistorySteps;
  readonly unsaved: boolean;
  /** Where the newest step is: in the browser's database, on its way there, refused by it, or there is none worth it. */
  readonly keeping: "untouched" | "kept" | "pending" | "refused";
  /** Newest first; null until they were asked for. */
  readonly projects: readonly ListedProject[] | null;
  /** Until the page has opened what it begins with, or has found nothing. */
  readonly starting: boolean;
  /** While one model takes the place of another: the design must not be edited against the wrong one. */
  readonly switching: boolean;
  readonly tasks: readonly Task[];
  readonly notices: readonly Notice[];
  readonly announcement: string;
  readonly demos: DemoCatalogue | null;
  readonly view: ViewSettings;
  readonly shown: ShownParts;
  readonly animation: ShownAnimation;
  readonly textureMode: TextureMode;
  readonly outlines: boolean;
  readonly tool: ToolId;
  /** What is laid open beside the tabs' panels: of the tool, or of the view. */
  readonly toolPanel: LaidOpen | null;
  /** Where the sheet stands, if one view is seen at a time; not set by whoever has no workbench. */
  readonly sheet?: "below" | "beside" | null;
  /** How many of the chosen tool's options its bar has no room for. */
  readonly optionsGivenWay: number;
  readonly toolSettings: ToolSettings;
}

export const INITIAL_STATE: EditorState = {
  language: "en",
  readonly: false,
  model: null,
  design: emptyDesign(),
  designName: "texelcast",
  selectedId: null,
  selection: [],
  collapsed: new Set(),
  editingMask: null,
  textToType: null,
  material: null,
  targets: new Map(),
  usualTarget: DEFAULT_TARGET,
  targetSettings: new Map(),
  undoLabel: null,
  redoLabel: null,
  history: { labels: [""], position: 0, dropped: 0, heldBytes: 0, budget: DEFAULT_BUDGET },
  unsaved: false,
  keeping: "untouched",
  projects: null,
  starting: true,
  switching: false,
  tasks: [],
  notices: [],
  announcement: "",
  demos: null,
  view: USUAL_VIEW,
  shown: NO_PARTS,
  animation: NO_ANIMATION,
  textureMode: "texture",
  outlines: true,
  tool: "move",
  toolPanel: null,
  optionsGivenWay: 0,
  toolSettings: INITIAL_TOOL_SETTINGS,
};

/** Figures of the newest update: they change every frame of a drag and therefore live in a store of their own. */
export interface Figures {
  readonly update: Pick<
    TargetUpdate,
    "material" | "revision" | "projectedTexels" | "compositedTexels" | "milliseconds"
  > | null;
  readonly uploadMilliseconds: number;
  readonly updates: number;
  /** Column and row of the texel under the pointer, in the flat view; null beside it. */
  readonly texel: readonly [number, number] | null;
}

export const INITIAL_FIGURES: Figures = { update: null, uploadMilliseconds: 0, updates: 0, texel: null };

/** Metres from corner to corner of the model's box: what steps and sizes of new things go by. 1 without a model. */
export function diagonalOf(model: OpenModel | null): number {
  if (!model) return 1;
  const { boundsMin: low, boundsMax: high } = model.info;
  return Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) || 1;
}
