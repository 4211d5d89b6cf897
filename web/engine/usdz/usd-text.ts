/** Numbers and blocks as OpenUSD's text format has them (openusd.org, "USDA"): the same characters on every machine. */

/** As many digits as a 32-bit float holds. */
export function numberText(value: number): string {
  if (!Number.isFinite(value)) return "0";
  // ECMAScript lays down each digit of both; + takes the zeros behind off, and the sign of zero.
  return String(+value.toPrecision(7) + 0);
}

/** "(1, 2, 3)" */
export const tupleText = (values: readonly number[]): string => `(${values.map(numberText).join(", ")})`;

/** "[(1, 2), (3, 4)]" of numbers in a row, `size` a tuple. */
export function tuplesText(values: ArrayLike<number>, size: number): string {
  const tuples: string[] = new Array(values.length / size);
  for (let i = 0; i < tuples.length; i++) {
    let tuple = `(${numberText(values[i * size] as number)}`;
    for (let c = 1; c < size; c++) tuple += `, ${numberText(values[i * size + c] as number)}`;
    tuples[i] = `${tuple})`;
  }
  return `[${tuples.join(", ")}]`;
}

/** A block of lines in braces behind `head`, each further in. */
export const block = (head: string, lines: readonly string[]): string[] => [
  head,
  "{",
  ...lines.map((line) => `    ${line}`),
  "}",
];
