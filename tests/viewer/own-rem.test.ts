import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { inOwnRem } from "../../web/viewer/own-rem.ts";

describe("lengths in an element on a page with a size of type of its own", () => {
  it("go by the element's rem, in rules inside of queries too", () => {
    const style = "@container (width > 31em) { p { margin: -1.5rem; } }";
    expect(inOwnRem(style)).toBe("@container (width > 31em) { p { margin: calc(-1.5*var(--_texelcast-rem,1rem)); } }");
  });

  it("are in no head of a container query in rem, which would be the page's", () => {
    const heads = ["editor", "element", "viewer"].flatMap((room) =>
      readdirSync(`web/${room}`, { encoding: "utf8", recursive: true })
        .filter((file) => /\.(ts|css)$/.test(file))
        .flatMap((file) => readFileSync(`web/${room}/${file}`, "utf8").match(/@container[^{]*\{/g) ?? []),
    );
    expect(heads.length).toBeGreaterThan(3);
    expect(heads.filter((head) => /\drem\b/.test(head))).toEqual([]);
  });
});
