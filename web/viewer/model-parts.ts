/** A model's parts as the user knows them: one for each mesh, named by its node, and by its material where one node has several. */
import { type ModelScene, shapedMeshes } from "./model-scene.ts";
import type { GuideEntry, ModelPart } from "./viewer-api.ts";

/** Part numbers are places in `shapedMeshes`. */
export function partsOf(scene: ModelScene): ModelPart[] {
  return shapedMeshes(scene).map((mesh, id): ModelPart => {
    const label = scene.labels.get(mesh);
    const data = dataIn(label?.extras);
    const group = data?.group;
    const several = label?.several === true;
    return {
      id,
      name: (several ? label?.material || label?.node : label?.node) || mesh.name,
      group: typeof group === "string" ? group : several ? label?.node || null : null,
      material: materialOf(scene, mesh.material),
      triangles: Math.floor((mesh.geometry.index?.count ?? mesh.geometry.getAttribute("position").count) / 3),
      hidden: data?.hidden === true,
    };
  });
}

/** The named places of a material's texture that the model's file gives (`extras.texelcast.guide`); none without. */
export function guideOf(scene: ModelScene, material: number): GuideEntry[] {
  const guide = dataIn(scene.materials.get(material)?.[0]?.userData)?.guide;
  return Array.isArray(guide) ? guide.filter(isGuideEntry) : [];
}

function isGuideEntry(value: unknown): value is GuideEntry {
  const { part, face, uv } = (value ?? {}) as Partial<Record<keyof GuideEntry, unknown>>;
  return (
    typeof part === "string" &&
    (face === undefined || typeof face === "string") &&
    Array.isArray(uv) &&
    uv.length === 4 &&
    uv.every((number) => Number.isFinite(number))
  );
}

function materialOf(scene: ModelScene, material: unknown): number {
  for (const [index, materials] of scene.materials) {
    if (materials.some((candidate) => candidate === material)) {
      return index;
    }
  }
  return 0;
}

/** Our own corner of glTF's extras, which may hold anything. */
function dataIn(extras: unknown): Record<string, unknown> | undefined {
  const data = (extras as { texelcast?: unknown } | undefined | null)?.texelcast;
  return typeof data === "object" && data !== null ? (data as Record<string, unknown>) : undefined;
}
