/**
 * The engine's messages are written to stand after a colon as well: here they begin and end a sentence. A file's name that
 * one begins with, `subject`, stays as it is written.
 */
export function sentence(text: string, subject = ""): string {
  const begins = /^[a-z]+[\s,]/.test(text) && !(subject && text.startsWith(subject));
  const start = begins ? text.charAt(0).toUpperCase() + text.slice(1) : text;
  return /[.!?…]$/.test(start) ? start : `${start}.`;
}
