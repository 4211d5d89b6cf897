/** How the model and its texture are looked at. Nothing of it is in the design: it changes no picture. */
import type { MapView } from "../../engine/engine-api.ts";
import type { AnimationState, ClipInfo, ModelLook, ModelPart } from "../../viewer/viewer-api.ts";

export type TextureMode = "texture" | MapView;
export const TEXTURE_MODES: readonly TextureMode[] = ["texture", "positions", "normals", "coverage", "overlap"];

/** Which views are there: the model alone, both side by side, the flat texture alone. */
export type ViewLayout = "model" | "both" | "texture";
export const VIEW_LAYOUTS: readonly ViewLayout[] = ["model", "both", "texture"];

/** Whether both are there: beside or above a sheet there is room for one of them. */
export const isSplit = (layout: ViewLayout, hasSheet: boolean): boolean => layout === "both" && !hasSheet;

/** The tone behind the model; "auto" follows the page's theme. */
export type BackgroundTone = "auto" | "light" | "grey" | "dark";
export const BACKGROUND_TONES: readonly BackgroundTone[] = ["auto", "light", "grey", "dark"];

export interface ViewSettings extends ModelLook {
  readonly layout: ViewLayout;
  /** What the model shows in place of its texture. */
  readonly modelMap: TextureMode;
  readonly background: BackgroundTone;
  /** Names of the texture's places, over the flat view. */
  readonly guide: boolean;
  /** What is dragged comes into line with what is near. */
  readonly aligns: boolean;
}

export const USUAL_VIEW: ViewSettings = {
  layout: "both",
  shading: "lit",
  wireframe: false,
  lightTurn: 0,
  lightStrength: 1,
  turntable: false,
  modelMap: "texture",
  background: "auto",
  guide: false,
  aligns: true,
};

/** What of the open model is shown. */
export interface ShownParts {
  readonly parts: readonly ModelPart[];
  readonly hidden: ReadonlySet<number>;
  /** Part chosen in the list; null none. */
  readonly chosen: number | null;
}

export const NO_PARTS: ShownParts = { parts: [], hidden: new Set(), chosen: null };

/** The open model's clips and where they stand. */
export interface ShownAnimation extends AnimationState {
  readonly clips: readonly ClipInfo[];
}

export const NO_ANIMATION: ShownAnimation = { clips: [], clip: null, playing: false, seconds: 0, speed: 1 };
