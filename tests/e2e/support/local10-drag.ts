/** The benchmark's drag in the page: `local10` (bench/README.md) on a torus of 20,000 triangles, at 2048 x 2048. */
import { fileURLToPath } from "node:url";
import { loadWork } from "../../../bench/work.ts";
import type { PlanarProjector } from "../../../web/engine/engine-api.ts";
import { buildGlb } from "../../support/model-builder.ts";
import { paintPng } from "../../support/png-file.ts";
import { type EditorPage, expect, type Point, type TestFile } from "./editor-page.ts";
import { file } from "./test-files.ts";

export const LOCAL10_SIZE = 2048;
export const LOCAL10_ASSET = "decal";

export interface Local10Files {
  readonly model: TestFile;
  readonly decal: TestFile;
  /** The decal's picture is inside. */
  readonly design: TestFile;
}

export async function local10Files(): Promise<Local10Files> {
  const work = await loadWork(fileURLToPath(new URL("../../../../shared/bench", import.meta.url)));
  const mesh = work.meshes.find(({ name }) => name === "torus20k");
  if (!mesh) throw new Error("The benchmark has lost its torus.");
  const [positions, normals, uvs, indices] = [mesh.positions, mesh.normals, mesh.uvs, mesh.indices].map((array) => [
    ...array,
  ]);
  const glb = buildGlb({ meshes: [{ positions, normals, uvs, indices, material: 0 }], materials: [{ name: "Torus" }] });
  const { width, height, rgba } = work.decal;
  const png = paintPng(width, height, (x, y) => {
    const at = (y * width + x) * 4;
    return [rgba[at], rgba[at + 1], rgba[at + 2], rgba[at + 3]];
  });
  const design = {
    format: "texelcast-design",
    version: 1,
    assets: {
      [LOCAL10_ASSET]: { type: "image/png", uri: `data:image/png;base64,${Buffer.from(png).toString("base64")}` },
    },
    layers: [
      {
        ...{ id: "local10", type: "decal", name: "local10", asset: LOCAL10_ASSET, occlusion: "none" },
        angleFade: [90, 90],
        projector: work.projectors.get("local10") as PlanarProjector,
      },
    ],
  };
  return {
    model: file("torus20k.glb", glb),
    decal: file("decal.png", png, "image/png"),
    design: file("local10.json", JSON.stringify(design), "application/json"),
  };
}

/** Opens model and design, at the drag's size. */
export async function openLocal10(editor: EditorPage, { model, design }: Local10Files): Promise<void> {
  await editor.open();
  await editor.openModel([model]);
  await editor.page.locator("tc-target-settings #size").selectOption(String(LOCAL10_SIZE));
  await expect.poll(() => editor.textureSize()).toEqual({ width: LOCAL10_SIZE, height: LOCAL10_SIZE });
  await editor.openDesign([design]);
  await editor.select("local10");
  await editor.idle();
}

/** Takes hold of the decal and moves it along the torus, without waiting for the engine; the button stays down. */
export async function dragLocal10(editor: EditorPage, steps: number): Promise<Point> {
  const { mouse } = editor.page;
  const from = await editor.pointOf("local10");
  await mouse.move(from.x, from.y);
  await mouse.down();
  let at = from;
  for (let step = 1; step <= steps; step += 1) {
    const share = step / steps;
    at = { x: from.x - 90 * share, y: from.y + 40 * Math.sin(share * 2 * Math.PI) };
    await mouse.move(at.x, at.y);
  }
  // The pointer's newest place is taken up in the next frame.
  await editor.page.evaluate(
    () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve(null)))),
  );
  return at;
}
