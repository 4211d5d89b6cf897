/**
 * The contract of `<texelcast-editor>`: attributes, properties, methods, events and what they carry. Types alone, so that a
 * page, a framework's types and the iframe's two sides can be written against it without loading the element.
 */
import type { TexelcastErrorJson } from "../core/texelcast-error.ts";
import type { AssetType, Design, DesignLayer } from "../editor/document/design.ts";
import type { ModelSource, Projector, Vec3 } from "../engine/engine-api.ts";
import type { PrintFile, PrintFileOptions, PrintReport } from "../engine/print-report.ts";
import type { PrintZones } from "../engine/print-zones.ts";
import type { EditorWording } from "./words/wording.ts";

export type { TexelcastErrorJson } from "../core/texelcast-error.ts";
export type { AssetType, Design, DesignLayer } from "../editor/document/design.ts";
export type { ModelSource, Projector } from "../engine/engine-api.ts";
export type { PrintFile, PrintFileOptions, PrintFinding, PrintMeasures, PrintReport } from "../engine/print-report.ts";
export type { PrintZones } from "../engine/print-zones.ts";
export type { EditorWording } from "./words/wording.ts";

/** The element's name in HTML. */
export const EDITOR_TAG = "texelcast-editor";

/** "shop": pictures and words on a product, and nothing to learn; "full": the whole editor. */
export type EditorMode = "shop" | "full";

/** "eager": at once; "lazy": when touched; "auto": when it is about to be seen, or touched. */
export type EditorLoading = "auto" | "lazy" | "eager";

/** Languages of the element's own words. Another locale is passed over for the page's, then the browser's, else English. */
export type EditorLocale = "en" | "de";

/** A file of the design's, by the address that the design names it with. */
export interface ExportedAsset {
  /** Key in the design's `assets`. */
  readonly key: string;
  /** File name, "assets/" and the hash and an ending: what stands in the exported design as `uri`. */
  readonly name: string;
  readonly type: AssetType;
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Of `bytes`, 64 hex digits. */
  readonly sha256: string;
}

/**
 * A design as a shop keeps it: the recipe without the bytes, and the bytes beside it. Fonts that come with Texelcast are
 * named by the design and are not among the assets.
 */
export interface ExportedDesign {
  readonly design: Design;
  readonly assets: readonly ExportedAsset[];
}

/** What `design` may be set to: an address, JSON text, the parsed JSON, or what `exportDesign` gave. */
export type DesignInput =
  | string
  | object
  | { readonly design: unknown; readonly assets: readonly { readonly name: string; readonly bytes: Uint8Array }[] };

/** What `src` may be set to: an address, a model's bytes, or those with a name and the files beside it. */
export type ModelInput = string | URL | Blob | Uint8Array | ArrayBuffer | ModelSource;

/** A picture to be put on the model; a string is an address. */
export type DecalSource = Blob | URL | string | Uint8Array | ArrayBuffer;

/**
 * Where something new goes. Without a place: near the middle of the view where the product has room for it; with zones the middle,
 * or that of a zone where it is not printed.
 */
export interface PlaceOptions {
  /** As the list of layers calls it; default: the file's name, or the words. */
  readonly name?: string;
  /** The whole placement; the others are then left out. */
  readonly projector?: Projector;
  /** A point in model space, metres: the surface nearest to it that faces the camera there takes the decal. */
  readonly position?: Vec3;
  /** Metres; default: about a fifth of the model, less where there is no room for that. */
  readonly width?: number;
  /** glTF material index; default: all that lie under it. */
  readonly material?: number | readonly number[];
}

export interface TextOptions extends PlaceOptions {
  /** Id of a font that comes with Texelcast ("inter-700"), or the bytes of a TrueType or OpenType file. */
  readonly font?: string | Blob | Uint8Array;
  /** "#rrggbb" or "#rrggbbaa"; default "#ffffff" where the product is dark under most of the words, else "#1a1a1a". */
  readonly color?: string;
  /** Degrees of the arc that the words span, -360 to 360; default 0. */
  readonly curve?: number;
}

/** A picture on its way into the design, as `beforeAccept` sees it: checked, turned upright, its metadata gone. */
export interface CandidateAsset {
  /** File name as the user knows it. */
  readonly name: string;
  readonly type: AssetType;
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Pixels; of a drawing, its own units. 0 for a font. */
  readonly width: number;
  readonly height: number;
  readonly sha256: string;
}

/** Whether the shop takes an asset; a reason is told to the user. */
export type Acceptance = boolean | { readonly accept: boolean; readonly reason?: string };

/**
 * The shop's say over each asset (moderation). One that throws, rejects or does not answer for two minutes refuses the asset. The
 * signal is aborted when nobody waits for the answer any more: then, and when the element goes from the page.
 */
export type BeforeAccept = (
  asset: CandidateAsset,
  options: { readonly signal: AbortSignal },
) => Acceptance | Promise<Acceptance>;

/**
 * What of the print file is wanted. Without a `material` or a `zone` it is the element's material; without `size` and `dpi` the
 * element's `size`, else the model's own.
 */
export type ExportTextureOptions = PrintFileOptions;

export interface ExportModelOptions {
  /** Default "glb", with all else of the model as it was; "usdz" is the model at rest, for augmented reality on iPhones and iPads. */
  readonly format?: "glb" | "usdz";
}

/** PNG with its SHA-256: the hash that a customer approves, and that the print file has. */
export type ExportedTexture = PrintFile;

/** As a name, as the view is now, or as an orbit "30deg 75deg 105%" (about, down from the top, distance). */
export type SnapshotView = "current" | "front" | "back" | "left" | "right" | "top" | "bottom" | CameraOrbit;

/** "theta phi distance": degrees ("30deg"), degrees down from the top, and metres ("0.4m") or share of the framing ("105%"). */
export type CameraOrbit = `${string} ${string} ${string}`;

export interface SnapshotOptions {
  /** Pixels; default 512. */
  readonly width?: number;
  /** Pixels; default 512. */
  readonly height?: number;
}

/** How much is on the model: what a shop's price may go by. */
export interface DesignCounts {
  /** Visible pictures. */
  readonly decals: number;
  /** Visible texts. */
  readonly texts: number;
  /** Visible layers of every kind, groups not counted. */
  readonly layers: number;
}

/** What a layer prints. */
export interface LayerArea {
  readonly id: string;
  readonly name: string;
  readonly type: DesignLayer["type"];
  /** Square centimetres of the product, at the zones' print scale. */
  readonly area: number;
}

/** `load`: the model is shown and can be worked on. */
export interface LoadDetail {
  /** Names of the model's materials, and which of them can be painted. */
  readonly materials: readonly { readonly index: number; readonly name: string; readonly paintable: boolean }[];
  /** Milliseconds from the start of loading. */
  readonly milliseconds: number;
}

/** `progress`: 0 to 1 from the start of loading to `load`. */
export interface ProgressDetail {
  readonly share: number;
}

/** `change`: the design is another one; a moment after the last of quick changes. */
export interface ChangeDetail {
  /** As `exportDesign` gives it: assets by hash. */
  readonly design: Design;
  readonly counts: DesignCounts;
  readonly areas: readonly LayerArea[];
  /** Sum of `areas`, square centimetres. */
  readonly totalArea: number;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
}

/** `select`: another layer is chosen, or none. */
export interface SelectDetail {
  readonly id: string | null;
}

/** `error`: something that was asked for, by the user or the page, did not work. Nothing of the design is lost. */
export interface ErrorDetail {
  readonly error: TexelcastErrorJson;
  /** For programs; stable. */
  readonly code: string;
  /** A whole sentence for the user. */
  readonly message: string;
  /** What to do about it; "" where there is nothing to say. */
  readonly hint: string;
}

/** `submit`: the user is done. By default the element then says that the design is ready; `preventDefault()` leaves that to the page. */
export interface SubmitDetail extends ExportedDesign {
  /** With these a shop's server makes the same bytes: `renderPrint({ …, ...print })`. */
  readonly print: ExportTextureOptions;
  readonly texture: ExportedTexture;
  /** Null without zones. */
  readonly report: PrintReport | null;
}

/**
 * Events of the element. `change` and `select` bubble and cross shadow borders. The others do not, as the browser's own of those
 * names do not or would be taken for them: a page's `onload`, a form's `submit`.
 */
export interface TexelcastEditorEventMap {
  load: CustomEvent<LoadDetail>;
  progress: CustomEvent<ProgressDetail>;
  change: CustomEvent<ChangeDetail>;
  select: CustomEvent<SelectDetail>;
  error: CustomEvent<ErrorDetail>;
  submit: CustomEvent<SubmitDetail>;
}

/** Attributes by their names in HTML, as strings; properties of the same meaning are in `TexelcastEditorProperties`. */
export interface TexelcastEditorAttributes {
  src?: string;
  design?: string;
  zones?: string;
  mode?: EditorMode;
  material?: string | number;
  size?: string | number;
  locale?: string;
  wording?: string;
  readonly?: boolean | "";
  poster?: string;
  loading?: EditorLoading;
  "max-decals"?: string | number;
  "max-megapixels"?: string | number;
  "max-file-size"?: string | number;
  "camera-orbit"?: string;
  "min-camera-orbit"?: string;
  "max-camera-orbit"?: string;
  "wasm-url"?: string;
}

export interface TexelcastEditorProperties {
  /** Model: the address of a .glb, or of a .gltf with its files beside it; or the model's bytes. */
  src: ModelInput | null;
  /** Address of a design's JSON, or the design itself. Set while the model is shown, it is a step of the history. */
  design: DesignInput | null;
  /** Address of a zones file, or what is in it. */
  zones: string | PrintZones | object | null;
  mode: EditorMode;
  /** glTF material index that new things go on where nothing else says, and that `exportTexture` means; null: the model's largest. */
  material: number | null;
  /** Texels of the painted texture's side; null: the model's own. */
  size: number | null;
  /** Language; "" is the document's, else the browser's. */
  locale: string;
  /** Words of the shop's own for the shop's mode, or their address; those that are left out stay the element's. */
  wording: string | EditorWording | null;
  /** Shows the design and lets nobody change it. */
  readonly: boolean;
  /** Address of a picture that is shown until the model is. */
  poster: string;
  loading: EditorLoading;
  /** Pictures and texts that a user may put on the model; null: as many as they like. */
  maxDecals: number | null;
  /** Millions of pixels of a picture, told by its header before it is decoded; default 64. */
  maxMegapixels: number;
  /** Bytes of an uploaded file; default 20 MiB. */
  maxFileSize: number;
  /** "theta phi distance", where the camera begins; "auto" parts are the usual ones. */
  cameraOrbit: string;
  /** The least of each part; "auto" is no limit. */
  minCameraOrbit: string;
  maxCameraOrbit: string;
  /** Address of the engine's WebAssembly; "": beside the script. */
  wasmUrl: string;
  beforeAccept: BeforeAccept | null;
}

export interface TexelcastEditorMethods {
  /** The model is shown and can be worked on. */
  readonly loaded: boolean;
  /** Id of the chosen layer. */
  readonly selected: string | null;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** Begins to load, whatever `loading` says; resolves when the model is shown. Rejects as the `error` event tells. */
  start(): Promise<void>;
  /** Puts a picture on the model; gives the layer's id. Rejects with a TexelcastError where the picture is refused. */
  addDecal(source: DecalSource, options?: PlaceOptions): Promise<string>;
  /** Puts words on the model; gives the layer's id. */
  addText(text: string, options?: TextOptions): Promise<string>;
  /** Chooses a layer, or none. False where there is no such layer. */
  select(id: string | null): boolean;
  /** Takes a layer away. False where there is none of that id. */
  removeLayer(id: string): boolean;
  /** False where there is nothing to undo. */
  undo(): boolean;
  redo(): boolean;
  /** The finished texture, as it is printed. */
  exportTexture(options?: ExportTextureOptions): Promise<ExportedTexture>;
  /** The model with the design in its textures. */
  exportModel(options?: ExportModelOptions): Promise<Uint8Array<ArrayBuffer>>;
  exportDesign(): Promise<ExportedDesign>;
  /** PNG of the model as it is seen, or of several views at once. */
  snapshot(view?: SnapshotView, options?: SnapshotOptions): Promise<Blob>;
  snapshot(views: readonly SnapshotView[], options?: SnapshotOptions): Promise<Blob[]>;
  /** Looks at the design with the printer's eyes. */
  validate(): Promise<PrintReport>;
  /** Sends `submit`, as the button does. Rejects where the texture cannot be made. */
  submit(): Promise<SubmitDetail>;
  /** Ends the worker and the graphics and begins anew, the design kept: after an error that lasts. */
  restart(): Promise<void>;
}

/** Everything that a page may do with the element. */
export interface TexelcastEditorApi extends TexelcastEditorProperties, TexelcastEditorMethods {}
