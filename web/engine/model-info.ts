/** What the engine tells about a loaded model: the core's counts with the file's names and picture sizes. */
import type { Session } from "../core/session.ts";
import type { MaterialInfo, ModelInfo } from "./engine-api.ts";
import { listOf, textAt } from "./gltf-json.ts";
import { baseTextureSize, type LoadedModel } from "./model-loader.ts";
import { vec3 } from "./open-target.ts";

/** Of the model that the session holds; lengths are metres in model space. `glb` may change (`layAsStored`). */
export async function modelInfo(session: Session, model: LoadedModel, glb: ModelInfo["glb"]): Promise<ModelInfo> {
  const info = session.modelInfo();
  const materials = await Promise.all(
    Array.from({ length: info.materialCount }, (_, index) => materialInfo(session, model, index)),
  );
  if (model.turned.size > 0) (await import("./as-stored.ts")).layAsStored(glb, model.name);
  return {
    name: model.name,
    triangles: info.triangleCount,
    vertices: info.vertexCount,
    boundsMin: vec3(info.boundsMinModel),
    boundsMax: vec3(info.boundsMaxModel),
    materials,
    glb,
  };
}

/** "" where the file gives it none. */
export function materialName({ packed, name }: LoadedModel, index: number): string {
  return textAt(listOf(packed.json, "materials", name)[index], "name") ?? "";
}

async function materialInfo(session: Session, model: LoadedModel, index: number): Promise<MaterialInfo> {
  const info = session.materialInfo(index);
  const { core } = session;
  const paintable = core.isOk(info.paintStatus);
  const code = core.statusCode(info.paintStatus);
  return {
    index,
    name: materialName(model, index),
    refusal: paintable ? null : { code, message: core.statusMessage(info.paintStatus) },
    triangles: info.triangleCount,
    degenerateUvTriangles: info.degenerateUvTriangles,
    outOfRangeUvTriangles: info.outOfRangeUvTriangles,
    texCoord: info.texCoord,
    textureSize: await baseTextureSize(model, index),
    uvMin: [info.uvMin[0] ?? 0, info.uvMin[1] ?? 0],
    uvMax: [info.uvMax[0] ?? 0, info.uvMax[1] ?? 0],
    boundsMin: vec3(info.boundsMinModel),
    boundsMax: vec3(info.boundsMaxModel),
  };
}
