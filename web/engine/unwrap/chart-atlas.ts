/** Meshes cut into charts and laid side by side on one texture, by xatlas (watlas, in WebAssembly). */
import { Atlas, Initialize } from "watlas";
import { TexelcastError } from "../../core/texelcast-error.ts";

/**
 * A mesh as xatlas takes it. Its places alone: by normals, the soft ones of a shoe became one chart so long that the atlas was
 * a third as high as wide; and watlas 1.0.1 writes texture coordinates where normals belong.
 */
export interface ChartMesh {
  /** Three numbers a vertex, in one scale for all meshes of an atlas. */
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
  /** Its triangles are seen the other way round than they are listed. */
  readonly isMirrored: boolean;
}

export interface ChartLayout {
  /** For each mesh two numbers a corner of its triangles, texels from the top left; NaN for a triangle that got no chart. */
  readonly corners: readonly Float32Array[];
  readonly charts: number;
}

/** Twice xatlas's own: a fifth fewer charts on a character, and so fewer seams and less room between them; more stretch hurts. */
const CHART_COST = 4;
/**
 * Charts as they are seen from outside, none mirrored, so that what is laid on the texture itself reads on the model. Turned by
 * a quarter to fit, xatlas mirrors them; without, the charts of five models covered 0.94 to 1.07 of what they did.
 */
const PACKING = { bilinear: true, rotateCharts: false };
/** Packings that are tried until one fits; each is smaller by what the one before was too large. */
const FIT_STEPS = 24;
/** Between charts, texels: both have room for the gutter of a texture of 1024 texels, which is the least that there is. */
const LEAST_PADDING = 4;
/** Then a larger scale is sought between that and one of this much more, by halves. */
const GROWTH = 1.08;
const GROWTH_STEPS = 3;

/**
 * Lays all meshes on one texture of `size` x `size` texels, `padding` texels apart. Throws "bad-size" where they do not
 * fit, however small.
 */
export async function layOutCharts(
  meshes: readonly ChartMesh[],
  { size, padding, name }: { readonly size: number; readonly padding: number; readonly name: string },
): Promise<ChartLayout> {
  await Initialize();
  const atlas = new Atlas();
  try {
    for (const { positions, indices, isMirrored } of meshes) {
      atlas.addMesh({
        vertexPositionData: positions,
        vertexPositionStride: 12,
        vertexCount: positions.length / 3,
        indexData: isMirrored ? turnedOver(indices, 1) : indices,
        indexCount: indices.length,
      });
    }
    atlas.computeCharts({ maxCost: CHART_COST, fixWinding: true });
    const apart = packToFit(atlas, { size, padding, name });
    return { corners: meshes.map((mesh, i) => cornersOf(atlas, i, mesh, size, apart)), charts: atlas.chartCount };
  } finally {
    atlas.delete();
  }
}

/**
 * Packs `padding` apart, or, where so many charts do not fit, as near to each other as charts on a small texture are: beside a
 * gutter that is cut short stands a chart that would not be there. Returns how far apart they are.
 */
function packToFit(atlas: Atlas, { size, padding, name }: { size: number; padding: number; name: string }): number {
  if (packApart(atlas, size, padding)) return padding;
  if (padding > LEAST_PADDING && packApart(atlas, size, LEAST_PADDING)) return LEAST_PADDING;
  throw new TexelcastError("bad-size", `The ${atlas.chartCount} parts of “${name}” do not fit into ${size} texels.`, {
    subject: name,
    field: "size",
    value: String(size),
    hint: "Choose a larger texture.",
  });
}

/** Packs with the largest scale at which all charts lie inside, with half of the padding left at the texture's border; false without one. */
function packApart(atlas: Atlas, size: number, padding: number): boolean {
  const room = size - padding;
  // Of any size; "resolution" would give several textures.
  const pack = (texelsPerUnit: number): number => {
    atlas.packCharts({ ...PACKING, padding, resolution: 0, texelsPerUnit });
    return Math.max(atlas.width, atlas.height);
  };
  atlas.packCharts({ ...PACKING, padding, resolution: Math.max(1, room), texelsPerUnit: 0 });
  // Nothing but triangles without area: there is no chart to lay anywhere.
  if (atlas.chartCount === 0) return true;
  let scale = atlas.texelsPerUnit;
  let side = pack(scale);
  for (let step = 0; side > room && step < FIT_STEPS; step++) {
    const shrunk = Math.min(0.98, room / side);
    const before = side;
    scale *= shrunk;
    side = pack(scale);
    // What is left is the room between charts that have a texel each.
    if (shrunk < 0.9 && side >= before) return false;
  }
  if (side > room) return false;
  let high = scale * GROWTH;
  for (let step = 0; step < GROWTH_STEPS; step++) {
    const middle = (scale + high) / 2;
    if (pack(middle) <= room) scale = middle;
    else high = middle;
  }
  pack(scale);
  return true;
}

function cornersOf(
  atlas: Atlas,
  index: number,
  { indices, isMirrored }: ChartMesh,
  size: number,
  padding: number,
): Float32Array {
  const mesh = atlas.getMesh(index);
  const placed = new Uint32Array(mesh.indexCount);
  mesh.getIndexArray(placed);
  const known = new Float32Array(2 * mesh.vertexCount);
  const origins = new Int32Array(mesh.vertexCount);
  for (let vertex = 0; vertex < mesh.vertexCount; vertex++) {
    const { uv, xref, chartIndex } = mesh.getVertex(vertex);
    origins[vertex] = xref;
    const free = chartIndex < 0;
    known[2 * vertex] = free ? Number.NaN : uv[0] + padding / 2;
    // It counts rows from below.
    known[2 * vertex + 1] = free ? Number.NaN : size - padding / 2 - uv[1];
  }
  const listed = isMirrored ? turnedOver(indices, 1) : indices;
  const corners = new Float32Array(2 * indices.length).fill(Number.NaN);
  for (const [corner, vertex] of placed.entries()) {
    if (origins[vertex] !== listed[corner]) {
      throw new TexelcastError("internal", "The unwrapped triangles came back in another order.");
    }
    corners[2 * corner] = known[2 * vertex] as number;
    corners[2 * corner + 1] = known[2 * vertex + 1] as number;
  }
  return isMirrored ? turnedOver(corners, 2) : corners;
}

/** The second and the third corner of each triangle in each other's place; `width` numbers a corner. */
function turnedOver<Numbers extends Uint32Array | Float32Array>(values: Numbers, width: number): Numbers {
  const turned = values.slice() as Numbers;
  for (let at = width; at < values.length; at += 3 * width) {
    turned.set(values.subarray(at, at + width), at + width);
    turned.set(values.subarray(at + width, at + 2 * width), at);
  }
  return turned;
}
