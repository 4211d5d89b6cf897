/**
 * The first member of a glTF file that is not what glTF 2.0 asks for. Asked only when a reader has failed: decoders and viewers then
 * say what went wrong inside them, and not where in the file.
 */
import type { TexelcastError } from "../core/texelcast-error.ts";
import { badContainer, indexAt, isObject, type JsonObject, type JsonValue, objectAt } from "./gltf-json.ts";

/** Stops the search: `must` is the end of the sentence “… must be …”. */
class Found {
  readonly field: string;
  readonly value: JsonValue | undefined;
  readonly must: string;

  constructor(field: string, value: JsonValue | undefined, must: string) {
    this.field = field;
    this.value = value;
    this.must = must;
  }
}

/** Throws `Found` for a value that may not stand at `field`. */
type Check = (value: JsonValue | undefined, field: string, json: JsonObject) => void;
type Members = Readonly<Record<string, Check>>;

const rule =
  (must: string, holds: (value: JsonValue | undefined) => boolean): Check =>
  (value, field) => {
    if (!holds(value)) throw new Found(field, value, must);
  };

const isNumber = (value: unknown): value is number => typeof value === "number" && Number.isFinite(value);
const isWhole = (value: unknown, least = 0): value is number => Number.isSafeInteger(value) && Number(value) >= least;

const ANY: Check = () => undefined;
const TEXT = rule("a text", (value) => typeof value === "string");
const FLAG = rule("true or false", (value) => typeof value === "boolean");
const NUMBER = rule("a number", isNumber);
const WHOLE = rule("a whole number from 0 on", (value) => isWhole(value));
const COUNT = rule("a whole number from 1 on", (value) => isWhole(value, 1));
const OBJECT = rule("an object", isObject);
const LIST = rule("a list", Array.isArray);
const STRIDE = rule("a multiple of 4 from 4 to 252", (value) => isWhole(value, 4) && value <= 252 && value % 4 === 0);

const oneOf = (...allowed: readonly (string | number)[]): Check =>
  rule(`one of ${allowed.join(", ")}`, (value) => allowed.includes(value as string));

const numbers = (count: number): Check =>
  rule(
    `a list of ${count} numbers`,
    (value) => Array.isArray(value) && value.length === count && value.every((item) => isNumber(item)),
  );
const NUMBERS = rule("a list of numbers", (value) => Array.isArray(value) && value.every((item) => isNumber(item)));

/** The number of an item in one of the file's lists. */
const indexOf =
  (...path: readonly string[]): Check =>
  (value, field, json) => {
    const list = path.reduce<JsonValue | undefined>((place, key) => (isObject(place) ? place[key] : undefined), json);
    const count = Array.isArray(list) ? list.length : 0;
    const name = path.at(-1);
    const must = count === 0 ? `left out, as the file has no ${name}` : `the number of one of the ${count} ${name}`;
    if (!isWhole(value) || value >= count) throw new Found(field, value, count > 0 ? `${must}, from 0 on` : must);
  };

const listOf =
  (check: Check, least = 0): Check =>
  (value, field, json) => {
    LIST(value, field, json);
    const items = value as JsonValue[];
    if (items.length < least) throw new Found(field, value, "a list with something in it");
    for (const [index, item] of items.entries()) check(item, `${field}[${index}]`, json);
  };

/** All members of an object by one rule, whatever their names. */
const eachIn =
  (check: Check): Check =>
  (value, field, json) => {
    OBJECT(value, field, json);
    for (const [key, member] of Object.entries(value as JsonObject)) check(member, `${field}.${key}`, json);
  };

/** An object: those of `needed` must be there, those of `known` may, and others are nobody's here. */
const shape =
  (needed: Members, known: Members = {}): Check =>
  (value, field, json) => {
    OBJECT(value, field, json);
    const place = field === "" ? "" : `${field}.`;
    for (const [key, check] of Object.entries(needed)) check((value as JsonObject)[key], place + key, json);
    for (const [key, check] of Object.entries({ ...COMMON, ...known })) {
      const member = (value as JsonObject)[key];
      if (member !== undefined) check(member, place + key, json);
    }
  };

const extensions: Check = (value, field, json) => {
  eachIn(OBJECT)(value, field, json);
  for (const [key, member] of Object.entries(value as JsonObject)) {
    const own = Object.hasOwn(EXTENSIONS, key) ? EXTENSIONS[key] : MATERIALS.test(key) ? materialExtension : ANY;
    own?.(member, `${field}.${key}`, json);
  }
};

/** Those of `materialExtension`. */
const MATERIALS = /^KHR_materials_/;
const COMMON: Members = { name: TEXT, extensions };

const VIEW = indexOf("bufferViews");
const ACCESSOR = indexOf("accessors");
const MATERIAL = indexOf("materials");
const COLOR = numbers(3);
const TEXTURE = shape({ index: indexOf("textures") }, { texCoord: WHOLE, scale: NUMBER, strength: NUMBER });
const ATTRIBUTES = eachIn(ACCESSOR);
const COMPONENT = oneOf(5120, 5121, 5122, 5123, 5125, 5126);

/** What members of an accessor ask of each other: numbers begin at multiples of their size. */
const laidOut: Check = (value, field, json) => {
  const { componentType, byteOffset, bufferView, normalized } = value as JsonObject;
  const size = [5120, 5121].includes(componentType as number)
    ? 1
    : [5122, 5123].includes(componentType as number)
      ? 2
      : 4;
  const views = Array.isArray(json.bufferViews) ? json.bufferViews : [];
  const view = views[bufferView as number];
  const start = isObject(view) ? (indexAt(view, "byteOffset") ?? 0) : 0;
  if (start % size !== 0) {
    throw new Found(`bufferViews[${bufferView}].byteOffset`, start, `a multiple of ${size}, for ${field} lies there`);
  }
  if (normalized === true && size === 4)
    throw new Found(`${field}.normalized`, true, "left out where numbers are not short");
  if (Number(byteOffset ?? 0) % size !== 0) throw new Found(`${field}.byteOffset`, byteOffset, `a multiple of ${size}`);
};

const both =
  (...checks: readonly Check[]): Check =>
  (value, field, json) => {
    for (const check of checks) check(value, field, json);
  };

const accessor = shape(
  { componentType: COMPONENT, count: COUNT, type: oneOf("SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4") },
  {
    bufferView: VIEW,
    byteOffset: WHOLE,
    normalized: FLAG,
    min: NUMBERS,
    max: NUMBERS,
    sparse: shape({
      count: COUNT,
      indices: shape({ bufferView: VIEW, componentType: oneOf(5121, 5123, 5125) }, { byteOffset: WHOLE }),
      values: shape({ bufferView: VIEW }, { byteOffset: WHOLE }),
    }),
  },
);

/** The samplers of an animation are its own. */
const animation: Check = (value, field, json) => {
  const sampler = shape({ input: ACCESSOR, output: ACCESSOR }, { interpolation: TEXT });
  shape({ samplers: listOf(sampler, 1) })(value, field, json);
  const own: Check = (index, at) => indexOf("samplers")(index, at, value as JsonObject);
  const target = shape({ path: TEXT }, { node: indexOf("nodes") });
  shape({ channels: listOf(shape({ sampler: own, target }), 1) })(value, field, json);
};

const camera = shape(
  { type: oneOf("perspective", "orthographic") },
  {
    perspective: shape({ yfov: NUMBER, znear: NUMBER }, { aspectRatio: NUMBER, zfar: NUMBER }),
    orthographic: shape({ xmag: NUMBER, ymag: NUMBER, zfar: NUMBER, znear: NUMBER }),
  },
);

const material = shape(
  {},
  {
    pbrMetallicRoughness: shape(
      {},
      {
        baseColorFactor: numbers(4),
        baseColorTexture: TEXTURE,
        metallicFactor: NUMBER,
        roughnessFactor: NUMBER,
        metallicRoughnessTexture: TEXTURE,
      },
    ),
    normalTexture: TEXTURE,
    occlusionTexture: TEXTURE,
    emissiveTexture: TEXTURE,
    emissiveFactor: numbers(3),
    alphaMode: oneOf("OPAQUE", "MASK", "BLEND"),
    alphaCutoff: NUMBER,
    doubleSided: FLAG,
  },
);

const primitive = both(
  shape(
    { attributes: ATTRIBUTES },
    { indices: ACCESSOR, material: MATERIAL, mode: oneOf(0, 1, 2, 3, 4, 5, 6), targets: listOf(ATTRIBUTES) },
  ),
  (value, field) => {
    const packed = objectAt(objectAt(objectAt(value as JsonObject, "extensions"), DRACO), "attributes") ?? {};
    const lone = Object.keys(packed).find((key) => objectAt(value as JsonObject, "attributes")?.[key] === undefined);
    if (lone !== undefined) {
      throw new Found(
        `${field}.attributes.${lone}`,
        undefined,
        "the number of one of the accessors, for it is compressed",
      );
    }
  },
);

/** As far off as the core lets it be (gltf_container.cpp), which glTF's validator does, too. */
const UNIT = rule("a unit quaternion, whose squares add up to 1", (value) => {
  const square = (value as number[]).reduce((sum, part) => sum + part * part, 0);
  return Math.abs(square - 1) <= 0.0154;
});

const node = shape(
  {},
  {
    camera: indexOf("cameras"),
    children: listOf(indexOf("nodes")),
    skin: indexOf("skins"),
    matrix: numbers(16),
    mesh: indexOf("meshes"),
    rotation: both(numbers(4), UNIT),
    scale: numbers(3),
    translation: numbers(3),
    weights: NUMBERS,
  },
);

const sampler = shape(
  {},
  {
    magFilter: oneOf(9728, 9729),
    minFilter: oneOf(9728, 9729, 9984, 9985, 9986, 9987),
    wrapS: oneOf(33071, 33648, 10497),
    wrapT: oneOf(33071, 33648, 10497),
  },
);

const image: Check = (value, field, json) => {
  shape({}, { uri: TEXT, mimeType: TEXT, bufferView: VIEW })(value, field, json);
  const { uri, bufferView } = value as JsonObject;
  if (uri !== undefined || bufferView !== undefined) return;
  throw new Found(`${field}.bufferView`, bufferView, "the number of one of the bufferViews where there is no uri");
};

const PICTURE_SOURCE = shape({}, { source: indexOf("images") });
const COMPRESSED_VIEW = shape({
  buffer: indexOf("buffers"),
  byteLength: COUNT,
  count: COUNT,
  byteStride: COUNT,
  mode: TEXT,
});
/** On a buffer it says only that there are no bytes. */
const meshopt: Check = (value, field, json) => {
  if (!field.startsWith("buffers[")) COMPRESSED_VIEW(value, field, json);
};

/** The many extensions of materials are told apart by nothing that is read here: their textures and colours are named alike. */
const materialExtension: Check = (value, field, json) => {
  for (const [key, member] of Object.entries(value as JsonObject)) {
    if (key.endsWith("Texture")) TEXTURE(member, `${field}.${key}`, json);
    else if (/Color(Factor)?$/.test(key)) COLOR(member, `${field}.${key}`, json);
  }
};

const DRACO = "KHR_draco_mesh_compression";
const LIGHTS = "KHR_lights_punctual";
const light = shape(
  { type: oneOf("directional", "point", "spot") },
  { color: COLOR, intensity: NUMBER, range: NUMBER, spot: OBJECT },
);

const EXTENSIONS: Members = {
  EXT_mesh_gpu_instancing: shape({ attributes: ATTRIBUTES }),
  EXT_meshopt_compression: meshopt,
  KHR_meshopt_compression: meshopt,
  EXT_texture_avif: PICTURE_SOURCE,
  EXT_texture_webp: PICTURE_SOURCE,
  KHR_texture_basisu: PICTURE_SOURCE,
  [DRACO]: shape({ bufferView: VIEW, attributes: eachIn(WHOLE) }),
  KHR_texture_transform: shape({}, { offset: numbers(2), scale: numbers(2), rotation: NUMBER, texCoord: WHOLE }),
  [LIGHTS]: shape({}, { lights: listOf(light), light: indexOf("extensions", LIGHTS, "lights") }),
};

const FILE = shape(
  {},
  {
    accessors: listOf(both(accessor, laidOut)),
    animations: listOf(animation),
    buffers: listOf(shape({ byteLength: COUNT }, { uri: TEXT })),
    bufferViews: listOf(
      shape({ buffer: indexOf("buffers"), byteLength: COUNT }, { byteOffset: WHOLE, byteStride: STRIDE }),
    ),
    cameras: listOf(camera),
    extensionsRequired: listOf(TEXT),
    extensionsUsed: listOf(TEXT),
    images: listOf(image),
    materials: listOf(material),
    meshes: listOf(shape({ primitives: listOf(primitive, 1) }, { weights: NUMBERS })),
    nodes: listOf(node),
    samplers: listOf(sampler),
    scene: indexOf("scenes"),
    scenes: listOf(shape({}, { nodes: listOf(indexOf("nodes")) })),
    skins: listOf(
      shape({ joints: listOf(indexOf("nodes"), 1) }, { inverseBindMatrices: ACCESSOR, skeleton: indexOf("nodes") }),
    ),
    textures: listOf(shape({}, { sampler: indexOf("samplers"), source: indexOf("images") })),
  },
);

/** Null where all that is looked at here is as it must be. `name` is the file that the error, a "bad-container", names. */
export function gltfFault(json: JsonObject, name: string): TexelcastError | null {
  try {
    FILE(json, "", json);
    return null;
  } catch (found) {
    if (!(found instanceof Found)) throw found;
    const { field, value, must } = found;
    return badContainer(name, `“${field}” must be ${must}, and is ${shown(value)}`, field, value ?? "(absent)");
  }
}

/** As it stands in the file, if it is short. */
function shown(value: JsonValue | undefined): string {
  if (value === undefined) return "missing";
  const text = JSON.stringify(value);
  if (text.length <= 40) return text;
  return Array.isArray(value) ? `a list of ${value.length}` : typeof value === "object" ? "an object" : "a long text";
}
