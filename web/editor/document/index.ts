/** The design document's public face: types, reading, writing, and the way to the engine. */
export * from "./design.ts";
export { isHexColor, parseHexColor, type Rgba } from "./hex-color.ts";
export * from "./layer-tree.ts";
export * from "./make-layer.ts";
export { liesOnTexture, mirroredProjector, sameMirror } from "./mirror-layer.ts";
export { parseDesign } from "./parse-design.ts";
export {
  PROJECT_EXTENSION,
  type ProjectFile,
  type ProjectTarget,
  type ProjectToWrite,
  readProjectFile,
  writeProjectFile,
} from "./project-file.ts";
export { resolveLayers } from "./resolve-layers.ts";
export { serialiseDesign } from "./serialise-design.ts";
export {
  type PathPoint,
  type PathTail,
  placeDabs,
  type StrokePathOptions,
  type StrokePiece,
} from "./stroke-path.ts";
export { parseZones, ZONES_VERSION } from "./zones.ts";
