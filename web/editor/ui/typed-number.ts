/** Metres of the units that a length may be typed in. */
const METRES: Readonly<Record<string, number>> = { mm: 0.001, cm: 0.01, m: 1, in: 0.0254 };

/** Characters: no sum that somebody types is longer. */
const MOST = 200;

/**
 * A number as it is typed, with or without the unit that its field shows, or a sum: "10/2", "3 cm + 5 mm", "(1,5 + 2) × 3". A
 * length may have another unit than its field's, and is converted. Undefined: none.
 *
 * @param point what the field itself writes before decimals, which is how "1,000" is read where it could be both
 */
export function typedNumber(text: string, unit: string, point: "." | "," = "."): number | undefined {
  if (text.length > MOST) return undefined;
  const value = new TypedSum(text.trim().toLowerCase(), unit.toLowerCase(), point).value();
  return value !== null && Number.isFinite(value) ? value : undefined;
}

/** A value, and how many of the field's units one of its units is; null: it has none, and is of whatever it is beside. */
interface Term {
  readonly value: number;
  readonly factor: number | null;
}

/** Reads from left to right; products go before sums. */
class TypedSum {
  readonly #text: string;
  readonly #unit: string;
  readonly #point: "." | ",";
  #at = 0;

  constructor(text: string, unit: string, point: "." | ",") {
    this.#text = text;
    this.#unit = unit;
    this.#point = point;
  }

  /** Null where it is no sum of numbers, or is followed by something else. */
  value(): number | null {
    const sum = this.#sum();
    return sum && this.#at === this.#text.length ? sum.value * (sum.factor ?? 1) : null;
  }

  #sum(): Term | null {
    let sum = this.#product();
    for (let sign = this.#next(/[-+−]/y); sum && sign; sign = this.#next(/[-+−]/y)) {
      const term = this.#product();
      if (!term) return null;
      const value = term.value * (term.factor ?? 1) * (sign === "+" ? 1 : -1);
      sum = { value: sum.value * (sum.factor ?? 1) + value, factor: (sum.factor ?? term.factor) ? 1 : null };
    }
    return sum;
  }

  /** One of its numbers may have a unit, which the whole has then: "10/2 cm" is 5 cm. */
  #product(): Term | null {
    let product = this.#number();
    for (let sign = this.#next(/[*/×÷:]/y); product && sign; sign = this.#next(/[*/×÷:]/y)) {
      const by = this.#number();
      if (!by || (by.factor !== null && product.factor !== null)) return null;
      const value = sign === "*" || sign === "×" ? product.value * by.value : product.value / by.value;
      product = { value, factor: product.factor ?? by.factor };
    }
    return product;
  }

  #number(): Term | null {
    const sign = this.#next(/[-+−]/y);
    const term = this.#next(/\(/y) ? this.#bracketed() : this.#digits();
    return term && { ...term, value: sign && sign !== "+" ? -term.value : term.value };
  }

  #bracketed(): Term | null {
    const sum = this.#sum();
    return sum && this.#next(/\)/y) ? this.#withUnit(sum.value, sum.factor) : null;
  }

  #digits(): Term | null {
    const digits = this.#next(/[\d.,]+(?:e[-+]?\d+)?/y);
    const value = Number(plain(digits, this.#point));
    return digits === "" || Number.isNaN(value) ? null : this.#withUnit(value, null);
  }

  #withUnit(value: number, factor: number | null): Term | null {
    const ending = this.#next(/[^\d.,+\-−*/×÷:()\s]+/y);
    if (ending === "") return { value, factor };
    const own = ending === this.#unit ? 1 : (METRES[ending] as number) / (METRES[this.#unit] as number);
    return Number.isNaN(own) || factor !== null ? null : { value, factor: own };
  }

  /** What stands there of that form, and goes on behind it and the spaces after; "": nothing. */
  #next(form: RegExp): string {
    form.lastIndex = this.#at;
    const [found = ""] = form.exec(this.#text) ?? [];
    if (found === "") return "";
    this.#at += found.length;
    while (this.#text[this.#at]?.trim() === "") this.#at += 1;
    return found;
  }
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
