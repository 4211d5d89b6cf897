/** What a tool of the editor above gets from either view, and what it may show there. */
import type { PerspectiveProjector, Vec3 } from "../engine/engine-api.ts";
import type { ScreenPoint } from "./screen-space.ts";
import type { SurfaceSight } from "./surface-sight.ts";
import type { TexelPlaces } from "./texel-places.ts";
import type { SurfaceHit } from "./viewer-api.ts";

/** One place of the pointer. Fast pens report several in a frame; all of them come, oldest first. */
export interface ToolSample {
  readonly view: ToolView;
  /** CSS pixels from the view's top left corner. */
  readonly at: ScreenPoint;
  /** What lies there; null beside the model, and in the flat view between the charts. */
  readonly hit: SurfaceHit | null;
  /** 0 to 1; 1 for what has no pressure (mouse, finger). */
  readonly pressure: number;
  readonly shift: boolean;
  readonly alt: boolean;
  readonly ctrl: boolean;
  /** Milliseconds, on the events' clock. */
  readonly time: number;
}

/** A view as a tool asks it about places between its samples. */
export interface ToolView {
  readonly kind: "model" | "texture";
  hitAt(at: ScreenPoint): SurfaceHit | null;
  /** Texture coordinates in the flat view, not wrapped, charts or not; in the 3D view those of the hit. */
  uvAt(at: ScreenPoint): readonly [number, number] | null;
  /** Where a place of the surface is in the view; null where it is not to be seen. */
  placeOf(hit: SurfaceHit): ScreenPoint | null;
}

/** What a view does with its pointer while a tool other than the decals' own is chosen. */
export interface ToolInput {
  /** A CSS cursor for the view. */
  readonly cursor: string;
  /** True takes the pointer until it is released; false leaves it to the camera. */
  down(sample: ToolSample): boolean;
  /** The pointer that was taken moved. */
  move(samples: readonly ToolSample[]): void;
  up(sample: ToolSample): void;
  /**
   * The gesture ended by no will of the user's ("lost": the system took the pointer; "pinch": a second finger came and the
   * camera has both now).
   */
  interrupted(reason: "lost" | "pinch"): void;
  /** At most once a frame while no button is down; null when the pointer has left the view. */
  hover(sample: ToolSample | null): void;
}

/** A brush's preview lying on the surface. */
export interface BrushRing {
  readonly hit: SurfaceHit;
  /** Metres. */
  readonly radius: number;
  /** Of the radius: where the brush begins to fade; 1 draws one ring. */
  readonly inner: number;
  /** Corners that are shown in place of the ring, model space: a square of texels. */
  readonly corners?: readonly Vec3[];
}

/** What a tool asks of the model's surface. */
export interface ToolSurface {
  /**
   * The point of the surface nearest to one in model space; null without a model. With a `width` in metres its normal is
   * averaged, as a decal that wide lies there.
   */
  near(position: Vec3, width?: number): SurfaceHit | null;
  /** The surface that a place of a material's texture is painted on; null between the charts. */
  atUv(material: number, uv: readonly [number, number]): SurfaceHit | null;
  /**
   * How far above a place of the visible surface a hidden one lies, metres; `reach` where there is none within that. What is
   * painted under a hidden layer must stay below it, or it goes onto that layer.
   */
  freeAbove(position: Vec3, normal: Vec3, reach: number): number;
  /** A circle about a hit (radius in metres) as it lies in the texture: its points, texture coordinates, not wrapped. */
  circleInTexture(hit: SurfaceHit, radius: number): readonly (readonly [number, number])[];
  /** The way back: places of the texture in the plane of the hit's own triangle, model space. */
  placesInModel(hit: SurfaceHit, uvs: readonly (readonly [number, number])[]): readonly Vec3[];
  /** Where the texels of a material's texture of this size lie; for small textures. Null without a model. */
  texelPlaces(material: number, width: number, height: number): TexelPlaces | null;
  /**
   * From where the camera looks at a hit, and what is up there; model space. While the model is posed, from straight above
   * the hit's place at rest.
   */
  lookAt(hit: SurfaceHit): { readonly eye: Vec3; readonly up: Vec3 };
  /** What an eye sees of the visible surface at rest; null without a model. */
  seenFrom(eye: PerspectiveProjector, width: number, height: number): SurfaceSight | null;
  /** Metres that one CSS pixel spans on the surface at a hit. */
  metresPerPixel(hit: SurfaceHit): number;
}
