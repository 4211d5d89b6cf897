/**
 * Gives every triangle of a material a place of its own on the base colour texture, so that it can be painted by itself: new
 * texture coordinates as a further set, which that texture alone uses, and its picture laid on them as it looked. Other
 * textures, skins, morph targets and animations stay as they were.
 */
import { Filters } from "../../core/abi.ts";
import { TexelcastError } from "../../core/texelcast-error.ts";
import { Accessors } from "../accessors.ts";
import { loadBasePicture } from "../base-picture.ts";
import type { ModelSource, Picture } from "../engine-api.ts";
import { parseJson, readContainer, writeGlb } from "../gltf-container.ts";
import { indexAt, isObject, type JsonObject, type JsonValue, listForWriting, listOf, objectAt } from "../gltf-json.ts";
import { giveHidden } from "../hidden-nodes.ts";
import { loadModelFile } from "../model-loader.ts";
import { findBaseTexture } from "../model-textures.ts";
import { type TextureEdit, writeModel } from "../model-writer.ts";
import { encodePng } from "../png-encoder.ts";
import { TEXTURE_TRANSFORM, texturePlace } from "../texture-place.ts";
import { layOutCharts } from "./chart-atlas.ts";
import { chartMeshes, type MaterialPart, readPart, usesOf } from "./material-parts.ts";
import { plainColor } from "./plain-color.ts";
import { type MovedTriangles, resampleTexture, type Wrap } from "./texture-resampler.ts";
import { writePart } from "./write-part.ts";

export interface UnwrapOptions {
  /** glTF material indices; one past the last is the implied default material. */
  readonly materials: readonly number[];
  /** Side of the new textures, texels. */
  readonly size: number;
  /** Share of the work that is done, 0 to 1. */
  readonly onProgress?: (share: number) => void;
}

export interface UnwrappedMaterial {
  readonly material: number;
  readonly triangles: number;
  readonly charts: number;
  /** Triangles that could not be given a place: they have no area, or next to none. */
  readonly withoutPlace: number;
  /** The UV set that the texture uses now. */
  readonly texCoord: number;
}

export interface UnwrappedModel {
  /** Self-contained and uncompressed. */
  readonly glb: Uint8Array<ArrayBuffer>;
  readonly materials: readonly UnwrappedMaterial[];
}

/** Viewers read sets 0 to 3; more have no name in three.js. */
const LAST_SET = 3;
const WRAPS: Readonly<Record<number, Wrap>> = { 33071: "clamp", 33648: "mirror" };

/**
 * The model unwrapped. Throws as `loadModelFile`, and "no-material", "no-triangles", "bad-size", "unsupported" and "bad-picture".
 * The same bytes in the browser and in Node.
 */
export async function unwrapModel(source: ModelSource, options: UnwrapOptions): Promise<UnwrappedModel> {
  const { name } = source;
  const { onProgress = () => undefined } = options;
  const model = await loadModelFile(source);
  const container = readContainer({ name, bytes: model.glb });
  const json = parseJson(container);
  giveHidden(json, model.packed.json, name);
  const accessors = new Accessors(json, container.binary, name);
  const edits: TextureEdit[] = [];
  const materials: UnwrappedMaterial[] = [];
  for (const [done, material] of options.materials.entries()) {
    const step = (share: number): void => onProgress((done + share) / options.materials.length);
    step(0);
    const { faces, others } = usesOf(json, material, name);
    if (faces.length === 0) throw nothingToUnwrap(json, material, name);
    // Read where numbers are numbers; written where those that JavaScript cannot hold are kept.
    const place = texturePlace(container.json, material, name);
    const parts = faces.map((face) => readPart(container.json, face, place, accessors, name));
    const { picture, filter, factorBaked } = await loadBasePicture(model, { material });
    const layout = await layOutCharts(chartMeshes(parts), {
      size: options.size,
      padding: paddingFor(options.size),
      name,
    });
    step(0.4);
    const work = { parts, corners: layout.corners, filter, size: options.size, name };
    const rgba =
      picture === null
        ? filled(options.size, plainColor(container.json, material, name))
        : repaint(json, material, { ...work, picture });
    step(0.7);
    const texCoord = freeSet(json, parts, name);
    const withoutPlace = parts.map((part, i) => {
      const corners = new Float32Array(layout.corners[i] as Float32Array);
      const lost = placeTheRest(part, corners);
      writePart(
        part,
        corners.map((texels) => texels / options.size),
        texCoord,
        accessors,
      );
      return lost;
    });
    if (others.length > 0) setAside(json, material, others, name);
    moveTexture(json, material, texCoord, name);
    const png = await encodePng({ width: options.size, height: options.size, rgba });
    edits.push({ material, png, texCoord, factorBaked });
    materials.push({
      material,
      triangles: parts.reduce((sum, { indices }) => sum + indices.length / 3, 0),
      charts: layout.charts,
      withoutPlace: withoutPlace.reduce((sum, lost) => sum + lost, 0),
      texCoord,
    });
    step(1);
  }
  const moved = readContainer({ name, bytes: writeGlb(json, accessors.finish(), model.original.extraChunks) });
  return { glb: writeModel(moved, edits), materials };
}

/** Between two charts both have room for their gutters (spec.md, 2), if all charts fit so (chart-atlas.ts). */
const paddingFor = (size: number): number => 2 * Math.max(2, Math.round(size / 512));

function nothingToUnwrap(json: JsonObject, material: number, name: string): TexelcastError {
  const last = listOf(json, "materials", name).length - 1;
  const details = { subject: name, field: "material", value: String(material) };
  if (material > last + 1) {
    return new TexelcastError("no-material", `“${name}” has no material ${material}.`, details);
  }
  return new TexelcastError("no-triangles", `Material ${material} of “${name}” has no triangles to unwrap.`, details);
}

interface Repainting {
  readonly parts: readonly MaterialPart[];
  readonly corners: readonly Float32Array[];
  readonly picture: Picture;
  readonly filter: number;
  readonly size: number;
  readonly name: string;
}

/**
 * A square of one colour. A material without a picture is of its factor alone, which becomes the picture: left to be
 * multiplied in, it would dye what is painted, on black CAD parts to black.
 */
const filled = (size: number, color: readonly number[]): Uint8Array =>
  Uint8Array.from({ length: 4 * size * size }, (_, i) => color[i % 4] as number);

/** The picture as the model showed it, on the new coordinates; the material's factor stays. */
function repaint(json: JsonObject, material: number, work: Repainting): Uint8Array {
  const { parts, corners, picture, filter, size, name } = work;
  const texture = listOf(json, "textures", name)[findBaseTexture(json, material, name)?.texture ?? -1];
  const sampler = listOf(json, "samplers", name)[indexAt(texture, "sampler") ?? -1];
  const wrap = (key: string): Wrap => WRAPS[indexAt(sampler, key) ?? 0] ?? "repeat";
  const meshes = parts.map(({ indices, uvs }, i): MovedTriangles => {
    const from = new Float64Array(2 * indices.length);
    for (const [corner, vertex] of indices.entries()) {
      // Without coordinates, viewers show the colour of the picture's corner.
      from[2 * corner] = uvs?.[2 * vertex] ?? 0;
      from[2 * corner + 1] = uvs?.[2 * vertex + 1] ?? 0;
    }
    return { from, to: corners[i] as Float32Array };
  });
  const old = { picture, wrap: [wrap("wrapS"), wrap("wrapT")] as const, nearest: filter === Filters.nearest };
  return resampleTexture(old, meshes, size);
}

/**
 * A triangle that xatlas left out is drawn in the colour of one point, that of a corner which a neighbour has a place for.
 * Returns how many there are.
 */
function placeTheRest({ indices, positions }: MaterialPart, corners: Float32Array): number {
  const lost: number[] = [];
  for (let corner = 0; corner < indices.length; corner += 3) if (Number.isNaN(corners[2 * corner])) lost.push(corner);
  if (lost.length === 0) return 0;
  const keyOf = (corner: number): string => {
    const at = 3 * (indices[corner] as number);
    return `${positions[at]} ${positions[at + 1]} ${positions[at + 2]}`;
  };
  const known = new Map<string, number>();
  for (let corner = 0; corner < indices.length; corner++) {
    if (!Number.isNaN(corners[2 * corner])) known.set(keyOf(corner), corner);
  }
  for (const first of lost) {
    const found = [first, first + 1, first + 2]
      .map((corner) => known.get(keyOf(corner)))
      .find((near) => near !== undefined);
    const u = found === undefined ? 0 : (corners[2 * found] as number);
    const v = found === undefined ? 0 : (corners[2 * found + 1] as number);
    for (let corner = first; corner < first + 3; corner++) {
      corners[2 * corner] = u;
      corners[2 * corner + 1] = v;
    }
  }
  return lost.length;
}

/** The first UV set that none of the parts has; where all four are taken, one that no texture uses. */
function freeSet(json: JsonObject, parts: readonly MaterialPart[], name: string): number {
  const taken = parts.flatMap(({ primitive }) => Object.keys(objectAt(primitive, "attributes") ?? {}));
  for (let set = 0; set <= LAST_SET; set++) if (!taken.includes(`TEXCOORD_${set}`)) return set;
  const used = new Set<number>();
  const visit = (value: JsonValue | undefined): void => {
    if (Array.isArray(value)) value.forEach(visit);
    if (!isObject(value)) return;
    for (const [key, member] of Object.entries(value)) {
      if (/texture$/i.test(key) && isObject(member)) {
        const transform = objectAt(objectAt(member, "extensions"), TEXTURE_TRANSFORM);
        if (key !== "baseColorTexture") used.add(indexAt(transform, "texCoord") ?? indexAt(member, "texCoord") ?? 0);
      }
      visit(member);
    }
  };
  visit(listOf(json, "materials", name));
  for (let set = LAST_SET; set >= 0; set--) if (!used.has(set)) return set;
  throw new TexelcastError(
    "unsupported",
    `All four texture coordinates of “${name}” are in use, so there is no room for new ones.`,
    {
      subject: name,
      field: "TEXCOORD_3",
      hint: "Take out a set that is not needed in a 3D program, and export the model again.",
    },
  );
}

/** What is not unwrapped keeps the old picture: a copy of the material, behind all others. */
function setAside(json: JsonObject, material: number, others: readonly JsonObject[], name: string): void {
  nameImplied(json, name);
  const materials = listForWriting(json, "materials", name);
  const copy = materials.push(structuredClone(materials[material] as JsonObject)) - 1;
  for (const user of others) user.material = copy;
}

/** Gives primitives without a material one of the number that theirs is called by, which the next new one would have. */
function nameImplied(json: JsonObject, name: string): void {
  const bare = listOf(json, "meshes", name)
    .flatMap(({ primitives }) => (Array.isArray(primitives) ? primitives.filter(isObject) : []))
    .filter((primitive) => primitive.material === undefined);
  if (bare.length === 0) return;
  const material = listForWriting(json, "materials", name).push({}) - 1;
  for (const primitive of bare) primitive.material = material;
}

/** The texture stays, on the new set: what KHR_texture_transform said was of the old one. */
function moveTexture(json: JsonObject, material: number, texCoord: number, name: string): void {
  const pbr = objectAt(listOf(json, "materials", name)[material], "pbrMetallicRoughness");
  const info = objectAt(pbr, "baseColorTexture");
  if (info === undefined) return;
  info.texCoord = texCoord;
  const extensions = objectAt(info, "extensions");
  if (extensions === undefined) return;
  delete extensions[TEXTURE_TRANSFORM];
  if (Object.keys(extensions).length === 0) delete info.extensions;
}
