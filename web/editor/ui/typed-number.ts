/** Metres of the units that a length may be typed in. */
const METRES: Readonly<Record<string, number>> = { mm: 0.001, cm: 0.01, m: 1, in: 0.0254 };

/**
 * A number as it is typed, with or without the unit that its field shows; a length may have another, and is converted.
 * Undefined: none.
 *
 * @param point what the field itself writes before decimals, which is how "1,000" is read where it could be both
 */
export function typedNumber(text: string, unit: string, point: "." | "," = "."): number | undefined {
  const [, digits = "", ending] = /^([-+−]?[\d.,]+(?:e[-+]?\d+)?)\s*([^\d.,]*)$/.exec(text.trim().toLowerCase()) ?? [];
  const own = unit.toLowerCase();
  const factor = !ending || ending === own ? 1 : (METRES[ending] as number) / (METRES[own] as number);
  const value = Number(plain(digits.replace("−", "-"), point)) * factor;
  return digits !== "" && Number.isFinite(value) ? value : undefined;
}

/**
 * The digits without marks between thousands, and with a point before decimals. Both signs are taken for decimals in both
 * languages, for a keyboard's number block has but one of them; so thousands are what can only be thousands, or are such in the
 * way that the field writes numbers itself: three digits behind one sign, with one to three before it, of which the first is no 0.
 */
function plain(digits: string, point: "." | ","): string {
  const other = point === "." ? "," : ".";
  const whole = "^[-+]?[1-9]\\d{0,2}";
  const inOwnWay = new RegExp(`${whole}(\\${other}\\d{3})+(\\${point}\\d*)?(e|$)`);
  const inOtherWay = new RegExp(`${whole}((\\${point}\\d{3})+\\${other}\\d*|(\\${point}\\d{3}){2,})(e|$)`);
  const between = inOwnWay.test(digits) ? other : inOtherWay.test(digits) ? point : "";
  return (between ? digits.replaceAll(between, "") : digits).replace(",", ".");
}
