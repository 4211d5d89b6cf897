/** Words with characters that no font has: whoever writes a picture of them is told. */
import { writeFileSync } from "node:fs";
import path from "node:path";
import { expect, it } from "vitest";
import { planeGlb } from "./plane-model.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

const projector = { kind: "uv", center: [0.5, 0.5], size: [0.5, 0.5], angle: 0 };
const words = (text: string, fields: object = {}) => ({ type: "text", font: "bold", text, projector, ...fields });
const TOLD = 'texelcast: no font has 漢, in the text "漢 A"\n';

function folderWith(layers: readonly object[]): string {
  const folder = temporaryFolder();
  const assets = { bold: { type: "font/ttf", uri: "texelcast:fonts/inter-700" } };
  writeFileSync(path.join(folder, "plane.glb"), planeGlb());
  writeFileSync(
    path.join(folder, "design.json"),
    JSON.stringify({ format: "texelcast-design", version: 1, assets, layers }),
  );
  return folder;
}

it.each(["render", "print"])("are told of by %s on stderr, and the picture is written", async (command) => {
  const cwd = folderWith([words("漢 A"), words("B"), words("字", { visible: false }), words("文", { material: 1 })]);
  const run = await texelcast([command, "plane.glb", "design.json", "--out", "x.png", "--size", "16"], { cwd });
  expect(run).toMatchObject({ code: 0, stderr: TOLD });
  expect(run.stdout).toMatch(/^x\.png: /);
});
