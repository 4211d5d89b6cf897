/** Groups taken apart, looking as they did wherever that can be. */
import { type Design, type DesignLayer, type GroupLayer, insertAt, removeById, visitOf } from "../document/index.ts";
import { outermost } from "./layer-edits.ts";

export interface Ungrouped {
  readonly design: Design;
  /** Of the layers that were in the groups. */
  readonly ids: readonly string[];
  /** Which fields of the groups cannot be handed to their layers, so that the picture changes. */
  readonly lost: ReadonlySet<GroupField>;
}

export type GroupField = "opacity" | "blend" | "mask" | "isolated" | "lockAlpha";

/** Puts the layers of groups in their groups' places. Those of a hidden group stay hidden; an only one takes on what its group had. */
export function ungroupLayers(design: Design, ids: readonly string[]): Ungrouped {
  const freed: string[] = [];
  const lost = new Set<GroupField>();
  let left = design;
  for (const { layer: group } of outermost(design, ids)) {
    const visit = visitOf(left, group.id);
    if (!visit || group.type !== "group") continue;
    const { parentId, index } = visit;
    const alone = aloneInPlaceOf(group);
    if (alone === null) for (const field of ownFields(group)) lost.add(field);
    const layers = alone === null ? group.layers : [alone];
    const members = layers.map((layer) => (group.visible ? layer : { ...layer, visible: false }));
    left = insertAt(removeById(left, group.id), { parentId, list: "layers", index }, ...members);
    freed.push(...members.map(({ id }) => id));
  }
  return { design: left, ids: freed, lost };
}

/** What a group does beyond holding its layers together. What it holds nothing in, nobody sees. */
function ownFields(group: GroupLayer): GroupField[] {
  if (group.layers.length === 0) return [];
  const own: GroupField[] = [];
  if (group.opacity !== 1) own.push("opacity");
  if (group.blend !== "normal") own.push("blend");
  else if (group.isolated && !group.layers.every(isPlain)) own.push("isolated");
  if (group.mask !== null) own.push("mask");
  if (group.lockAlpha) own.push("lockAlpha");
  return own;
}

/** Laid on others one by one it comes out as it does when it and they are laid on each other first. */
function isPlain(layer: DesignLayer): boolean {
  const { blend, blendSpace, lockAlpha } = layer;
  if (blend !== "normal" || blendSpace !== "srgb" || lockAlpha) return false;
  return layer.type !== "group" || layer.isolated || layer.layers.every(isPlain);
}

/**
 * The only layer of a group as it looks the same without the group; null where the group holds several, or where it cannot be
 * done. Opacities multiply, since every blend mode goes in step with alpha; what is laid on nothing, in an isolated group,
 * is itself whatever its mode.
 */
function aloneInPlaceOf(group: GroupLayer): DesignLayer | null {
  const [layer, another] = group.layers;
  if (layer === undefined || another !== undefined) return null;
  if (layer.mask !== null && group.mask !== null) return null;
  const shared = { opacity: layer.opacity * group.opacity, mask: layer.mask ?? group.mask };
  const isIsolated = group.isolated || group.blend !== "normal";
  if (!isIsolated) return group.lockAlpha ? null : { ...layer, ...shared };
  // These two show by what is below, of which there is nothing.
  if (layer.blend === "erase" || layer.lockAlpha) return null;
  const { blend, blendSpace, lockAlpha } = group;
  const laid = { ...layer, ...shared, blend, blendSpace, lockAlpha };
  return laid.type === "group" ? { ...laid, isolated: true } : laid;
}
