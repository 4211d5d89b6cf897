/** A number as it is typed: in either language's way, with or without the unit that its field shows. Undefined: none. */
export function typedNumber(text: string, unit: string): number | undefined {
  const typed = text.trim().toLowerCase();
  const ending = unit.toLowerCase();
  const bare = ending && typed.endsWith(ending) ? typed.slice(0, -ending.length).trimEnd() : typed;
  const value = Number(bare.replace(",", ".").replace("−", "-"));
  return bare !== "" && Number.isFinite(value) ? value : undefined;
}
