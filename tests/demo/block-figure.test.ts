import { type Document, type Node, WebIO } from "@gltf-transform/core";
import { validateBytes } from "gltf-validator";
import { beforeAll, describe, expect, it } from "vitest";
import { cross, dot, subtract } from "../../scripts/demo/geometry/vector.ts";
import { buildBlockFigure } from "../../scripts/demo/models/block-figure.ts";
import { BLOCK_FACES, blocksOf, faceBox, SKIN_SIZE } from "../../scripts/demo/models/block-layout.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { vectorAt } from "./demo-files.ts";
import { chartNumbers, coverTexels } from "./texel-coverage.ts";

const files = new Map<string, Uint8Array>();
const documents = new Map<string, Document>();
const FIGURES = [
  { id: "block-wide", arms: "wide", arm: 4 },
  { id: "block-slim", arms: "slim", arm: 3 },
] as const;

beforeAll(async () => {
  for (const { id, arms } of FIGURES) {
    const bytes = await buildBlockFigure(arms);
    files.set(id, bytes);
    documents.set(id, await new WebIO().readBinary(bytes));
  }
});

const nodesOf = (id: string): Node[] => (documents.get(id) as Document).getRoot().listNodes();

interface NodeGeometry {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly uvs: Float32Array;
  readonly indices: Uint16Array;
}

function geometryOf(node: Node): NodeGeometry {
  const [primitive] = node.getMesh()?.listPrimitives() ?? [];
  const floats = (name: string): Float32Array => primitive?.getAttribute(name)?.getArray() as Float32Array;
  return {
    positions: floats("POSITION"),
    normals: floats("NORMAL"),
    uvs: floats("TEXCOORD_0"),
    indices: primitive?.getIndices()?.getArray() as Uint16Array,
  };
}

describe.each(FIGURES)("the block figure with $arms arms", ({ id, arms, arm }) => {
  it("has no error and no warning from the glTF validator", async () => {
    const { issues } = await validateBytes(files.get(id) as Uint8Array);
    expect(issues.messages.filter(({ severity }) => severity <= 1)).toEqual([]);
  });

  it("unfolds its boxes where the common arrangement has them", () => {
    const at = (name: string, face: (typeof BLOCK_FACES)[number]) => {
      const block = blocksOf(arms).find((candidate) => candidate.name === name);
      return block && Object.values(faceBox(block, face));
    };
    expect(at("Head", "front")).toEqual([8, 8, 8, 8]);
    expect(at("Head", "top")).toEqual([8, 0, 8, 8]);
    expect(at("Head overlay", "front")).toEqual([40, 8, 8, 8]);
    expect(at("Torso", "front")).toEqual([20, 20, 8, 12]);
    expect(at("Torso", "back")).toEqual([32, 20, 8, 12]);
    expect(at("Right arm", "front")).toEqual([44, 20, arm, 12]);
    expect(at("Left arm", "front")).toEqual([36, 52, arm, 12]);
    expect(at("Left arm overlay", "front")).toEqual([52, 52, arm, 12]);
    expect(at("Right leg", "bottom")).toEqual([8, 16, 4, 4]);
    expect(at("Left leg", "front")).toEqual([20, 52, 4, 12]);
  });

  it("covers every texel of its faces once, and no other", () => {
    const expected = new Uint16Array(SKIN_SIZE * SKIN_SIZE);
    for (const block of blocksOf(arms)) {
      for (const face of BLOCK_FACES) {
        const { x, y, width, height } = faceBox(block, face);
        for (let row = y; row < y + height; row++) {
          for (let column = x; column < x + width; column++) expected[row * SKIN_SIZE + column] = 1;
        }
      }
    }
    const counts = new Uint16Array(SKIN_SIZE * SKIN_SIZE);
    for (const node of nodesOf(id)) {
      const { uvs, indices } = geometryOf(node);
      const coverage = coverTexels(uvs, indices, chartNumbers(uvs, indices), SKIN_SIZE, SKIN_SIZE);
      for (const [texel, count] of coverage.counts.entries()) counts[texel] = (counts[texel] as number) + count;
    }
    expect(Buffer.compare(Buffer.from(counts.buffer), Buffer.from(expected.buffer))).toBe(0);
  });

  it("shares no edge of a chart between two boxes", () => {
    const seen = new Map<string, string>();
    for (const node of nodesOf(id)) {
      const { uvs } = geometryOf(node);
      const corners = new Set<string>();
      for (let vertex = 0; vertex < uvs.length; vertex += 2) corners.add(`${uvs[vertex]} ${uvs[vertex + 1]}`);
      for (const corner of corners) {
        expect(seen.get(corner), `${node.getName()} at ${corner}`).toBeUndefined();
        seen.set(corner, node.getName());
      }
    }
  });

  it("mirrors the undersides alone", () => {
    for (const node of nodesOf(id)) {
      const { uvs, normals, indices } = geometryOf(node);
      for (let first = 0; first < indices.length; first += 3) {
        const [a, b, c] = [...indices.subarray(first, first + 3)] as [number, number, number];
        const u = (vertex: number): number => uvs[vertex * 2] as number;
        const v = (vertex: number): number => uvs[vertex * 2 + 1] as number;
        const area = (u(b) - u(a)) * (v(c) - v(a)) - (v(b) - v(a)) * (u(c) - u(a));
        const underside = vectorAt(normals, a)[1] < 0;
        expect(area > 0, `${node.getName()}, triangle ${first / 3}`).toBe(underside);
      }
    }
  });

  it("is seen from outside, as its normals say", () => {
    for (const node of nodesOf(id)) {
      const { positions, normals, indices } = geometryOf(node);
      for (let first = 0; first < indices.length; first += 3) {
        const [a, b, c] = [...indices.subarray(first, first + 3)].map((vertex) => vectorAt(positions, vertex)) as [
          never,
          never,
          never,
        ];
        const face = cross(subtract(b, a), subtract(c, a));
        expect(dot(face, vectorAt(normals, indices[first] as number))).toBeGreaterThan(0);
      }
    }
  });

  it("stands 1.8 m tall, its outer layer around it and hidden at first", () => {
    let top = 0;
    for (const node of nodesOf(id)) {
      const { positions } = geometryOf(node);
      const [, height] = node.getWorldTranslation();
      const outer = node.getName().endsWith("overlay");
      const data = node.getExtras().texelcast as { group: string; hidden: boolean } | undefined;
      expect(data).toEqual(outer ? { group: "Overlay", hidden: true } : undefined);
      for (let at = 1; at < positions.length; at += 3) {
        if (!outer) top = Math.max(top, height + (positions[at] as number));
      }
    }
    expect(top).toBeCloseTo(1.8, 5);
  });

  it("has a skin that is blank: tinted parts, and nothing on the outer layer", async () => {
    const png = (documents.get(id) as Document).getRoot().listTextures()[0]?.getImage();
    const { width, height, rgba } = await decodePicture(png as Uint8Array, "skin.png");
    expect([width, height]).toEqual([SKIN_SIZE, SKIN_SIZE]);
    const alpha = (x: number, y: number): number => rgba[(y * SKIN_SIZE + x) * 4 + 3] as number;
    expect([alpha(12, 12), alpha(24, 26), alpha(44, 12), alpha(24, 42)]).toEqual([255, 255, 0, 0]);
  });

  it("is shown in squares: its sampler asks for the nearest texel", () => {
    const info = (documents.get(id) as Document).getRoot().listMaterials()[0]?.getBaseColorTextureInfo();
    expect(info?.getMagFilter()).toBe(9728);
  });

  it("walks and waves in loops that close", () => {
    const animations = (documents.get(id) as Document).getRoot().listAnimations();
    expect(animations.map((animation) => animation.getName())).toEqual(["Walk", "Wave"]);
    for (const sampler of animations.flatMap((animation) => animation.listSamplers())) {
      const keys = sampler.getOutput()?.getArray() as Float32Array;
      expect([...keys.subarray(-4)]).toEqual([...keys.subarray(0, 4)]);
    }
  });
});
