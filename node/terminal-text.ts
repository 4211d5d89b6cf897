/** Text for people: names and numbers as a terminal may show them. */

/** Files name materials and fields as they like; their control characters must not reach the terminal. */
export function printable(text: string): string {
  // biome-ignore lint/suspicious/noControlCharactersInRegex: control characters are what is looked for
  return text.replace(/[\u0000-\u001f\u007f-\u009f\u202a-\u202e\u2066-\u2069]/g, (character) => {
    return `\\u${character.charCodeAt(0).toString(16).padStart(4, "0")}`;
  });
}

/** 1234567 as "1,234,567". */
export const formatCount = (count: number): string => count.toLocaleString("en-GB");

/** 0.5579 as "55.8 %". A share that is not 0 is never shown as 0. */
export function formatShare(share: number): string {
  return share > 0 && share < 0.0005 ? "< 0.1 %" : `${(share * 100).toFixed(1)} %`;
}

/** A box as its two corners, to about a thousandth of its own size: what is finer is an exporter's rounding. */
export function formatBounds(min: readonly number[], max: readonly number[]): string {
  const diagonal = Math.hypot(...max.map((high, axis) => high - (min[axis] ?? 0)));
  const decimals = diagonal > 0 ? Math.min(12, Math.max(0, 3 - Math.floor(Math.log10(diagonal)))) : 3;
  const format = (point: readonly number[]): string =>
    `(${point.map((part) => String(Number(part.toFixed(decimals)))).join(", ")})`;
  return `${format(min)} to ${format(max)} m`;
}

/** “1 layer”, “2 layers”: for nouns that take an s. */
export const plural = (count: number, noun: string): string => `${formatCount(count)} ${noun}${count === 1 ? "" : "s"}`;

/** Columns two spaces apart; those of numbers flush right. The first row is the heading. */
export function formatTable(rows: readonly (readonly string[])[], rightAligned: readonly boolean[]): string {
  const widths = (rows[0] ?? []).map((_, column) => Math.max(...rows.map((row) => (row[column] ?? "").length)));
  const format = (cell: string, column: number): string => {
    const width = widths[column] ?? 0;
    return rightAligned[column] ? cell.padStart(width) : cell.padEnd(width);
  };
  return rows.map((row) => row.map(format).join("  ").trimEnd()).join("\n");
}
