/** A drawing that was copied as its text: out of a drawing program by its "Copy as SVG", or out of a web page. */
import { isSvg } from "../../engine/svg-start.ts";

const NAMESPACES = [
  { used: /<svg[\s>/]/i, named: /\sxmlns\s*=/, attribute: 'xmlns="http://www.w3.org/2000/svg"' },
  { used: /\sxlink:/, named: /\sxmlns:xlink\s*=/, attribute: 'xmlns:xlink="http://www.w3.org/1999/xlink"' },
] as const;

/** The SVG file that the words are, without blanks around it and with the namespaces that web pages do without; null for other words. */
export function pastedDrawing(words: string): string | null {
  if (!isSvg(new TextEncoder().encode(words))) return null;
  const lacking = NAMESPACES.filter(({ used, named }) => used.test(words) && !named.test(words));
  const attributes = lacking.map(({ attribute }) => ` ${attribute}`).join("");
  // Before an XML declaration there may be nothing.
  return words.trim().replace(/<svg(?=[\s>/])/i, (tag) => tag + attributes);
}
