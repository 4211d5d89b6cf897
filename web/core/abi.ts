/**
 * The C ABI of wasm/texelcast.h as TypeScript sees it: struct layouts, the enums' numbers and the functions' shapes.
 * The header is the manual; a test reads it and compares every name, type and order with this file.
 */
import { defineStruct, f32, f32Array, type StructFields, type StructValue, u32 } from "./struct-layout.ts";

export const ABI_VERSION = 9;
/** Stops of a gradient, at most. */
export const MAX_STOPS = 16;
/** TXC_NONE: "no such index", "the default" for a gutter, and no limit of work. */
export const NONE = 0xffffffff;

export const MapViews = { positions: 0, normals: 1, coverage: 2, overlap: 3 } as const;
export const Filters = { linear: 0, nearest: 1 } as const;
export const LayerKinds = { decal: 0, fill: 1, stroke: 2, group: 3 } as const;
export const Roles = { content: 0, mask: 1 } as const;
export const Projectors = { planar: 0, perspective: 1, cylindrical: 2, uv: 3 } as const;
export const Blends = {
  normal: 0,
  multiply: 1,
  screen: 2,
  overlay: 3,
  darken: 4,
  lighten: 5,
  colorDodge: 6,
  colorBurn: 7,
  hardLight: 8,
  softLight: 9,
  difference: 10,
  exclusion: 11,
  hue: 12,
  saturation: 13,
  color: 14,
  luminosity: 15,
  erase: 16,
} as const;
export const BlendSpaces = { srgb: 0, linear: 1 } as const;
export const Wraps = { none: 0, repeat: 1 } as const;
export const Occlusions = { self: 0, none: 1 } as const;
export const Tips = { round: 0, picture: 1, mask: 2 } as const;
export const GradientKinds = { linear: 0, radial: 1 } as const;
export const ZoneKinds = { uv: 0, box: 1 } as const;
export const PrintMaps = { pixels: 0, texels: 1, stretch: 2 } as const;

export const SessionDefLayout = defineStruct({ memoryBudgetMib: u32 });

export const SessionStatsLayout = defineStruct({
  bakeCount: u32,
  projectionCount: u32,
  projectedTexels: u32,
  compositedTexels: u32,
  memoryUsedKib: u32,
  memoryPeakKib: u32,
  memoryBudgetKib: u32,
});

export const ModelInfoLayout = defineStruct({
  materialCount: u32,
  triangleCount: u32,
  vertexCount: u32,
  hasDefaultMaterial: u32,
  boundsMinModel: f32Array(3),
  boundsMaxModel: f32Array(3),
});

export const MaterialInfoLayout = defineStruct({
  paintStatus: u32,
  triangleCount: u32,
  degenerateUvTriangles: u32,
  outOfRangeUvTriangles: u32,
  texCoord: u32,
  image: u32,
  nearestFilter: u32,
  baseColorFactor: f32Array(4),
  uvMin: f32Array(2),
  uvMax: f32Array(2),
  boundsMinModel: f32Array(3),
  boundsMaxModel: f32Array(3),
});

export const MeshDefLayout = defineStruct({ vertexCount: u32, indexCount: u32, material: u32 });

export const TargetDefLayout = defineStruct({
  material: u32,
  width: u32,
  height: u32,
  gutter: u32,
  mipLevels: u32,
  textureWidth: u32,
  textureHeight: u32,
  windowX: u32,
  windowY: u32,
});

export const MapInfoLayout = defineStruct({
  width: u32,
  height: u32,
  gutter: u32,
  coveredTexels: u32,
  gutterTexels: u32,
  overlappingTexels: u32,
  byteCount: u32,
  mipLevels: u32,
  boundsMinModel: f32Array(3),
  boundsMaxModel: f32Array(3),
});

/** A projector of any kind, as layers and dabs have it. */
const projectorFields = {
  projector: u32,
  positionModel: f32Array(3),
  rotation: f32Array(4),
  size: f32Array(3),
  fovDegrees: f32,
  aspect: f32,
  nearDistance: f32,
  farDistance: f32,
  radius: f32,
  height: f32,
  arcDegrees: f32,
  depth: f32,
  uvCenter: f32Array(2),
  uvSize: f32Array(2),
  uvAngleDegrees: f32,
} as const;

export const LayerDefLayout = defineStruct({
  kind: u32,
  image: u32,
  visible: u32,
  opacity: f32,
  blend: u32,
  blendSpace: u32,
  lockAlpha: u32,
  filter: u32,
  wrap: u32,
  flipX: u32,
  flipY: u32,
  backfaces: u32,
  angleFadeStart: f32,
  angleFadeEnd: f32,
  occlusion: u32,
  ...projectorFields,
  color: f32Array(4),
  tip: u32,
  hardness: f32,
  flow: f32,
  parent: u32,
  role: u32,
  isolated: u32,
  invertMask: u32,
});

export const GradientLayout = defineStruct({
  kind: u32,
  fromModel: f32Array(3),
  toModel: f32Array(3),
  radius: f32,
  stopCount: u32,
  offsets: f32Array(MAX_STOPS),
  colors: f32Array(4 * MAX_STOPS),
});

export const DabLayout = defineStruct({ flow: f32, flipX: u32, ...projectorFields });

export const RectLayout = defineStruct({ x: u32, y: u32, width: u32, height: u32, level: u32, byteOffset: u32 });

export const UpdateLayout = defineStruct({
  rectCount: u32,
  byteCount: u32,
  projectedLayers: u32,
  projectedTexels: u32,
  compositedTexels: u32,
  unfinished: u32,
});

export const ZoneLayout = defineStruct({
  kind: u32,
  material: u32,
  firstCorner: u32,
  cornerCount: u32,
  positionModel: f32Array(3),
  rotation: f32Array(4),
  size: f32Array(3),
  safe: f32,
  bleed: f32,
});

export const ZoneSurfaceLayout = defineStruct({
  texels: u32,
  firstX: u32,
  firstY: u32,
  endX: u32,
  endY: u32,
  area: f32,
  metric: f32Array(3),
  up: f32Array(2),
  mirrored: f32,
});

export const LayerMetricsLayout = defineStruct({
  leastPixelsPerMetre: f32,
  meanPixelsPerMetre: f32,
  leastTexelsPerMetre: f32,
  meanTexelsPerMetre: f32,
  greatestStretch: f32,
  meanStretch: f32,
  clipped: f32,
  hidden: f32,
  outsideZones: f32,
  inSafeMargin: f32,
  paintedTexels: u32,
  overlappingTexels: u32,
  mirroredTexels: u32,
  area: f32,
});

type ValueOf<Layout> = Layout extends { readonly fields: infer Fields extends StructFields }
  ? StructValue<Fields>
  : never;
export type SessionDef = ValueOf<typeof SessionDefLayout>;
export type SessionStats = ValueOf<typeof SessionStatsLayout>;
export type CoreModelInfo = ValueOf<typeof ModelInfoLayout>;
export type CoreMaterialInfo = ValueOf<typeof MaterialInfoLayout>;
export type TargetDef = ValueOf<typeof TargetDefLayout>;
export type MapInfo = ValueOf<typeof MapInfoLayout>;
export type LayerDef = ValueOf<typeof LayerDefLayout>;
export type CoreGradient = ValueOf<typeof GradientLayout>;
export type Dab = ValueOf<typeof DabLayout>;
export type Rect = ValueOf<typeof RectLayout>;
export type CoreZone = ValueOf<typeof ZoneLayout>;
export type ZoneSurface = ValueOf<typeof ZoneSurfaceLayout>;
export type LayerMetrics = ValueOf<typeof LayerMetricsLayout>;

/** Functions of the module by name, each with how many arguments it takes: all are 32-bit numbers. */
export const CORE_FUNCTIONS = {
  txc_abi_version: 0,
  txc_status_count: 0,
  txc_status_name: 1,
  txc_status_message: 1,
  txc_error_detail: 0,
  txc_alloc: 1,
  txc_free: 1,
  txc_session_def_default: 1,
  txc_session_create: 2,
  txc_session_destroy: 1,
  txc_session_stats: 2,
  txc_model_load_glb: 3,
  txc_mesh_def_default: 1,
  txc_model_add_mesh: 6,
  txc_model_info: 2,
  txc_material_info: 3,
  txc_material_uvs: 4,
  txc_target_def_default: 1,
  txc_target_create: 3,
  txc_target_bake: 4,
  txc_target_destroy: 2,
  txc_map_info: 3,
  txc_map_read_positions: 5,
  txc_map_read_normals: 5,
  txc_map_read_coverage: 5,
  txc_map_read_overlap: 5,
  txc_map_view: 6,
  txc_target_set_base: 6,
  txc_target_set_base_color: 6,
  txc_image_create: 5,
  txc_image_destroy: 2,
  txc_layer_def_default: 1,
  txc_layer_create: 4,
  txc_layer_update: 3,
  txc_layer_move: 3,
  txc_layer_destroy: 2,
  txc_layer_def: 3,
  txc_gradient_default: 1,
  txc_fill_set_gradient: 3,
  txc_fill_set_triangles: 4,
  txc_dab_default: 1,
  txc_stroke_add_dabs: 4,
  txc_stroke_clear: 2,
  txc_stroke_dab_count: 3,
  txc_stroke_dabs: 5,
  txc_target_update: 4,
  txc_layer_prepare: 6,
  txc_layer_miniature: 5,
  txc_target_update_rects: 2,
  txc_target_level: 3,
  txc_target_read: 8,
  txc_target_read_bled: 5,
  txc_target_hash: 7,
  txc_zone_default: 1,
  txc_session_set_zones: 5,
  txc_zone_mask: 6,
  txc_zone_surface: 4,
  txc_layer_metrics: 5,
  txc_layer_print_map: 6,
} as const;

export type CoreFunction = keyof typeof CORE_FUNCTIONS;
