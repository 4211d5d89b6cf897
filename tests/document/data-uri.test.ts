import { expect, it } from "vitest";
import { decodeDataUri, encodeDataUri } from "../../web/editor/document/data-uri.ts";

const bytes = Uint8Array.from({ length: 70_000 }, (_, place) => place % 256);

it("gives back every byte that was put into it", () => {
  const uri = encodeDataUri("image/png", bytes);
  expect(uri.slice(0, 22)).toBe("data:image/png;base64,");
  expect(decodeDataUri(uri, "a")).toEqual(bytes);
});

it("may have its bytes as text, those that are no letters by their numbers", () => {
  expect(decodeDataUri("data:image/svg+xml,%3Csvg/%3e", "a")).toEqual(new TextEncoder().encode("<svg/>"));
});

it("is refused by the name of what has it where it is malformed", () => {
  for (const uri of ["data:image/png;base64,&", "data:image/png", "https://example.org/a.png"]) {
    expect(() => decodeDataUri(uri, "assets.logo")).toThrow("assets.logo");
  }
});

it("may be text as it is, whose letters are UTF-8 and whose # ends nothing", () => {
  const drawing = '<svg fill="#f00"><title>für 5 €</title></svg>';
  expect(decodeDataUri(`data:image/svg+xml;utf8,${drawing}`, "a")).toEqual(new TextEncoder().encode(drawing));
});

it("may have signs of base64 by their numbers, spaces between them, and any capitals", () => {
  const told = Uint8Array.of(251, 255);
  for (const uri of [
    "data:image/png;base64,%2B%2f8%3D",
    "data:image/png; base64,+/ 8=",
    "DATA:image/png;BASE64,+/8=",
  ]) {
    expect(decodeDataUri(uri, "a")).toEqual(told);
  }
});
