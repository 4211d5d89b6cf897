/** Words as an engine is given them, checked before anything is loaded for them. */
import {
  ABOVE_ZERO,
  between,
  checkFields,
  maybe,
  NUMBER,
  numbers,
  OBJECT,
  oneOf,
  type Rules,
  TEXT,
} from "./check-value.ts";

const RULES: Rules = {
  text: TEXT,
  font: TEXT,
  fontSize: ABOVE_ZERO,
  letterSpacing: NUMBER,
  align: oneOf("left", "center", "right"),
  curve: between(-360, 360),
  color: numbers(4),
  outline: maybe(OBJECT),
};

/** @throws TexelcastError "bad-argument" with the field, under `field`, and its value. */
export function checkText(text: unknown, field: string): void {
  checkFields(text, RULES, field);
  const { outline } = text as { readonly outline?: unknown };
  if (outline) checkFields(outline, { color: numbers(4), width: ABOVE_ZERO }, `${field}.outline`);
}
