/**
 * The reference pictures, computed by an independent implementation of spec.md, rendered through the command line. They
 * lie beside the checkout and are not part of it.
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { closenessOnWhite } from "../support/psnr.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

const FOLDER = fileURLToPath(new URL("../../../shared/reference/", import.meta.url));
const LEAST_DECIBEL = 40;

interface ReferenceCase {
  /** Relative to the folder of the cases. */
  readonly model: string;
  readonly material: number;
  readonly size: number;
  readonly base: string;
}

const names = existsSync(FOLDER)
  ? readdirSync(FOLDER)
      .filter((file) => file.endsWith(".case.json"))
      .map((file) => file.slice(0, -".case.json".length))
      .sort()
  : [];

const picture = (file: string) => decodePicture(readFileSync(file), file);

describe("the reference pictures", () => {
  it("are compared where they are there", () => {
    if (names.length === 0)
      console.warn(`No reference pictures beside the checkout (../shared/reference): none compared.`);
    expect(existsSync(FOLDER)).toBe(names.length > 0);
  });

  it.each(names)("%s comes out at 40 dB or more", async (name) => {
    const inFolder = (kind: string): string => path.join(FOLDER, `${name}.${kind}`);
    const { model, material, size, base }: ReferenceCase = JSON.parse(readFileSync(inFolder("case.json"), "utf8"));
    const out = path.join(temporaryFolder(), "out.png");
    const options = ["--out", out, "--material", `${material}`, "--size", `${size}`, "--base", base];
    const run = await texelcast(["render", path.join(FOLDER, model), inFolder("design.json"), ...options]);
    expect(run).toMatchObject({ code: 0, stderr: "" });
    const [expected, actual, sure] = await Promise.all(
      [inFolder("expected.png"), out, inFolder("sure.png")].map(picture),
    );
    if (!expected || !actual || !sure) throw new Error("a picture is missing");
    const { decibel, comparedTexels, worst } = closenessOnWhite(expected, actual, sure);
    console.info(`${name}: ${decibel.toFixed(2)} dB over ${comparedTexels} texels, worst difference ${worst}`);
    expect(comparedTexels).toBeGreaterThan(0);
    expect(decibel).toBeGreaterThanOrEqual(LEAST_DECIBEL);
  });
});
