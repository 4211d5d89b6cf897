/** Metres of the units that a length may be typed in. */
const METRES: Readonly<Record<string, number>> = { mm: 0.001, cm: 0.01, m: 1, in: 0.0254 };

/**
 * A number as it is typed: in either language's way, with or without the unit that its field shows; a length may have another,
 * and is converted. Undefined: none.
 */
export function typedNumber(text: string, unit: string): number | undefined {
  const [, digits = "", ending] = /^([-+−]?[\d.,]+(?:e[-+]?\d+)?)\s*([^\d.,]*)$/.exec(text.trim().toLowerCase()) ?? [];
  const own = unit.toLowerCase();
  const factor = !ending || ending === own ? 1 : (METRES[ending] as number) / (METRES[own] as number);
  const value = Number(digits.replace(",", ".").replace("−", "-")) * factor;
  return digits !== "" && Number.isFinite(value) ? value : undefined;
}
