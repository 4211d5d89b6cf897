/** What the page shows, as one immutable value: the design, its model and its history, and how they are looked at. */
import type { TargetUpdate } from "../../engine/engine-api.ts";
import type { DemoCatalogue } from "../files/demo-catalogue.ts";
import type { ProjectSummary } from "../storage/project.ts";
import type { Language } from "../strings/language.ts";
import type { LaidOpen, ToolId } from "../tools/tool.ts";
import { INITIAL_TOOL_SETTINGS, type ToolSettings } from "../tools/tool-settings.ts";
import { type DesignState, INITIAL_DESIGN_STATE } from "./design-state.ts";
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

/** A project in the list of those that the browser keeps. */
export interface ListedProject extends ProjectSummary {
  /** In this tab, or in another one. */
  readonly open: "here" | "elsewhere" | null;
  /** Deleted a moment ago, and can be brought back. */
  readonly deleted: boolean;
}

export interface EditorState extends DesignState {
  /** What the editor says is in this language. */
  readonly language: Language;
  /** Stem of the file that "Save" writes. */
  readonly designName: string;
  /** Ids of the groups whose layers the list does not show. */
  readonly collapsed: ReadonlySet<string>;
  /** Id of the text that was put on the model just now, and whose words are to be typed. */
  readonly textToType: string | null;
  /** Of the targets that nobody has set otherwise. */
  readonly usualTarget: TargetSettings;
  readonly targetSettings: ReadonlyMap<number, TargetSettings>;
  /** Where the newest step is: in the browser's database, on its way there, refused by it, or there is none worth it. */
  readonly keeping: "untouched" | "kept" | "pending" | "refused";
  /** Newest first; null until they were asked for. */
  readonly projects: readonly ListedProject[] | null;
  /** Until the page has opened what it begins with, or has found nothing. */
  readonly starting: boolean;
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
  ...INITIAL_DESIGN_STATE,
  language: "en",
  designName: "texelcast",
  collapsed: new Set(),
  textToType: null,
  usualTarget: DEFAULT_TARGET,
  targetSettings: new Map(),
  keeping: "untouched",
  projects: null,
  starting: true,
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
