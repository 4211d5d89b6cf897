import { expect, it, vi } from "vitest";
import { decodeDataUri, encodeDataUri } from "../../web/editor/document/data-uri.ts";

const bytes = Uint8Array.from({ length: 70_000 }, (_, place) => place % 256);

it("gives back every byte that was put into it", () => {
  const uri = encodeDataUri("image/png", bytes);
  expect(uri.slice(0, 22)).toBe("data:image/png;base64,");
  expect(decodeDataUri(uri, "a")).toEqual(bytes);
});

it("is base64 without a gap or filling inside, however long it is", () => {
  for (const length of [0, 1, 2, 3, 32_765, 32_766, 32_767, 65_533, 70_000]) {
    const part = bytes.subarray(0, length);
    const base64 = Buffer.from(part).toString("base64");
    expect(encodeDataUri("image/png", part)).toBe(`data:image/png;base64,${base64}`);
  }
});

it("is written without a step for each of its bytes, which a phone waits a second for where it is a photo", () => {
  const ofAllArrays: Uint8Array = Object.getPrototypeOf(Uint8Array.prototype);
  const steps = vi.spyOn(ofAllArrays, Symbol.iterator);
  encodeDataUri("image/png", bytes);
  const { length } = steps.mock.calls;
  steps.mockRestore();
  expect(length).toBe(0);
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
