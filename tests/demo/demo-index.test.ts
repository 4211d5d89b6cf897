import { beforeAll, describe, expect, it } from "vitest";
import { DEMO_DECALS } from "../../scripts/demo/catalogue.ts";
import { add, cross, dot, length, rotate, subtract } from "../../scripts/demo/geometry/vector.ts";
import { type Design, parseDesign, resolveLayers } from "../../web/editor/document/index.ts";
import type { EngineDecalLayer, PlanarProjector } from "../../web/engine/engine-api.ts";
import {
  type DemoFiles,
  demoFile,
  type MaterialGeometry,
  makeDemoFiles,
  readDemoModel,
  type Vec3,
  vectorAt,
} from "./demo-files.ts";

interface DemoIndex {
  readonly models: readonly {
    readonly id: string;
    readonly model: string;
    readonly material: number;
    readonly size: readonly [number, number];
    readonly design: unknown;
  }[];
  readonly templates: readonly {
    readonly id: string;
    readonly name: string;
    readonly model: string;
    readonly picture: string;
    readonly material: number;
    readonly size: readonly [number, number];
  }[];
  readonly decals: readonly { readonly id: string; readonly name: string; readonly picture: string }[];
}

let files: DemoFiles;
let index: DemoIndex;
const designOf = (model: DemoIndex["models"][number]): Design => parseDesign(model.design, `${model.id} design`);

beforeAll(async () => {
  files = await makeDemoFiles();
  index = JSON.parse(new TextDecoder().decode(demoFile(files, "demo.json"))) as DemoIndex;
});

describe("the demo's files", () => {
  it("are the same bytes in every run", async () => {
    const again = await makeDemoFiles();
    expect([...again.keys()]).toEqual([...files.keys()]);
    for (const [path, bytes] of files) expect(Buffer.compare(bytes, demoFile(again, path)), path).toBe(0);
  });

  it("are all in the index, and the index names no others", () => {
    const named = new Set([
      ...index.models.map(({ model }) => model),
      ...index.templates.flatMap(({ model, picture }) => [model, picture]),
      ...index.decals.map(({ picture }) => picture),
    ]);
    expect(["demo.json", ...[...named].map((path) => path.replace(/^demo\//, ""))].sort()).toEqual(
      [...files.keys()].sort(),
    );
  });

  it("hold decals of 512 to 1024 pixels with alpha", () => {
    for (const { picture } of index.decals) {
      const png = Buffer.from(demoFile(files, picture.replace(/^demo\//, "")));
      const [width, height] = [png.readUInt32BE(16), png.readUInt32BE(20)];
      expect(Math.min(width, height), picture).toBeGreaterThanOrEqual(512);
      expect(Math.max(width, height), picture).toBeLessThanOrEqual(1024);
      // Colour type 6 of the header: RGBA.
      expect(png[25], picture).toBe(6);
    }
  });
});

describe("the templates", () => {
  it("give the size of their model's own picture, whose parts a guide names", async () => {
    for (const { id, model, material, size } of index.templates) {
      const { document } = await readDemoModel(files, model.replace(/^demo\/|\.glb$/g, ""));
      const painted = document.getRoot().listMaterials()[material];
      expect(painted?.getBaseColorTexture()?.getSize(), id).toEqual(size);
      const extras = painted?.getExtras() as { texelcast: { guide: { part: string; uv: number[] }[] } };
      const { guide } = extras.texelcast;
      expect(guide.length, id).toBeGreaterThan(1);
      for (const { part, uv } of guide) {
        const [left, top, right, bottom] = uv as [number, number, number, number];
        expect(0 <= left && left < right && right <= 1, `${id} ${part}`).toBe(true);
        expect(0 <= top && top < bottom && bottom <= 1, `${id} ${part}`).toBe(true);
      }
    }
  });

  it("are told apart by name", () => {
    expect(new Set(index.templates.map(({ name }) => name)).size).toBe(index.templates.length);
  });
});

describe("the starting designs", () => {
  it("are valid, with nothing that the engine cannot do", () => {
    for (const model of index.models) {
      const layers = resolveLayers(designOf(model));
      expect(layers.length, model.id).toBeGreaterThan(0);
      for (const layer of layers) expect(layer).toMatchObject({ material: model.material, type: "decal" });
    }
  });

  it("refer to decals that are there", () => {
    const known = new Set(DEMO_DECALS.map(({ id }) => `decals/${id}.png`));
    for (const model of index.models) {
      for (const { uri } of Object.values(designOf(model).assets)) expect(known).toContain(uri);
    }
  });

  it("give the size of the model's own picture", async () => {
    for (const model of index.models) {
      const { document } = await readDemoModel(files, model.id);
      const material = document.getRoot().listMaterials()[model.material];
      expect(material?.getBaseColorTexture()?.getSize(), model.id).toEqual(model.size);
    }
  });

  it("keep the proportions of their pictures", () => {
    for (const model of index.models) {
      for (const layer of planarDecalsOf(model)) {
        const png = Buffer.from(demoFile(files, `decals/${layer.asset}.png`));
        const [width, height] = layer.projector.size;
        expect(width / height, `${model.id} ${layer.id}`).toBeCloseTo(png.readUInt32BE(16) / png.readUInt32BE(20), 6);
      }
    }
  });

  it("open the mug with the Texelcast mark on its outer wall", () => {
    const mug = index.models[0] as DemoIndex["models"][number];
    const [mark] = planarDecalsOf(mug);
    expect(mug.id).toBe("mug");
    expect(mark?.asset).toBe("mark");
    expect(mark?.projector.position[2]).toBeCloseTo(0.041, 6);
  });

  it("let light from every decal meet first the material that it paints, from in front", async () => {
    for (const model of index.models) {
      const { document, parts } = await readDemoModel(files, model.id);
      const painted = document.getRoot().listMaterials()[model.material]?.getName() ?? "";
      for (const layer of planarDecalsOf(model)) {
        const hits = lightThrough(layer, parts);
        const good = hits.filter((hit) => hit?.material === painted && hit.facing > 0.3);
        // Decals may hang over an edge, as the waves on the board's tail do.
        expect(good.length / hits.length, `${model.id} ${layer.id}`).toBeGreaterThan(0.5);
      }
    }
  });
});

type PlanarDecal = EngineDecalLayer & { readonly projector: PlanarProjector };

/** The demo's designs hold planar decals and nothing else. */
const planarDecalsOf = (model: DemoIndex["models"][number]): PlanarDecal[] =>
  resolveLayers(designOf(model)).map((layer) => {
    if (layer.type === "decal" && layer.projector.kind === "planar") return { ...layer, projector: layer.projector };
    throw new Error(`${model.id}: ${layer.id} is not a planar decal`);
  });

interface Hit {
  readonly material: string;
  readonly distance: number;
  /** Cosine between the surface's normal and the way back to the projector. */
  readonly facing: number;
}

interface Triangle {
  readonly material: string;
  readonly corners: readonly [Vec3, Vec3, Vec3];
  readonly normal: Vec3;
}

/** What nine by nine rays through a decal's box meet first; undefined where they meet nothing. */
function lightThrough(layer: PlanarDecal, parts: readonly MaterialGeometry[]): (Hit | undefined)[] {
  const { position, rotation, size } = layer.projector;
  const triangles = trianglesNear(position, length(size) / 2, parts);
  const direction = rotate(rotation, [0, 0, -1]);
  const steps = 9;
  return Array.from({ length: steps * steps }, (_, ray) => {
    const x = ((ray % steps) + 0.5) / steps - 0.5;
    const y = (Math.floor(ray / steps) + 0.5) / steps - 0.5;
    const start = add(position, rotate(rotation, [x * size[0], y * size[1], size[2] / 2]));
    return firstHit(start, direction, size[2], triangles);
  });
}

/** Triangles whose bounding box comes within `reach` of a point: the rays need not ask the others. */
function trianglesNear(
  point: readonly [number, number, number],
  reach: number,
  parts: readonly MaterialGeometry[],
): Triangle[] {
  const near: Triangle[] = [];
  for (const { material, positions, normals, indices } of parts) {
    for (let first = 0; first < indices.length; first += 3) {
      const at = (corner: number): Vec3 => vectorAt(positions, indices[first + corner] as number);
      const corners = [at(0), at(1), at(2)] as const;
      const isNear = ([0, 1, 2] as const).every((axis) => {
        const values = corners.map((corner) => corner[axis] - point[axis]);
        return Math.min(...values) < reach && Math.max(...values) > -reach;
      });
      if (isNear) near.push({ material, corners, normal: vectorAt(normals, indices[first] as number) });
    }
  }
  return near;
}

/** Ray against triangles, by Möller and Trumbore. */
function firstHit(
  start: readonly [number, number, number],
  direction: readonly [number, number, number],
  reach: number,
  triangles: readonly Triangle[],
): Hit | undefined {
  let nearest: Hit | undefined;
  for (const { material, corners, normal } of triangles) {
    const [a, b, c] = corners;
    const ab = subtract(b, a);
    const ac = subtract(c, a);
    const p = cross(direction, ac);
    const determinant = dot(ab, p);
    if (Math.abs(determinant) < 1e-15) continue;
    const offset = subtract(start, a);
    const u = dot(offset, p) / determinant;
    if (u < 0 || u > 1) continue;
    const q = cross(offset, ab);
    const v = dot(direction, q) / determinant;
    const distance = dot(ac, q) / determinant;
    if (v < 0 || u + v > 1 || distance < 0 || distance > Math.min(reach, nearest?.distance ?? reach)) continue;
    nearest = { material, distance, facing: -dot(normal, direction) };
  }
  return nearest;
}
