/** How large the elements of accessors are (glTF 2.0, 3.6.2.2). */

/** Without what objects have of themselves: a file may write "constructor" for a type. */
const only = <Table extends object>(table: Table): Table => Object.assign(Object.create(null), table);

export const COMPONENT_BYTES: Readonly<Record<number, number>> = only({
  5120: 1,
  5121: 1,
  5122: 2,
  5123: 2,
  5125: 4,
  5126: 4,
});
/** Columns and rows; a matrix's columns begin at multiples of four bytes. */
export const SHAPES: Readonly<Record<string, readonly [number, number]>> = only({
  SCALAR: [1, 1],
  VEC2: [1, 2],
  VEC3: [1, 3],
  VEC4: [1, 4],
  MAT2: [2, 2],
  MAT3: [3, 3],
  MAT4: [4, 4],
});
