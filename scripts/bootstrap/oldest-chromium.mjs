/**
 * The oldest Chromium that the product is tested in, as a package for servers brings it: for Linux on x64, packed by Brotli and tar. Its
 * version is pinned by a lock file of its own (tests/oldest-chromium).
 */
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { brotliDecompressSync } from "node:zlib";
import { npmCi } from "./node-packages.mjs";
import { inRoot } from "./paths.mjs";
import { run } from "./run.mjs";
import { stampedStep } from "./stamps.mjs";

const FOLDER = "build/oldest-chromium";
const PROGRAM = `${FOLDER}/chromium`;
const PACKAGE = ["package.json", "package-lock.json"];

const fetched = stampedStep({
  name: "oldest-chromium",
  title: "the oldest Chromium to test in (build/oldest-chromium)",
  inputs: PACKAGE.map((file) => `tests/oldest-chromium/${file}`),
  outputs: [PROGRAM],
  work: fetchIt,
});

/** Elsewhere there is none, and its stories are left out. @type {import("./stamps.mjs").Step} */
export const oldestChromium = {
  isFresh: () => !isForThisMachine() || fetched.isFresh(),
  bringUpToDate: async (progress) => {
    if (isForThisMachine()) await fetched.bringUpToDate(progress);
  },
};

/** How it is launched: with the libraries beside it, drawing WebGL in software. Null where there is none for the machine. */
export function oldestChromiumLaunch() {
  if (!isForThisMachine()) return null;
  return {
    executablePath: inRoot(PROGRAM),
    env: { ...process.env, LD_LIBRARY_PATH: inRoot(FOLDER, "lib") },
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--ignore-gpu-blocklist"],
  };
}

function isForThisMachine() {
  return process.platform === "linux" && process.arch === "x64";
}

async function fetchIt() {
  const folder = inRoot(FOLDER);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const file of PACKAGE) copyFileSync(inRoot("tests/oldest-chromium", file), join(folder, file));
  await npmCi(folder);
  const packed = join(folder, "node_modules/@sparticuz/chromium/bin");
  /** @param {string} name */
  const unpacked = (name) => brotliDecompressSync(readFileSync(join(packed, `${name}.br`)));
  writeFileSync(join(folder, "chromium"), unpacked("chromium"), { mode: 0o755 });
  for (const archive of ["swiftshader.tar", "aws.tar"]) {
    writeFileSync(join(folder, archive), unpacked(archive));
    await run("tar", ["--extract", "--file", archive], { cwd: folder });
    rmSync(join(folder, archive));
  }
  rmSync(join(folder, "node_modules"), { recursive: true });
}
