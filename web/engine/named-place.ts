/** Where in a model's file lies what the core says of it: its messages name the place for people, and programs have it as field and value. */
import type { TexelcastErrorDetails } from "../core/texelcast-error.ts";
import { SHAPES } from "./accessor-shapes.ts";
import { indexAt, isObject, type JsonObject, type JsonValue, objectAt, shorten } from "./gltf-json.ts";

type Place = Pick<TexelcastErrorDetails, "field" | "value">;
/** What of the message a rule has found, in order; those of its groups that are not there are empty. */
type Locate = (parts: readonly string[], json: JsonObject) => Place;

const PRIMITIVE = String.raw`(meshes\[\d+\]\.primitives\[\d+\]): `;

/** The member at this place, whose value is as the file has it. */
const at =
  (place: (...parts: string[]) => string): Locate =>
  (parts, json) => {
    const field = place(...parts);
    return { field, value: shown(memberAt(json, field)) };
  };

const RULES: readonly (readonly [RegExp, Locate])[] = [
  [
    /(bufferViews\[\d+\]): byteStride (\d+)/,
    ([view, stride]) => ({ field: `${view}.byteStride`, value: stride ?? "" }),
  ],
  [/(accessors\[\d+\]): its (\d+) elements need/, countOf],
  [/(accessors\[\d+\])\.sparse: index (\d+)/, ([of, index]) => ({ field: `${of}.sparse.indices`, value: index ?? "" })],
  [/(accessors\[\d+\]): type .*\((\d+) components\)/, typeOf],
  [/(accessors\[\d+\]): indices must be/, at((accessor) => `${accessor}.componentType`)],
  [/(accessors\[\d+\]): indices without/, at((accessor) => `${accessor}.bufferView`)],
  [/(nodes\[\d+\]) is its own ancestor/, at((node) => `${node}.children`)],
  [/(nodes\[\d+\]) has two parents/, twiceAChild],
  [
    /(nodes\[\d+\]): up to it.* in (\d+) places/,
    ([node, places]) => ({ field: `${node}.mesh`, value: `${places} places` }),
  ],
  [/(skins\[\d+\]) has .* joints but/, at((skin) => `${skin}.inverseBindMatrices`)],
  [/(materials\[\d+\]): KHR_texture_transform/, at((material) => `${material}.pbrMetallicRoughness.baseColorTexture`)],
  [/(images\[\d+\]): bufferViews/, at((image) => `${image}.bufferView`)],
  [new RegExp(`${PRIMITIVE}a morph target`), at((primitive) => `${primitive}.targets`)],
  [
    new RegExp(`${PRIMITIVE}vertex \\d+ names joint (\\d+)`),
    ([of, joint]) => ({ field: `${of}.attributes.JOINTS_0`, value: joint ?? "" }),
  ],
  [new RegExp(`${PRIMITIVE}(JOINTS_\\d+|NORMAL)`), at((of, attribute) => `${of}.attributes.${attribute}`)],
  [new RegExp(`${PRIMITIVE}TEXCOORD`), coordinatesOf],
  [
    new RegExp(`${PRIMITIVE}position \\d+ is (\\(.*?\\))`),
    ([of, place]) => ({ field: `${of}.attributes.POSITION`, value: place ?? "" }),
  ],
  [new RegExp(`${PRIMITIVE}index \\d+ is (\\d+)`), ([of, index]) => ({ field: `${of}.indices`, value: index ?? "" })],
  [/scene has only points/, at(() => "scenes")],
  // What begins with its place, behind what the core says of all bytes.
  [/(?:^|: )([a-zA-Z]\w*(?:\[\d+\]|\.\w+)+)/, at((place) => place)],
];

/** Empty where a message names none. `json` is the file's. */
export function namedPlace(message: string, json: JsonObject): Place {
  for (const [pattern, locate] of RULES) {
    const found = pattern.exec(message);
    if (found !== null) return locate(found.slice(1).map(String), json);
  }
  return {};
}

/** The accessor's own number of elements, or that of the ones that it replaces. */
function countOf([accessor = "", count = ""]: readonly string[], json: JsonObject): Place {
  const own = memberAt(json, `${accessor}.count`) === Number(count);
  return { field: `${accessor}.${own ? "" : "sparse."}count`, value: count };
}

function typeOf([accessor = "", components = ""]: readonly string[], json: JsonObject): Place {
  const type = memberAt(json, `${accessor}.type`);
  const [columns, rows] = SHAPES[String(type)] ?? [0, 0];
  const field = `${accessor}.${columns * rows === Number(components) ? "componentType" : "type"}`;
  return { field, value: shown(memberAt(json, field)) };
}

/** The second list that names the node. */
function twiceAChild([node = ""]: readonly string[], json: JsonObject): Place {
  const index = Number(/\d+/.exec(node)?.[0]);
  const nodes = Array.isArray(json.nodes) ? json.nodes : [];
  const places = nodes.flatMap((parent, n) => {
    const children = isObject(parent) && Array.isArray(parent.children) ? parent.children : [];
    return children.flatMap((child, c) => (child === index ? [`nodes[${n}].children[${c}]`] : []));
  });
  return { field: places[1] ?? node, value: String(index) };
}

/** The set of texture coordinates that is not as long as the places are. */
function coordinatesOf([primitive = ""]: readonly string[], json: JsonObject): Place {
  const attributes = objectAt(memberAt(json, primitive) as JsonObject | undefined, "attributes") ?? {};
  const count = (key: string): JsonValue | undefined =>
    memberAt(json, `accessors[${indexAt(attributes, key) ?? -1}].count`);
  const set = Object.keys(attributes).find((key) => key.startsWith("TEXCOORD_") && count(key) !== count("POSITION"));
  const field = `${primitive}.attributes.${set ?? "TEXCOORD_0"}`;
  return { field, value: shown(memberAt(json, field)) };
}

function memberAt(json: JsonObject, field: string): JsonValue | undefined {
  let member: JsonValue | undefined = json;
  for (const [, key, index] of field.matchAll(/([^.[\]]+)|\[(\d+)\]/g)) {
    if (key !== undefined && isObject(member)) member = Object.hasOwn(member, key) ? member[key] : undefined;
    else if (index !== undefined && Array.isArray(member)) member = member[Number(index)];
    else return undefined;
  }
  return member;
}

const shown = (member: JsonValue | undefined): string => (member === undefined ? "(absent)" : shorten(member));
