/** A small model that has a bit of all that a glTF file may have, for tests that break its members one by one. */
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { buildModel, cube, plane } from "./model-builder.ts";
import { solidPng } from "./png-file.ts";

const TRANSFORM = { KHR_texture_transform: { offset: [0, 0], rotation: 0, scale: [1, 1], texCoord: 0 } };

/** Names, textures, a camera, a light, a skeleton, a morph target, an animation, instances and extensions of materials. */
export function manySidedModel(): { json: JsonObject; binary: Uint8Array } {
  const { json, binary } = buildModel({
    meshes: [cube(0), plane(1, 1)],
    materials: [
      {
        name: "paint",
        alphaMode: "MASK",
        alphaCutoff: 0.5,
        doubleSided: true,
        emissiveFactor: [0, 0, 0],
        pbrMetallicRoughness: {
          baseColorFactor: [1, 1, 1, 1],
          baseColorTexture: { index: 0, texCoord: 0, extensions: TRANSFORM },
          metallicFactor: 0,
          metallicRoughnessTexture: { index: 0 },
        },
        normalTexture: { index: 0, scale: 1 },
        occlusionTexture: { index: 0, strength: 1 },
        emissiveTexture: { index: 0 },
      },
      {
        extensions: {
          KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatTexture: { index: 0 } },
          KHR_materials_sheen: { sheenColorFactor: [1, 1, 1], sheenColorTexture: { index: 0 } },
          KHR_materials_volume: { attenuationColor: [1, 1, 1], thicknessTexture: { index: 0 } },
        },
      },
    ],
    textures: [{ source: 0, sampler: 0, name: "picture" }],
    samplers: [{ magFilter: 9728, minFilter: 9987, wrapS: 10497, wrapT: 33071, name: "sampler" }],
    images: [{ bytes: solidPng(4, 4, [1, 2, 3, 255]), mimeType: "image/png", name: "picture" }],
  });
  const accessors = json.accessors as JsonObject[];
  const add = (values: readonly number[], type: string, size: number): number => {
    const more = new Uint8Array(Float32Array.from(values).buffer);
    const bufferView = (json.bufferViews as JsonObject[]).push({
      buffer: 0,
      byteOffset: parts.reduce((sum, part) => sum + part.length, 0),
      byteLength: more.length,
    });
    parts.push(more);
    const count = values.length / size;
    return accessors.push({ bufferView: bufferView - 1, componentType: 5126, count, type, byteOffset: 0 }) - 1;
  };
  const parts = [binary];
  const times = add([0, 1], "SCALAR", 1);
  const turns = add([0, 0, 0, 1, 0, 0, 0, 1], "VEC4", 4);
  const places = add([0, 0, 0, 2, 0, 0], "VEC3", 3);
  const [mesh = {}] = json.meshes as JsonObject[];
  for (const primitive of mesh.primitives as JsonObject[]) {
    const count = accessors[(primitive.attributes as JsonObject).POSITION as number]?.count as number;
    const still = add(new Array<number>(count * 3).fill(0), "VEC3", 3);
    Object.assign(accessors[still] as JsonObject, { min: [0, 0, 0], max: [0, 0, 0] });
    Object.assign(primitive, { mode: 4, targets: [{ POSITION: still }] });
  }
  Object.assign(mesh, { name: "shape", weights: [0] });
  Object.assign(json, {
    extensionsUsed: ["KHR_lights_punctual", "KHR_texture_transform", "EXT_mesh_gpu_instancing"],
    extensions: { KHR_lights_punctual: { lights: [{ type: "point", color: [1, 1, 1], intensity: 1, name: "lamp" }] } },
    scenes: [{ nodes: [0, 2], name: "scene", extras: { any: 1 } }],
    nodes: [
      { name: "body", mesh: 0, children: [1], scale: [1, 1, 1], rotation: [0, 0, 0, 1], translation: [0, 0, 0] },
      { name: "eye", camera: 0, extensions: { KHR_lights_punctual: { light: 0 } } },
      { name: "tiles", mesh: 0, extensions: { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION: places } } } },
    ],
    cameras: [{ type: "perspective", name: "camera", perspective: { yfov: 1, znear: 0.1, zfar: 10, aspectRatio: 1 } }],
    skins: [{ joints: [1], skeleton: 1, name: "skin" }],
    animations: [
      {
        name: "turn",
        channels: [{ sampler: 0, target: { node: 0, path: "rotation" } }],
        samplers: [{ input: times, output: turns, interpolation: "LINEAR" }],
      },
    ],
  });
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  (json.buffers as JsonObject[])[0] = { byteLength: whole.length };
  return { json, binary: whole };
}
