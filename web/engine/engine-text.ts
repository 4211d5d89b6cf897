/** Words as the engine takes them. */
import type { EngineColor } from "./engine-api.ts";

/** Words as a picture; lengths in em. */
export interface EngineText {
  /** Line feeds part lines. */
  readonly text: string;
  /** Key of a font given to `setFont`, or the address of one that comes with Texelcast ("texelcast:fonts/inter-700"). */
  readonly font: string;
  /** Height of the em as a share of the box's, above 0; made less where the text would not fit. */
  readonly fontSize: number;
  /** Between letters; scripts whose letters hang together take none. */
  readonly letterSpacing: number;
  /** Lines among each other, and the text in its box. */
  readonly align: "left" | "center" | "right";
  /** Degrees of the arc that the longest line spans: 0 straight, above 0 an arch, below 0 a bowl; -360 to 360. */
  readonly curve: number;
  readonly color: EngineColor;
  /** `width`: how far it reaches out from the letters, above 0. */
  readonly outline: { readonly color: EngineColor; readonly width: number } | null;
}

/** What a layer throws: the key of a picture given to `setAsset`, or words. */
export type EnginePicture = string | EngineText;

export interface TextMeasure {
  /** Of the text with its outline, em. */
  readonly width: number;
  readonly height: number;
  /** Characters that no font has, each once; their font's sign for that stands in their places. */
  readonly missing: readonly string[];
}
