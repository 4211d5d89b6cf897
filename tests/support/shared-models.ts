/** The models of ../shared, a folder that a checkout may or may not have beside it. Tests on them say what they skip. */
import { existsSync, readFileSync } from "node:fs";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import type { ModelSource } from "../../web/engine/engine-api.ts";
import { listSideFiles } from "../../web/engine/gltf-container.ts";

const folder = new URL("../../../shared/models/", import.meta.url);

export const haveSharedModels: boolean = existsSync(folder);

/** Says on the console which claims were not checked. */
export function noteSkipped(claims: string): void {
  if (!haveSharedModels) console.info(`skipped, because ../shared/models is not there: ${claims}`);
}

/** A model of the folder with its side files. */
export function sharedModel(path: string): ModelSource {
  const file = new URL(path, folder);
  const bytes = new Uint8Array(readFileSync(file));
  const resources = new Map<string, Uint8Array>();
  for (const uri of listSideFiles({ name: path, bytes })) {
    resources.set(uri, new Uint8Array(readFileSync(`${dirname(fileURLToPath(file))}/${decodeURIComponent(uri)}`)));
  }
  return { name: path, bytes, resources };
}

export const SHARED_MODELS = [
  "Avocado/Avocado.gltf",
  "AvocadoDraco/Avocado.gltf",
  "AvocadoQuantized/Avocado.gltf",
  "BoxTextured.glb",
  "CesiumMan.glb",
  "Cube/Cube.gltf",
  "Fox.glb",
  "Knight.glb",
  "MaterialsVariantsShoe/MaterialsVariantsShoe.gltf",
  "MorphPrimitivesTest.glb",
  "MultiUVTest.glb",
  "NegativeScaleTest.glb",
  "RiggedFigure.glb",
  "Suzanne/Suzanne.gltf",
] as const;
