/** A TrueType font whose only letter, “A”, is made of parts that are made of parts: a few bytes with very many points. */

const EM = 1000;
/** Of a composite glyph's parts (OpenType, “glyf”): words as offsets, offsets and not points, more follow. */
const ARE_WORDS = 1;
const ARE_OFFSETS = 2;
const MORE_FOLLOW = 32;

/** @param parts of each glyph above the lowest, which is a triangle */
export function compositeFont(levels: number, parts: number): Uint8Array<ArrayBuffer> {
  const glyphs = [triangle(), ...Array.from({ length: levels }, (_, level) => composite(level, parts))];
  const offsets = [0];
  for (const glyph of glyphs) offsets.push((offsets.at(-1) ?? 0) + glyph.length);
  const head = new Words().u32(0x10000, 0, 0, 0x5f0f3cf5).u16(0, EM).u32(0, 0, 0, 0).u16(0, 0, EM, EM, 0, 8, 2, 1, 0);
  const hhea = new Words().u32(0x10000).u16(800, 0x10000 - 200, 0, 600, 0, 0, EM, 1, 0, 0, 0, 0, 0, 0, 0, 1);
  const maxp = new Words().u32(0x10000).u16(glyphs.length, 3, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, parts, levels);
  const hmtx = new Words().u16(600, 0, ...glyphs.slice(1).map(() => 0));
  const cmap = new Words().u16(0, 1, 3, 10).u32(12).u16(12, 0).u32(28, 0, 1, 0x41, 0x41, levels);
  const tables = {
    cmap,
    glyf: new Words().bytes(glyphs.flat()),
    head,
    hhea,
    hmtx,
    loca: new Words().u32(...offsets),
    maxp,
  };
  const directory = new Words().u32(0x10000).u16(Object.keys(tables).length, 64, 2, 48);
  const bodies: number[] = [];
  const start = 12 + 16 * Object.keys(tables).length;
  for (const [tag, { all }] of Object.entries(tables)) {
    directory.bytes([...new TextEncoder().encode(tag)]).u32(0, start + bodies.length, all.length);
    bodies.push(...all, ...Array<number>(-all.length & 3).fill(0));
  }
  return Uint8Array.from([...directory.all, ...bodies]);
}

function triangle(): number[] {
  const points = new Words().u16(1, 0, 0, 600, 700, 2, 0).bytes([1, 1, 1]);
  return points
    .u16(0, 600, 0x10000 - 300)
    .u16(0, 0, 700)
    .bytes([0]).all;
}

function composite(of: number, parts: number): number[] {
  const glyph = new Words().u16(0xffff, 0, 0, 700, 700);
  for (let part = 0; part < parts; part++) {
    const flags = ARE_WORDS | ARE_OFFSETS | (part < parts - 1 ? MORE_FOLLOW : 0);
    glyph.u16(flags, of, part, 0);
  }
  return glyph.all;
}

/** Bytes of big-endian numbers, one after another. */
class Words {
  readonly all: number[] = [];

  bytes(values: readonly number[]): this {
    this.all.push(...values);
    return this;
  }
  u16(...values: readonly number[]): this {
    for (const value of values) this.all.push((value >> 8) & 255, value & 255);
    return this;
  }
  u32(...values: readonly number[]): this {
    for (const value of values) this.u16(value >>> 16, value & 0xffff);
    return this;
  }
}
