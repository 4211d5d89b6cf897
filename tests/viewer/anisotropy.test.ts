/** Which graphics sample a painted texture along its slope (web/viewer/anisotropy.ts). */
import type { WebGLRenderer } from "three";
import { expect, test } from "vitest";
import { anisotropyFor } from "../../web/viewer/anisotropy.ts";

const RENDERER = 0x1f01;
const UNMASKED_RENDERER_WEBGL = 0x9246;

/** Graphics that say so themselves, and behind the extension. `asked` lists what they were asked. */
function graphics(name: string, behindExtension?: string): { renderer: WebGLRenderer; asked: string[] } {
  const asked: string[] = [];
  const gl = {
    RENDERER,
    getParameter: (field: number) => {
      asked.push(field === RENDERER ? "RENDERER" : "UNMASKED_RENDERER_WEBGL");
      return field === RENDERER ? name : behindExtension;
    },
    getExtension: (extension: string) => {
      asked.push(extension);
      return behindExtension === undefined ? null : { UNMASKED_RENDERER_WEBGL };
    },
  };
  return { renderer: { getContext: () => gl } as unknown as WebGLRenderer, asked };
}

test("what is drawn without a graphics card by Mesa is sampled without anisotropy, which never ends there", () => {
  const inChromium = "ANGLE (Mesa/X.org, llvmpipe (LLVM 15.0.6 256 bits), OpenGL ES 3.2)";
  expect(anisotropyFor(graphics("WebKit WebGL", inChromium).renderer)).toBe(1);
  expect(anisotropyFor(graphics("llvmpipe, or similar", "llvmpipe, or similar").renderer)).toBe(1);
});

test("graphics cards, other software, and what does not say its name have anisotropy", () => {
  for (const name of [
    "ANGLE (NVIDIA, NVIDIA GeForce RTX 3060 (0x00002504) Direct3D11 vs_5_0 ps_5_0, D3D11)",
    "Apple GPU",
    "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)",
    undefined,
  ])
    expect(anisotropyFor(graphics("WebKit WebGL", name).renderer)).toBe(8);
  expect(anisotropyFor(graphics("Adreno (TM) 650, or similar").renderer)).toBe(8);
});

test("Firefox, which says its graphics' name at once and warns of the extension, is not asked for that", () => {
  const { renderer, asked } = graphics("llvmpipe, or similar", "llvmpipe, or similar");
  anisotropyFor(renderer);
  expect(asked).toEqual(["RENDERER"]);
});

test("graphics are asked once, since each question waits for all that was drawn before", () => {
  const { renderer, asked } = graphics("WebKit WebGL", "Apple GPU");
  anisotropyFor(renderer);
  const before = asked.length;
  anisotropyFor(renderer);
  expect(asked).toHaveLength(before);
});
