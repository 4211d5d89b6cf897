/**
 * The keys [ and ], -1 and 1, on any layout; null for other keys. By their characters where a layout has them on another level, as a
 * German one. By place on the keyboard else, since with Shift these keys' characters differ between layouts; but not where that
 * place has a character that means something itself.
 */
export function bracketOf({ key, code }: Pick<KeyboardEvent, "key" | "code">): -1 | 1 | null {
  if (key === "[" || key === "]") return key === "[" ? -1 : 1;
  if (key === "+" || key === "-" || key === "=") return null;
  return code === "BracketLeft" ? -1 : code === "BracketRight" ? 1 : null;
}
