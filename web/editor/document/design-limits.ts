/** Bounds that no honest design meets; they keep a hostile file from costing more than its reading. */
export const DESIGN_LIMITS = {
  /** Of the whole tree: groups, what is in them, in masks and in paint layers. */
  layers: 10_000,
  /** Of a layer within a layer within a layer: 1 stands on the design's own list. */
  depth: 16,
  assets: 10_000,
  dabs: 100_000,
  materials: 65_536,
  gradientStops: 16,
  /** Charts or faces of a fill's parts. */
  parts: 1_000_000,
  /** Characters are code points. */
  idLength: 200,
  nameLength: 1000,
  textLength: 10_000,
  /** Metres. Lengths outside would not survive the engine's 32-bit arithmetic. */
  lengthMin: 1e-9,
  lengthMax: 1e9,
} as const;

/** Names that JavaScript gives a meaning of its own as an object's keys; no asset, zone or layer takes one. */
export const RESERVED_KEYS: string[] = ["__proto__", "prototype", "constructor"];
