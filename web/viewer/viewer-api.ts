/** What the two views offer to the editor above them. The editor owns the design; the views only show it and report gestures. */
import type {
  MapView,
  ModelInfo,
  PlanarProjector,
  Projector,
  TargetInfo,
  TargetUpdate,
  UvProjector,
  Vec3,
} from "../engine/engine-api.ts";
import type { FindSurroundings, ModelMiddle } from "./aligned-slide.ts";
import type { Orbit } from "./camera-orbit.ts";
import type { CameraStand } from "./camera-rig.ts";
import type { GradientLabels, GradientPhase, GradientPlace } from "./gradient-handles.ts";
import type { CameraLimits } from "./model-camera.ts";
import type { BrushRing, ToolInput, ToolSurface } from "./tool-input.ts";

export type { Vec3 } from "../engine/engine-api.ts";
export type { FindSurroundings, ModelMiddle, Surroundings } from "./aligned-slide.ts";
export type { GradientLabels, GradientPhase, GradientPlace } from "./gradient-handles.ts";
export type { SurfaceSight } from "./surface-sight.ts";
export type { TexelPlaces } from "./texel-places.ts";
export type { BrushRing, ToolInput, ToolSample, ToolSurface, ToolView } from "./tool-input.ts";

/** A piece of the model that can be hidden by itself. Hiding is a matter of looking: nothing that is painted changes. */
export interface ModelPart {
  readonly id: number;
  readonly name: string;
  /** Parts of one group stand together in the list. */
  readonly group: string | null;
  /** glTF material index. */
  readonly material: number;
  readonly triangles: number;
  /** The file asks to hide it at first. */
  readonly hidden: boolean;
}

/** A named place of a material's texture. */
export interface GuideEntry {
  readonly part: string;
  readonly face?: string;
  /** Least u and v, greatest u and v. */
  readonly uv: readonly [number, number, number, number];
}

export interface ClipInfo {
  readonly name: string;
  readonly seconds: number;
}

/** Where a model's animation stands. */
export interface AnimationState {
  /** Place in `ModelViewer.clips`; null at rest. */
  readonly clip: number | null;
  readonly playing: boolean;
  /** Since the clip's start, in the clip's own time. */
  readonly seconds: number;
  /** 1 is the clip's own. */
  readonly speed: number;
}

/** How the model is shown; nothing of it is painted. */
export interface ModelLook {
  /** "unlit" shows the texels' own colours: no light, no tone mapping. */
  readonly shading: "lit" | "unlit";
  readonly wireframe: boolean;
  /** Turn of the light about the vertical, degrees. */
  readonly lightTurn: number;
  /** 1 is the usual light. */
  readonly lightStrength: number;
  readonly turntable: boolean;
}

/** A picture that is shown instead of the texture. */
export interface MapPicture {
  readonly width: number;
  readonly height: number;
  /** Straight alpha, row 0 at the top. */
  readonly rgba: Uint8Array;
}

/** A place of a material's texture. */
export interface TexturePlace {
  readonly material: number;
  readonly uv: readonly [number, number];
}

/** A decal as the gizmo needs it. */
export interface ViewerDecal {
  readonly id: string;
  readonly name: string;
  /** glTF material indices of the surfaces that it paints. */
  readonly materials: readonly number[];
  readonly visible: boolean;
  readonly locked?: boolean;
  readonly projector: Projector;
  /** Outlined faintly while it is selected: where its mirror shows it, and what is chosen with it. */
  readonly beside?: readonly Projector[];
  /** What a press takes hold of while it is selected, bottom to top; without them itself. */
  readonly holds?: readonly ViewerDecal[];
  /** Width / height of its picture: scaling by a corner handle keeps the box's own proportions, this is for resets. */
  readonly aspect: number;
}

/** A gesture on the gizmo. `start` before the first change, `move` at most once a frame, `end` once; `cancel` (Escape, or undo) gives back the first projector. */
export interface DecalGesture {
  readonly id: string;
  readonly kind: "slide" | "rotate" | "scale" | "depth";
  readonly phase: "start" | "move" | "end" | "cancel";
  readonly projector: Projector;
  /**
   * glTF material of the surface that the decal was dragged onto; null until it was dragged onto one. The editor may give
   * the decal that material and others that it reaches, else it does not paint there.
   */
  readonly material: number | null;
}

/** A point on the model under the pointer. */
export interface SurfaceHit {
  readonly position: Vec3;
  /** Unit, model space, of the resting model. */
  readonly normal: Vec3;
  readonly material: number;
  /** Texture coordinates of the painted UV set, wrapped to [0, 1). */
  readonly uv: readonly [number, number];
  /** Triangle of the material, as `Engine.uvTriangles` counts them. */
  readonly face: number;
  /** It is seen from behind: its normal looks away, and what is put there paints back faces. */
  readonly isBack?: boolean | undefined;
}

export interface ModelViewerEvents {
  /** The gradient's handles were moved; `cancel` (Escape, or undo) gives back where they were. */
  gradient: { readonly place: GradientPlace; readonly phase: GradientPhase };
  gesture: DecalGesture;
  /** The user clicked a decal (its id) or nothing (null). */
  select: { readonly id: string | null };
  /** The pointer moved over the model, or left it. */
  hover: { readonly hit: SurfaceHit | null };
  /** WebGL was lost or came back; the viewer asks for a full picture again by itself through `needsFullUpdate`. */
  needsFullUpdate: { readonly material: number };
  /** WebGL was lost some seconds ago and has not come back, which it may never do; or it has come back, told or not. */
  graphics: { readonly lost: boolean };
  /** The animation was started, stopped or moved; ten times a second at most while it plays. */
  animation: AnimationState;
}

/** A model that is shown, with its live texture. */
export interface ModelView {
  readonly element: HTMLElement;
  /** Shows a model and frames it. Rejects with a TexelcastError when three.js cannot load it. */
  setModel(info: ModelInfo): Promise<void>;
  /** Makes the GPU texture of a material's target; the material shows its own picture until the first update. */
  bindTarget(info: TargetInfo): void;
  /**
   * Uploads the dirty rectangles (packed staging buffer, every mip level that is reported). True where
   * that is done, and the bytes are not read any more; false where it waits until the GPU is free.
   */
  applyUpdate(update: TargetUpdate): boolean;
  /** Decals lie bottom to top, as layers do: a click selects the topmost under it. */
  setDecals(decals: readonly ViewerDecal[], selectedId: string | null): void;
  frameModel(): void;
  /** Where the camera is, or goes to. */
  readonly stand: CameraStand;
  /** How far the camera may go about the open model, and (not null) where it goes now. Another model is free of both. */
  setCamera(place: Orbit | CameraStand | null, limits: CameraLimits): void;
  /**
   * The model from an orbit, or (null) from where the camera is: a PNG of this size in pixels on a clear ground, without
   * gizmo; null without a model or while WebGL is lost.
   */
  capture(orbit: Orbit | null, width: number, height: number): Promise<Blob | null>;
  on<K extends keyof ModelViewerEvents>(type: K, listener: (event: ModelViewerEvents[K]) => void): () => void;
  /** Frames drawn, and the main-thread milliseconds of the newest upload: for tests and the status line. */
  readonly statistics: { readonly frames: number; readonly uploadMilliseconds: number; readonly uploadedBytes: number };
  dispose(): void;
}

/** Where something is on a model, for what is to be put there. */
export type SurfacePlaces = Pick<ToolSurface, "near" | "atUv" | "lookAt">;

/** Where something new goes. */
export interface Landing {
  readonly hit: SurfaceHit;
  /** Metres. */
  readonly width: number;
}

/** A model that is shown, with decals that can be taken hold of. */
export interface DecalViewer extends ModelView {
  /** Selects what a click there would, as if one had come. */
  clickAt(clientX: number, clientY: number): void;
  /** The surface point nearest the middle of the view. Null when the model is out of view. */
  surfaceAtCentre(): SurfaceHit | null;
  /**
   * Where something new of this width (metres) and aspect lies best near the middle of the view, and how wide it is there: in the
   * middle itself where it lies well. Null where the model is not near the middle.
   */
  landing(width: number, aspect: number): Landing | null | Promise<Landing | null>;
  surfaceAtPointer(clientX: number, clientY: number): SurfaceHit | null;
  /** The decal's box laid flat on the surface at a hit, upright to the camera, of this width (metres) and aspect. */
  projectorAt(hit: SurfaceHit, width: number, aspect: number, keep?: PlanarProjector): PlanarProjector;
  /**
   * Moves a decal by view-space steps (keyboard nudges): a box along the surface as a drag does, a label round its axis and
   * along it, an eye beside itself, a flat stamp in its texture.
   */
  nudge(projector: Projector, rightMetres: number, upMetres: number): Projector;
  /**
   * What a projector was before and is after its picture was sized: a box of another width or height gets the depth that goes
   * with it on the surface there, or a picture that grows would be cut off where the model curves away.
   */
  resized(before: Projector, after: Projector): Projector;
  /**
   * glTF materials, ascending, with a triangle inside the projector's volume that it meets from the front (with `backfaces`,
   * from either side); none for a flat stamp. Occlusion is not looked at, and a label counts as its bounding box.
   */
  materialsReached(projector: Projector, backfaces: boolean): readonly number[];
  readonly surface: SurfacePlaces;
}

/** Several projectors as one, as `ModelViewer.arrangement` found them. */
export interface Arrangement {
  /** Round all of them, and upright. */
  readonly box: PlanarProjector;
  /**
   * The projectors, in their order, as they lie once the box is another: turned about its own +Z, sized, moved in its plane.
   * Always from where they were at first, so that a box that comes back brings them back.
   */
  at(box: PlanarProjector): readonly Projector[];
}

/** A model that is shown, with all that an editor does to it. */
export interface ModelViewer extends DecalViewer {
  /** The model as it is seen now, cut to this size in pixels, as a `data:` URI; null without a model or while WebGL is lost. */
  picture(width: number, height: number): Promise<string | null>;
  /** At once: what weighs the places is there. */
  landing(width: number, aspect: number): Landing | null;
  /**
   * What turns, sizes and moves several projectors as one, on the surface as it is now. Null where that has no middle: fewer
   * than two of them lie on it, or they look too far apart. Flat stamps stay where they are.
   */
  arrangement(projectors: readonly Projector[]): Arrangement | null;
  /**
   * A decal's projector as another kind, its picture's place and size kept as well as both kinds allow; `material` says in
   * which texture a flat stamp lies. To "perspective" it is thrown from the camera and covers on the screen what it covers
   * now, from "perspective", too. Null where it meets no surface that the kind could hold, or is not seen from the camera.
   */
  convertProjector(projector: Projector, kind: Projector["kind"], material: number): Projector | null;
  /** What brings the camera back to where it is: for a model that takes the place of its like. */
  keepCamera(): () => void;
  /**
   * Turns a projector where it lies: to the surface's direction, upright to the model, or to the camera. The same one where
   * there is nothing to turn.
   */
  alignProjector(projector: Projector, how: "surface" | "upright" | "view", material: number): Projector;
  /**
   * A box slid along the surface into one of these middles, as its picture's middle line. The same one where none of them is to
   * be come to, and what is no box.
   */
  centred(projector: Projector, middles: readonly ModelMiddle[]): Projector;
  /** Says what a box that slides comes into line with: asked after the gesture's start. */
  setSurroundings(find: FindSurroundings): void;
  /**
   * Hands the pointer over the model to a tool; null gives it back to the decals. With a tool, decals have no handles, two
   * fingers orbit and zoom, and the camera keeps the background, the other buttons and the space bar.
   */
  setTool(input: ToolInput | null): void;
  /** Shows a brush's preview on the surface. */
  setRing(ring: BrushRing | null): void;
  /** Shows a gradient's ends with handles, while no tool has the pointer and the model is at rest; null shows none. */
  setGradient(place: GradientPlace | null, labels: GradientLabels): void;
  /** Where places lie on the model and in its textures. */
  readonly surface: ToolSurface;
  /** Whether a material's texels are shown as squares; null: as the model's own texture asks. */
  setPixelated(material: number, pixelated: boolean | null): void;
  frameDecal(id: string): void;
  /** The model's animations; none on a model that has none. */
  readonly clips: readonly ClipInfo[];
  /**
   * Plays, stops, scrubs, or brings the model to rest (`clip: null`); what is not given stays. A posed model is painted as a
   * resting one: what the pointer meets is carried to the same place of the resting surface.
   */
  setAnimation(change: Partial<AnimationState>): void;
  /** Parts in the file's order; none without a model. */
  readonly parts: readonly ModelPart[];
  /** Hides parts: they are neither drawn nor met by the pointer. Occlusion and what is painted do not heed it. */
  setHiddenParts(ids: ReadonlySet<number>): void;
  /** The named places of a material's texture, as the model's file gives them. */
  guideOf(material: number): readonly GuideEntry[];
  setLook(look: ModelLook): void;
  /** Shows pictures in place of the textures, by material (others grey), as flat colours; null shows the textures again. */
  setMapPictures(pictures: ReadonlyMap<number, MapPicture> | null): void;
  /** Lights up the chart at a place of a texture; null none. */
  highlightChart(place: TexturePlace | null): void;
  /** Marks a place of a texture on the model; null nothing. */
  setMarker(place: TexturePlace | null): void;
  /** A point of model space in the page's client pixels; null behind the camera or without a model. */
  clientPosition(position: Vec3): { readonly x: number; readonly y: number } | null;
}

/** The pointer over the flat view. */
export interface TextureHover {
  /** Not wrapped: it may lie beside the texture. */
  readonly uv: readonly [number, number];
  /** Column and row; null beside the texture. */
  readonly texel: readonly [number, number] | null;
}

/** Beside the stamp with this id, in the texture that is shown; null: it comes into line with nothing. */
export type FindStamps = (id: string) => readonly UvProjector[] | null;

export interface TextureViewEvents {
  /** The pointer moved over the texture, or left it (null). */
  hover: TextureHover | null;
  /** A click or tap that was no drag. */
  click: TextureHover;
  /** A drag of the stamp that is shown. */
  gesture: DecalGesture;
  /** As the model's view tells of its own. */
  graphics: { readonly lost: boolean };
}

/** The unfolded texture: the live target or a map view, UV outlines over it, zoom and pan. */
export interface TextureView {
  readonly element: HTMLElement;
  /**
   * The view shows what was there before, at first nothing: an update waits for the GPU, which is busy, or what changed for its
   * frame or for texels that are asked for.
   */
  readonly isBehind: boolean;
  bindTarget(info: TargetInfo, uvTriangles: Float32Array): void;
  /** As `ModelView.applyUpdate`. */
  applyUpdate(update: TargetUpdate): boolean;
  /** "texture" shows the live target; the others a picture of the map. */
  setMode(mode: "texture" | MapView, picture?: MapPicture): void;
  setOutlinesVisible(visible: boolean): void;
  /** Lights up the chart at a texture coordinate; null none. */
  highlightChart(uv: readonly [number, number] | null): void;
  /** Names of the texture's places; empty shows none. */
  setGuide(guide: readonly GuideEntry[]): void;
  on<K extends keyof TextureViewEvents>(type: K, listener: (event: TextureViewEvents[K]) => void): () => void;
  /** Marks a texture coordinate (the 3D view's hover). */
  setMarker(uv: readonly [number, number] | null): void;
  /** Hands the pointer over the texture to a tool; null gives it back to panning. `pick` finds the surface of a place. */
  setTool(input: ToolInput | null, pick: (uv: readonly [number, number]) => SurfaceHit | null): void;
  /** Shows a brush's preview: outlines in texture coordinates; null shows none. */
  setRing(outlines: readonly (readonly (readonly [number, number])[])[] | null): void;
  /** Shows a flat stamp's border and handles, to be dragged while no tool has the pointer; null, or another kind, shows none. */
  setStamp(decal: ViewerDecal | null): void;
  /** Says which stamps one that slides comes into line with, as with the texture itself: asked after the gesture's start. */
  setSurroundings(find: FindStamps): void;
  resetZoom(): void;
  /** The texture coordinate at a place of the window, which may lie beside the texture; null beside the view. */
  uvAtPointer(clientX: number, clientY: number): readonly [number, number] | null;
  dispose(): void;
}
