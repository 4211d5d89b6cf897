/** What `texelcast inspect` finds out about a model: plain data, the same that `--json` prints. */
import { TexelcastError } from "../web/core/texelcast-error.ts";
import type { MaterialInfo, ModelInfo, ModelSource, Vec3 } from "../web/engine/engine-api.ts";
import type { EngineHost } from "../web/engine/engine-host.ts";
import { type Variants, variantsOf } from "../web/engine/material-variants.ts";

export interface MaterialReport {
  readonly index: number;
  /** As in the file; "" without one. */
  readonly name: string;
  readonly canTakeDecals: boolean;
  /** Why it cannot; null when it can. */
  readonly refusal: { readonly code: string; readonly message: string } | null;
  readonly triangles: number;
  /** Pixels of the base colour picture; null without one. */
  readonly textureSize: readonly [number, number] | null;
  readonly uv: {
    /** The UV set that the base colour texture names. */
    readonly set: number;
    readonly min: readonly [number, number];
    readonly max: readonly [number, number];
    /** Triangles with a UV outside 0 to 1: they wrap. */
    readonly outOfRangeTriangles: number;
    /** Triangles without area in the texture: they own no texel. */
    readonly degenerateTriangles: number;
    /** What a bake measured; null for a material that cannot take decals. */
    readonly measured: UvMeasure | null;
  };
  readonly bounds: Bounds;
}

export interface UvMeasure {
  readonly size: readonly [number, number];
  /** Texels that triangles cover, as a share of all. */
  readonly coverage: number;
  /** Texels that two triangles or more cover, as a share of the covered. */
  readonly overlap: number;
}

/** Metres, model space. */
export interface Bounds {
  readonly min: Vec3;
  readonly max: Vec3;
}

export interface ModelReport {
  readonly file: string;
  readonly triangles: number;
  readonly vertices: number;
  readonly bounds: Bounds;
  readonly materials: readonly MaterialReport[];
  /** Of its materials (KHR_materials_variants), where it has some; `shown` is null where the file's own look is none of them. */
  readonly variants?: { readonly names: readonly string[]; readonly shown: string | null };
}

const DEFAULT_SIZE = 1024;

/** Shares hardly change beyond, and the time grows with the square. */
const LARGEST_MEASURED_SIZE = 4096;

/**
 * Loads the model, which is no zip, and bakes each material that can take decals, one at a time.
 *
 * @param onProgress The material under way and the share of its bake.
 */
export async function inspectModel(
  engine: EngineHost,
  source: ModelSource,
  onProgress: (material: number, share: number) => void,
): Promise<ModelReport> {
  const model = await engine.loadModel(source);
  const materials: MaterialReport[] = [];
  for (const material of model.materials) {
    if (material.refusal !== null) {
      materials.push(reportMaterial(material, null));
      continue;
    }
    try {
      const measured = await measure(engine, material, (share) => onProgress(material.index, share));
      materials.push(reportMaterial(material, measured));
    } catch (thrown) {
      // Known when it is baked, and not before; of the others it says nothing.
      if (!(thrown instanceof TexelcastError && thrown.code === "bad-uvs")) throw thrown;
      materials.push(reportMaterial({ ...material, refusal: thrown }, null));
    }
  }
  return reportModel(model, materials, variantsOf(source));
}

async function measure(
  engine: EngineHost,
  { index, textureSize }: MaterialInfo,
  onProgress: (share: number) => void,
): Promise<UvMeasure> {
  const [width, height] = measuredSize(textureSize);
  // A plain base: the picture itself need not be readable for its UVs to be measured.
  const target = await engine.openTarget({ material: index, width, height, base: [1, 1, 1, 1] }, onProgress);
  await engine.closeTarget(index);
  const { coveredTexels, overlappingTexels } = target;
  return {
    size: [width, height],
    coverage: coveredTexels / (width * height),
    overlap: coveredTexels === 0 ? 0 : overlappingTexels / coveredTexels,
  };
}

function measuredSize(textureSize: MaterialInfo["textureSize"]): readonly [number, number] {
  const [width, height] = textureSize ?? [DEFAULT_SIZE, DEFAULT_SIZE];
  const scale = Math.min(1, LARGEST_MEASURED_SIZE / Math.max(width, height));
  return [Math.max(1, Math.round(width * scale)), Math.max(1, Math.round(height * scale))];
}

function reportMaterial(material: MaterialInfo, measured: UvMeasure | null): MaterialReport {
  return {
    index: material.index,
    name: material.name,
    canTakeDecals: material.refusal === null,
    refusal: material.refusal && { code: material.refusal.code, message: material.refusal.message },
    triangles: material.triangles,
    textureSize: material.textureSize,
    uv: {
      set: material.texCoord,
      min: material.uvMin,
      max: material.uvMax,
      outOfRangeTriangles: material.outOfRangeUvTriangles,
      degenerateTriangles: material.degenerateUvTriangles,
      measured,
    },
    bounds: { min: material.boundsMin, max: material.boundsMax },
  };
}

function reportModel(model: ModelInfo, materials: readonly MaterialReport[], variants: Variants | null): ModelReport {
  return {
    file: model.name,
    triangles: model.triangles,
    vertices: model.vertices,
    bounds: { min: model.boundsMin, max: model.boundsMax },
    materials,
    ...(variants && {
      variants: {
        names: variants.names,
        shown: variants.shown === null ? null : (variants.names[variants.shown] ?? null),
      },
    }),
  };
}
