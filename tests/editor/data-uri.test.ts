import { expect, it } from "vitest";
import { decodeDataUri, encodeDataUri } from "../../web/editor/files/data-uri.ts";

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
