import { describe, expect, it } from "vitest";
import { npyHeader } from "../../node/npy.ts";

const textOf = (header: Uint8Array): string => Buffer.from(header).toString("latin1");

describe("the header of a NumPy array file", () => {
  it("is the one that numpy.save writes", () => {
    const written = textOf(npyHeader("float32", [512, 256, 3]));
    const description = "{'descr': '<f4', 'fortran_order': False, 'shape': (512, 256, 3), }";
    expect(written).toBe(`\x93NUMPY\x01\x00\x76\x00${description.padEnd(117)}\n`);
  });

  it("writes bytes without an order, and one dimension with a comma", () => {
    expect(textOf(npyHeader("uint8", [7]))).toContain("{'descr': '|u1', 'fortran_order': False, 'shape': (7,), }");
  });

  it.each([[[1, 1]], [[8192, 8192, 3]], [[123, 45, 6]]])(
    "ends in a line feed at a multiple of 64 bytes for %j",
    (shape) => {
      const header = npyHeader("float32", shape);
      expect(header.length % 64).toBe(0);
      expect(header.at(-1)).toBe(0x0a);
      expect(new DataView(header.buffer).getUint16(8, true)).toBe(header.length - 10);
    },
  );
});
