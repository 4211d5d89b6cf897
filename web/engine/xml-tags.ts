/** The tags of an XML text, one after another: as much of XML as tells what a drawing is made of. */

export interface XmlTag {
  /** Without a prefix. */
  readonly name: string;
  readonly kind: "start" | "end" | "empty";
  /** By their names without prefixes; references in them as they are written. */
  readonly attributes: ReadonlyMap<string, string>;
  /** What stands between the tag before and this one. */
  readonly text: string;
  /** Comments and the like among that. */
  readonly others: number;
  /** Where it begins in the text. */
  readonly start: number;
  /** Characters of the tag itself. */
  readonly length: number;
}

/** Comments and the like are left out. In linear time whatever the text is; of one that is not well-formed, some tags. */
export function* tagsOf(xml: string): Iterable<XmlTag> {
  let text = "";
  let others = 0;
  let at = 0;
  for (;;) {
    const start = xml.indexOf("<", at);
    if (start < 0) return;
    text += xml.slice(at, start);
    const skipped = endOfOther(xml, start);
    if (skipped !== null) {
      if (xml.startsWith("<![CDATA[", start)) text += xml.slice(start + 9, skipped - 3);
      others += 1;
      at = skipped;
      continue;
    }
    const end = unquoted(xml, start, ">");
    if (end < 0) return;
    const isEnd = xml[start + 1] === "/";
    const isEmpty = xml[end - 1] === "/";
    const inside = xml.slice(start + (isEnd ? 2 : 1), isEmpty ? end - 1 : end);
    const space = inside.search(/\s/);
    const name = space < 0 ? inside : inside.slice(0, space);
    const attributes = space < 0 ? NONE : attributesOf(inside.slice(space));
    const kind = isEnd ? "end" : isEmpty ? "empty" : "start";
    yield { name: withoutPrefix(name), kind, attributes, text, others, start, length: end + 1 - start };
    text = "";
    others = 0;
    at = end + 1;
  }
}

const NONE: ReadonlyMap<string, string> = new Map();

/** Of a comment, CDATA, an instruction or the document's type; null for a tag. The text's length where it has no end. */
export function endOfOther(xml: string, start: number): number | null {
  const after = (end: string): number => {
    const found = xml.indexOf(end, start);
    return found < 0 ? xml.length : found + end.length;
  };
  if (xml.startsWith("<!--", start)) return after("-->");
  if (xml.startsWith("<![CDATA[", start)) return after("]]>");
  if (xml.startsWith("<?", start)) return after("?>");
  if (!xml.startsWith("<!", start)) return null;
  const end = unquoted(xml, start, "[>");
  if (end < 0) return xml.length;
  if (xml[end] === ">") return end + 1;
  // What the document's type declares ends with the first of these, or later: then a few declarations look like tags.
  const close = /\]\s*>/g;
  close.lastIndex = end;
  return close.test(xml) ? close.lastIndex : xml.length;
}

/** Where one of these characters is first, outside of quotes; -1 where none is. */
export function unquoted(xml: string, start: number, characters: string): number {
  let quote = "";
  for (let at = start; at < xml.length; at++) {
    const character = xml[at] as string;
    if (quote !== "") {
      if (character === quote) quote = "";
    } else if (character === '"' || character === "'") quote = character;
    else if (characters.includes(character)) return at;
  }
  return -1;
}

function attributesOf(list: string): Map<string, string> {
  const attributes = new Map<string, string>();
  let at = 0;
  for (;;) {
    const equals = list.indexOf("=", at);
    if (equals < 0) return attributes;
    const name = list.slice(at, equals).trim();
    let open = equals + 1;
    while (open < list.length && list[open] !== '"' && list[open] !== "'") open++;
    const close = list.indexOf(list[open] ?? "\0", open + 1);
    if (close < 0) return attributes;
    attributes.set(withoutPrefix(name), list.slice(open + 1, close));
    at = close + 1;
  }
}

const withoutPrefix = (name: string): string => name.slice(name.indexOf(":") + 1);
