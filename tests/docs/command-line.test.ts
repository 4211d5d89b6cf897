/** The outputs on the command line's page are what its commands write, run on the demo's own models and design. */
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { zipSync } from "fflate";
import { afterAll, beforeAll, expect, test } from "vitest";
import { texelcast } from "../node/run-cli.ts";

const root = fileURLToPath(new URL("../../", import.meta.url));
const page = readFileSync(`${root}docs/command-line.md`, "utf8");
/** Without their fences. */
const blocksOf = (language: string): string[] =>
  [...page.matchAll(new RegExp(`\`\`\`${language}\\n(.*?)\`\`\``, "gs"))].map(([, block]) => block ?? "");

/** What compression comes to may change with every version; all else may not without the page. */
const withoutSizes = (text: string): string =>
  text.replaceAll(/\b[\d,]+ bytes/g, "… bytes").replaceAll(/\b[0-9a-f]{64}\b/g, "…");

let folder: string;
beforeAll(() => {
  folder = mkdtempSync(path.join(tmpdir(), "texelcast-page-"));
  cpSync(`${root}build/public/demo`, folder, { recursive: true });
  cpSync(`${root}build/public/shop/mug.zones.json`, path.join(folder, "mug.zones.json"));
  const demo = JSON.parse(readFileSync(path.join(folder, "demo.json"), "utf8")) as { models: { design: object }[] };
  writeFileSync(path.join(folder, "design.json"), JSON.stringify(demo.models[0]?.design));
  const packed = { "cup/mug.glb": "mug.glb", "board/skateboard.glb": "skateboard.glb" };
  const files = Object.entries(packed).map(([entry, file]) => [entry, readFileSync(path.join(folder, file))]);
  writeFileSync(path.join(folder, "pack.zip"), zipSync(Object.fromEntries(files)));
});
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** A terminal's lines after the commands of a block: each command, and what it wrote. */
async function transcript(block: string): Promise<string> {
  let lines = "";
  let last: number | null = null;
  for (const [line, command = ""] of block.matchAll(/^\$ (.*)\n/gm)) {
    lines += line;
    if (command === "echo $?") {
      lines += `${last}\n`;
      continue;
    }
    const [program, ...args] = command.split(" ");
    expect(program).toBe("texelcast");
    const { code, stdout, stderr } = await texelcast(args, { cwd: folder });
    lines += stdout + stderr;
    last = code;
  }
  return lines;
}

test.each(blocksOf("text").map((block) => [/^\$ (.*)/.exec(block)?.[1], block] as const))(
  "the page shows what `%s` writes",
  async (_first, block) => {
    expect(withoutSizes(await transcript(block))).toBe(withoutSizes(block));
  },
  120_000,
);

test("the page's JSON is the mug's, as `inspect --json` prints it", async () => {
  const { stdout } = await texelcast(["inspect", "mug.glb", "--json"], { cwd: folder });
  expect(blocksOf("json")).toEqual([stdout]);
});

test("the help's examples on the demo's own models do what they say", async () => {
  const examples: string[] = [];
  for (const command of ["inspect", "bake", "render", "check", "print"]) {
    const { stdout } = await texelcast([command, "--help"], { cwd: folder });
    examples.push(...[...stdout.matchAll(/^ {2}texelcast (.*)$/gm)].map(([, words]) => words ?? ""));
  }
  // Others speak of files that a reader has; the largest print takes minutes, and a redirection is the shell's.
  const own = examples.filter(
    (words) => existsSync(path.join(folder, words.split(" ")[1] ?? "")) && !/16384|>/.test(words),
  );
  expect(own.length).toBeGreaterThan(5);
  for (const words of own) {
    const { code, stderr } = await texelcast(words.split(" "), { cwd: folder });
    // The demo's design has a decal outside of the shop's print area.
    expect([words, code, stderr]).toEqual([words, words.startsWith("check") ? 3 : 0, ""]);
  }
}, 120_000);
