/** What the shop's page has of the editor in its iframe, and what it may ask of it. */
import type {
  BeforeAccept,
  DesignInput,
  EditorLoading,
  EditorMode,
  EditorWording,
  ModelInput,
  TexelcastEditorEventMap,
  TexelcastEditorMethods,
} from "../element/element-api.ts";

/** The element's properties that can be told to another page; addresses are relative to the editor's page. */
export interface FrameProperties {
  readonly src?: Exclude<ModelInput, URL> | null;
  readonly design?: DesignInput | null;
  readonly zones?: string | object | null;
  readonly mode?: EditorMode;
  readonly material?: number | null;
  readonly size?: number | null;
  readonly locale?: string;
  readonly wording?: string | EditorWording | null;
  readonly readonly?: boolean;
  readonly poster?: string;
  readonly loading?: EditorLoading;
  readonly maxDecals?: number | null;
  readonly maxMegapixels?: number;
  readonly maxFileSize?: number;
  readonly cameraOrbit?: string;
  readonly minCameraOrbit?: string;
  readonly maxCameraOrbit?: string;
}

export interface MountOptions extends FrameProperties {
  /** Address of the editor's page, absolute, http(s). It should have an origin of its own. */
  readonly page: string | URL;
  /** The iframe's name for screen readers; default "Product designer". */
  readonly title?: string;
  /** As the element's: asked for each picture and font before it is taken. Runs in the shop's page; its answer must be plain data. */
  readonly beforeAccept?: BeforeAccept | null;
  /**
   * How long an answer may take, milliseconds, `Infinity` for as long as it likes; default 30 000; 120 000 for what loads, exports or checks the print,
   * for what `beforeAccept` may be asked about, and for the first word of the page, which has 30 000 once the browser has loaded it.
   */
  readonly timeoutMs?: number;
}

/** The element's methods that answer by data; each rejects with a TexelcastError. */
export const FRAME_METHODS = [
  "addDecal",
  "addText",
  "exportDesign",
  "exportModel",
  "exportTexture",
  "redo",
  "removeLayer",
  "restart",
  "select",
  "snapshot",
  "start",
  "submit",
  "undo",
  "validate",
] as const satisfies readonly (keyof TexelcastEditorMethods)[];

export type FrameMethod = (typeof FRAME_METHODS)[number];

export const FRAME_PROPERTIES = [
  "cameraOrbit",
  "design",
  "loading",
  "locale",
  "material",
  "maxCameraOrbit",
  "maxDecals",
  "maxFileSize",
  "maxMegapixels",
  "minCameraOrbit",
  "mode",
  "poster",
  "readonly",
  "size",
  "src",
  "wording",
  "zones",
] as const satisfies readonly (keyof FrameProperties)[];

/** "input" is the browser's own, of what is typed in the element: that it was, and not what. */
export const FRAME_EVENTS = ["change", "error", "input", "load", "progress", "select", "submit"] as const;

export interface TexelcastFrameEventMap extends TexelcastEditorEventMap {
  readonly input: CustomEvent<null>;
}

type Answer<Method> = Method extends (...args: infer Args) => infer Result
  ? (...args: Args) => Promise<Awaited<Result>>
  : never;

/**
 * The editor in its iframe. Where that is moved and its page loaded anew, what waits rejects with "cancelled", "error" tells it, and
 * later calls go to the new page, which has the properties and not the design. Events have the element's names and details, as CustomEvents of this object that tell of what was:
 * `preventDefault()` of "submit" does nothing, and the editor says that the design is ready.
 */
export interface TexelcastFrame {
  readonly iframe: HTMLIFrameElement;
  /** Messages from a wrong origin or window, repeated or malformed; none of them did anything. */
  readonly ignoredMessages: number;
  /** Sets properties of the element. */
  set(properties: FrameProperties): Promise<void>;
  addDecal: Answer<TexelcastEditorMethods["addDecal"]>;
  addText: Answer<TexelcastEditorMethods["addText"]>;
  select: Answer<TexelcastEditorMethods["select"]>;
  removeLayer: Answer<TexelcastEditorMethods["removeLayer"]>;
  undo: Answer<TexelcastEditorMethods["undo"]>;
  redo: Answer<TexelcastEditorMethods["redo"]>;
  start: Answer<TexelcastEditorMethods["start"]>;
  restart: Answer<TexelcastEditorMethods["restart"]>;
  exportTexture: Answer<TexelcastEditorMethods["exportTexture"]>;
  exportModel: Answer<TexelcastEditorMethods["exportModel"]>;
  exportDesign: Answer<TexelcastEditorMethods["exportDesign"]>;
  snapshot: TexelcastEditorMethods["snapshot"];
  validate: Answer<TexelcastEditorMethods["validate"]>;
  submit: Answer<TexelcastEditorMethods["submit"]>;
  addEventListener<Name extends keyof TexelcastFrameEventMap>(
    name: Name,
    listener: (event: TexelcastFrameEventMap[Name]) => void,
    options?: AddEventListenerOptions,
  ): void;
  removeEventListener<Name extends keyof TexelcastFrameEventMap>(
    name: Name,
    listener: (event: TexelcastFrameEventMap[Name]) => void,
  ): void;
  /** Takes the iframe away and ends the channel: what waits rejects with "disposed". */
  unmount(): void;
}
