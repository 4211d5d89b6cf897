/** JSON for people and for version control: as JSON.stringify with an indent of two, but lists of numbers on one line. */

/** The value, which must be plain data, as JSON text with a line feed at the end. A function in it gives the text of its place. */
export const printJson = (value: unknown): string => `${print(value, "")}\n`;

/** A value as it stands inside another, whose indent is given. */
export function print(value: unknown, indent: string): string {
  if (typeof value === "function") return value(indent);
  if (typeof value !== "object" || value === null) return JSON.stringify(value);
  const isList = Array.isArray(value);
  if (isList && value.every((item) => typeof item === "number")) return `[${value.map(String).join(", ")}]`;
  const inner = `${indent}  `;
  const lines = isList
    ? value.map((item) => inner + print(item, inner))
    : Object.entries(value).map(([key, item]) => `${inner}${JSON.stringify(key)}: ${print(item, inner)}`);
  const [open, close] = isList ? ["[", "]"] : ["{", "}"];
  return lines.length === 0 ? open + close : `${open}\n${lines.join(",\n")}\n${indent}${close}`;
}
