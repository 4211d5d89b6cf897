/** Which materials a layer paints: `material` is one glTF material index, or a list of them. */

export type LayerMaterials = number | readonly number[];

/** The glTF material indices that a layer names, as a list. */
export const materialsOf = ({ material }: { readonly material: LayerMaterials }): readonly number[] =>
  typeof material === "number" ? [material] : material;

/** Whether a layer names that glTF material index. */
export const paintsMaterial = ({ material: own }: { readonly material: LayerMaterials }, material: number): boolean =>
  typeof own === "number" ? own === material : own.includes(material);

/** The shortest way to write a list down; the list must not be empty. */
export const layerMaterials = (materials: readonly number[]): LayerMaterials =>
  materials.length === 1 ? (materials[0] as number) : materials;
