import { execFile } from "node:child_process";
import { existsSync, readdirSync } from "node:fs";
import { readFile, rm, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { expect, test } from "vitest";
import { readPictureHeader } from "../../web/engine/picture-header.ts";

const root = fileURLToPath(new URL("../../", import.meta.url));

test("the README's library example runs as it stands and writes the painted texture", async () => {
  const readme = await readFile(`${root}README.md`, "utf8");
  const example = /```ts\n(.*?)```/s.exec(readme)?.[1];
  expect(example).toBeDefined();
  // Beside the README, so that its relative imports mean what they say.
  const script = `${root}.readme-example.mts`;
  await rm(`${root}build/painted.png`, { force: true });
  try {
    await writeFile(script, example as string);
    await promisify(execFile)(process.execPath, ["--import", "tsx", script], { cwd: root });
  } finally {
    await rm(script, { force: true });
  }
  const { width, height } = await readPictureHeader(await readFile(`${root}build/painted.png`), "painted.png");
  expect([width, height]).toEqual([1024, 1024]);
}, 60_000);

test("every file that the README and the documents name exists", async () => {
  const pages = ["", "docs/", "docs/guides/"].flatMap((folder) =>
    readdirSync(`${root}${folder}`)
      .filter((name) => name.endsWith(".md"))
      .map((name) => `${folder}${name}`),
  );
  for (const page of pages) {
    const text = await readFile(`${root}${page}`, "utf8");
    const folder = `${root}${page.slice(0, page.lastIndexOf("/") + 1)}`;
    const links = [...text.matchAll(/\]\(([^)#:]+)(?:#[^)]*)?\)/g)].map((match) => `${folder}${match[1]}`);
    const paths = [...text.matchAll(/`((?:wasm|web|node|tests|scripts|docs|bench)\/[\w./-]+)`/g)].map(
      (match) => `${root}${match[1]}`,
    );
    expect(
      [...links, ...paths].filter((path) => !existsSync(path)),
      page,
    ).toEqual([]);
  }
});
