import { beforeAll, describe, expect, it } from "vitest";
import { isEmoji, joinsEmoji } from "../../web/engine/text-emoji.ts";
import { FontShelf, type TextFont } from "../../web/engine/text-fonts.ts";

const shelf = new FontShelf();
let letters: TextFont;
let emoji: TextFont;

beforeAll(async () => {
  const load = async (key: string): Promise<TextFont> => {
    await shelf.load(key);
    const font = shelf.get(key);
    if (font === undefined) throw new Error(`${key} is not on the shelf.`);
    return font;
  };
  letters = await load("texelcast:fonts/inter-400");
  emoji = await load("texelcast:fonts/noto-emoji-400");
});

function* characters(): Iterable<[code: number, character: string]> {
  for (let code = 0x20; code < 0x2ffff; code++) {
    if (code < 0xd800 || code > 0xdfff) yield [code, String.fromCodePoint(code)];
  }
}

describe("emoji", () => {
  it("are all those that Unicode knows and Inter lacks, and the font of emoji has each", () => {
    const lost: string[] = [];
    for (const [code, character] of characters()) {
      if (!/\p{Emoji}/u.test(character)) continue;
      if (isEmoji(character) ? !emoji.covers(code) : !letters.covers(code)) lost.push(code.toString(16));
    }
    expect(lost).toEqual([]);
  });

  it("are none that Inter has", () => {
    const taken = [...characters()].filter(([code, character]) => isEmoji(character) && letters.covers(code));
    expect(taken.map(([code]) => code.toString(16))).toEqual([]);
  });

  it("take only what goes on with them", () => {
    expect(joinsEmoji("🇩", "🇪")).toBe(true);
    expect(joinsEmoji("🇩🇪", "🇫")).toBe(false);
    expect(joinsEmoji("☝️", "🏻")).toBe(true);
    expect(joinsEmoji("a", "🏻")).toBe(false);
    expect(joinsEmoji("👩\u200d", "🚀")).toBe(true);
    expect(joinsEmoji("👩", "🚀")).toBe(false);
    expect(joinsEmoji("👩\u200d", "a")).toBe(false);
    expect(joinsEmoji("क\u200d", "🚀")).toBe(false);
  });
});
