/**
 * An AVIF file of a picture's own items alone. What is decoded and what is kept of an upload is such a file: it has nothing that was
 * not looked at, and a file that was written so is written the same again.
 */
import type { AvifFile, AvifItem } from "./avif-file.ts";
import type { Box } from "./isobmff.ts";
import { joinBytes } from "./join-bytes.ts";

/** What must not be passed over by who does not know it. */
const ESSENTIAL: readonly string[] = ["av1C", "clap", "irot", "imir", "a1op", "lsel"];

/** @param profile A box that the picture gets beside its properties; those that it has are not written. */
export function writeAvif({ items, references }: AvifFile, profile: Uint8Array | null = null): Uint8Array<ArrayBuffer> {
  const number = new Map(items.map(({ id }, index) => [id, u16(index + 1)]));
  const numbers = (ids: readonly number[]): Uint8Array[] => ids.map((id) => number.get(id) ?? u16(0));
  const links = references.map(({ type, from, to }) => box(type, ...numbers([from]), u16(to.length), ...numbers(to)));
  const { listed, associations } = listProperties(items, profile);
  const stored = [...new Set(items.map(({ data }) => data))];
  const metaAt = (first: number): Uint8Array => {
    const offsets = new Map<Uint8Array, number>();
    let at = first;
    for (const data of stored) {
      offsets.set(data, at);
      at += data.length;
    }
    const places = items.map(({ id, data }) =>
      joinBytes([...numbers([id]), u16(0), u16(1), u32(offsets.get(data) ?? 0), u32(data.length)]),
    );
    const entries = items.map(({ id, type }) =>
      fullBox("infe", [2, 0, 0, 0], ...numbers([id]), u16(0), ascii(`${type}\0`)),
    );
    return fullBox(
      "meta",
      PLAIN,
      fullBox("hdlr", PLAIN, u32(0), ascii("pict"), new Uint8Array(13)),
      fullBox("pitm", PLAIN, u16(1)),
      fullBox("iloc", PLAIN, u16(0x4400), u16(items.length), ...places),
      fullBox("iinf", PLAIN, u16(items.length), ...entries),
      ...(links.length > 0 ? [fullBox("iref", PLAIN, ...links)] : []),
      box("iprp", box("ipco", ...listed), fullBox("ipma", [0, 0, 0, 1], u32(items.length), ...associations)),
    );
  };
  const ftyp = box("ftyp", ascii("avif\0\0\0\0avifmif1miaf"));
  const start = ftyp.length + metaAt(0).length + 8;
  return joinBytes([ftyp, metaAt(start), box("mdat", ...stored)]);
}

function listProperties(
  items: readonly AvifItem[],
  profile: Uint8Array | null,
): { listed: Uint8Array[]; associations: Uint8Array[] } {
  const listed: Uint8Array[] = [];
  const known = new Map<string, number>();
  const associations = items.map((item, index) => {
    const kept = complete(item, items);
    const given = index === 0 && profile !== null ? [...kept, { type: "colr", whole: profile }] : kept;
    const own = given.map(({ type, whole }) => {
      const key = Array.from(whole).join();
      const place = known.get(key) ?? listed.push(whole);
      known.set(key, place);
      return u16(ESSENTIAL.includes(type) ? 0x8000 | place : place);
    });
    return joinBytes([u16(index + 1), Uint8Array.of(own.length), ...own]);
  });
  return { listed, associations };
}

/** Without a colour profile, and with the depth of its channels, which older programs do not say and the decoder asks for. */
function complete({ properties }: AvifItem, items: readonly AvifItem[]): Box[] {
  const kept = properties.filter(({ type, content }) => type !== "colr" || isNumbers(content));
  const has = (name: string) => kept.some(({ type }) => type === name);
  // A grid has the depth of its tiles.
  const coded = [properties, ...items.map((item) => item.properties)].flat().find(({ type }) => type === "av1C");
  if (has("pixi") || coded === undefined) return kept;
  const flags = coded.content[2] ?? 0;
  const depth = flags & 0x40 ? (flags & 0x20 ? 12 : 10) : 8;
  const channels = flags & 0x10 || has("auxC") ? 1 : 3;
  const content = Uint8Array.of(channels, ...new Array<number>(channels).fill(depth));
  return [...kept, { type: "pixi", content, whole: fullBox("pixi", PLAIN, content) }];
}

/** Whether a `colr` says by numbers of ITU-T H.273 what it says. */
export const isNumbers = (colr: Uint8Array): boolean => String.fromCharCode(...colr.subarray(0, 4)) === "nclx";

const PLAIN = [0, 0, 0, 0];
const u16 = (value: number): Uint8Array => Uint8Array.of(value >> 8, value);
const u32 = (value: number): Uint8Array => Uint8Array.of(value >> 24, value >> 16, value >> 8, value);
const ascii = (text: string): Uint8Array => Uint8Array.from(text, (character) => character.charCodeAt(0));

function box(type: string, ...content: readonly Uint8Array[]): Uint8Array {
  const length = content.reduce((sum, each) => sum + each.length, 8);
  return joinBytes([u32(length), ascii(type), ...content]);
}

const fullBox = (type: string, head: readonly number[], ...content: readonly Uint8Array[]): Uint8Array =>
  box(type, Uint8Array.from(head), ...content);
