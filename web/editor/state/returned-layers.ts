import { type Design, flattenLayers, walkLayers } from "../document/index.ts";

/** Ids of what a step through the history has brought, the topmost first; of what came in a group, the group's. */
export function returnedLayers(before: Design, after: Design): string[] {
  const had = new Set(flattenLayers(before).map(({ id }) => id));
  return [...walkLayers(after, { masks: false, strokes: false })]
    .filter(({ layer, parentId }) => !had.has(layer.id) && (parentId === null || had.has(parentId)))
    .map(({ layer }) => layer.id)
    .reverse();
}
