/** The edits of the layers' tree: each takes a design and gives a new one that shares all that did not change. */
import { type Design, type DesignLayer, type GroupLayer, MASK_DEFAULTS } from "../document/design.ts";
import {
  findLayer,
  freeIdIn,
  freeIdsIn,
  insertAboveEach,
  insertAt,
  type LayerVisit,
  layersAt,
  mapLayer,
  removeByIds,
  visitOf,
  walkLayers,
  withIds,
} from "../document/layer-tree.ts";
import { makeFillLayer, makeGroupLayer } from "../document/make-layer.ts";
import { freeName, freeNames, withoutUnusedAssets } from "./design-edits.ts";

/** A place among the layers of the design, or of a group; `index` counts from the bottom. */
export interface TreePlace {
  readonly parentId: string | null;
  readonly index: number;
}

/** Of the named layers those in no other of them, bottom to top: what lies in a chosen group goes where the group goes. */
export function outermost(design: Pick<Design, "layers">, ids: readonly string[]): LayerVisit[] {
  const chosen = new Set(ids);
  const within = new Set<string>();
  const visits: LayerVisit[] = [];
  for (const visit of walkLayers(design, { masks: false, strokes: false })) {
    const { layer, parentId } = visit;
    const covered = parentId !== null && within.has(parentId);
    if (covered || chosen.has(layer.id)) within.add(layer.id);
    if (!covered && chosen.has(layer.id)) visits.push(visit);
  }
  return visits;
}

/** Takes layers out, and the pictures that nothing uses any more. */
export function removeLayers(design: Design, ids: readonly string[]): Design {
  const without = removeByIds(design, idsOf(outermost(design, ids)));
  return without === design ? design : withoutUnusedAssets(without);
}

/**
 * Puts layers beside each other at a place, in the order in which they lie. `place.index` counts those that are moved, too,
 * where they lie in the same list. A place inside one of them changes nothing.
 *
 * @throws TexelcastError "bad-argument" where layers would lie deeper than a design may have them.
 */
export function moveLayers(design: Design, ids: readonly string[], place: TreePlace): Design {
  const moved = outermost(design, ids);
  if (moved.length === 0 || moved.some(({ layer }) => holds(layer, place.parentId))) return design;
  const below = moved.filter(({ parentId, index }) => parentId === place.parentId && index < place.index).length;
  const start = place.index - below;
  const stays = moved.every(({ parentId, index }, offset) => parentId === place.parentId && index === start + offset);
  if (stays) return design;
  const without = removeByIds(design, idsOf(moved));
  return insertAt(without, { ...place, list: "layers", index: start }, ...moved.map(({ layer }) => layer));
}

/**
 * One step up (1) or down (-1) the list as it is seen: past a neighbour, into one that is an open group, or out of a group
 * at whose end the layers lie.
 */
export function stepLayers(
  design: Design,
  ids: readonly string[],
  direction: 1 | -1,
  collapsed: ReadonlySet<string>,
): Design {
  const moved = outermost(design, ids);
  const chosen = new Set(moved.map(({ layer }) => layer.id));
  const end = direction > 0 ? moved.at(-1) : moved[0];
  if (!end) return design;
  const { parentId } = end;
  const siblings = layersAt(design, { parentId, list: "layers" }) ?? [];
  let next = end.index + direction;
  while (chosen.has(siblings[next]?.id ?? "")) next += direction;
  const neighbour = siblings[next];
  if (neighbour?.type === "group" && !collapsed.has(neighbour.id)) {
    return moveLayers(design, ids, { parentId: neighbour.id, index: direction > 0 ? 0 : neighbour.layers.length });
  }
  const above = direction > 0 ? 1 : 0;
  if (neighbour) return moveLayers(design, ids, { parentId, index: next + above });
  const parent = visitOf(design, parentId);
  return parent ? moveLayers(design, ids, { parentId: parent.parentId, index: parent.index + above }) : design;
}

/**
 * Puts layers into a new group, where the topmost of them was.
 *
 * @throws TexelcastError "bad-argument" where layers would lie deeper than a design may have them.
 */
export function groupLayers(
  design: Design,
  ids: readonly string[],
  fields: Partial<Omit<GroupLayer, "type" | "id" | "layers">> & Pick<GroupLayer, "name">,
): { design: Design; id: string } | undefined {
  const members = outermost(design, ids);
  const top = members.at(-1);
  if (!top) return undefined;
  const id = freeIdIn(design);
  const group = makeGroupLayer({
    id,
    layers: members.map(({ layer }) => layer),
    ...fields,
    name: freeName(design, fields.name),
  });
  const { parentId } = top;
  const index = top.index + 1 - members.filter((member) => member.parentId === parentId).length;
  const without = removeByIds(design, idsOf(members));
  return { design: insertAt(without, { parentId, list: "layers", index }, group), id };
}

/** Puts copies right above their originals. `patchOf` sets a copy apart (its place). Ids are those of the copies. Throws as `insertAt`. */
export function duplicateLayers(
  design: Design,
  ids: readonly string[],
  patchOf: (layer: DesignLayer) => Partial<DesignLayer> = () => ({}),
): { design: Design; ids: string[] } {
  const nextId = freeIdsIn(design);
  const nextName = freeNames(design);
  const copies = new Map<string, DesignLayer>();
  for (const { layer } of outermost(design, ids)) {
    copies.set(layer.id, withIds({ ...layer, ...patchOf(layer), name: nextName(layer.name) } as DesignLayer, nextId));
  }
  return { design: insertAboveEach(design, copies), ids: [...copies.values()].map(({ id }) => id) };
}

/** A copy right below a layer takes its name and its place; the layer itself has the copy's name. Throws as `insertAt`. */
export function copyBelow(design: Design, id: string): Design {
  const visit = visitOf(design, id);
  if (!visit) return design;
  const { layer, parentId, list, index } = visit;
  const name = freeName(design, layer.name);
  const made = insertAt(design, { parentId, list, index }, withIds(layer, freeIdsIn(design)));
  return mapLayer(made, id, (each) => ({ ...each, name }) as DesignLayer);
}

/** A mask that shows all of the layer, or hides all of it until it is painted on. One that has a mask keeps it. Throws as `insertAt`. */
export function addMask(design: Design, id: string, hideAll: boolean): Design {
  const { material, mask = null } = findLayer(design, id) ?? {};
  if (material === undefined || mask !== null) return design;
  if (!hideAll) return mapLayer(design, id, (layer) => ({ ...layer, mask: { layers: [], ...MASK_DEFAULTS } }));
  const cover = makeFillLayer({ id: freeIdIn(design), color: "#000000", blend: "erase", material });
  return insertAt(design, { parentId: id, list: "mask", index: 0 }, cover);
}

export function removeMask(design: Design, id: string): Design {
  const without = mapLayer(design, id, (layer) => (layer.mask === null ? layer : { ...layer, mask: null }));
  return without === design ? design : withoutUnusedAssets(without);
}

export function invertMask(design: Design, id: string): Design {
  return mapLayer(design, id, (layer) =>
    layer.mask === null ? layer : { ...layer, mask: { ...layer.mask, invert: !layer.mask.invert } },
  );
}

/** Lets a layer's mask go along with it, or stay where it is when the layer is moved. */
export function linkMask(design: Design, id: string, linked: boolean): Design {
  return mapLayer(design, id, (layer) => (layer.mask === null ? layer : { ...layer, mask: { ...layer.mask, linked } }));
}

/**
 * Puts a layer that is new to the design right above another one, or on top of what that one holds where it is a group;
 * without one, on top of all.
 *
 * @throws TexelcastError "bad-argument" where layers would lie deeper than a design may have them.
 */
export function insertAbove(
  design: Design,
  id: string | null,
  make: (id: string) => DesignLayer,
): { design: Design; id: string } {
  const made = make(freeIdIn(design));
  const layer = { ...made, name: freeName(design, made.name) };
  const visit = visitOf(design, id);
  const place =
    visit?.layer.type === "group"
      ? { parentId: visit.layer.id, index: visit.layer.layers.length }
      : { parentId: visit?.parentId ?? null, index: visit ? visit.index + 1 : design.layers.length };
  return { design: insertAt(design, { ...place, list: "layers" }, layer), id: layer.id };
}

const idsOf = (visits: readonly LayerVisit[]): Set<string> => new Set(visits.map(({ layer }) => layer.id));

function holds(layer: DesignLayer, id: string | null): boolean {
  return id !== null && findLayer({ layers: [layer] }, id) !== undefined;
}
