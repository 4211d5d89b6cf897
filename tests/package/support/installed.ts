/** The package as a shop gets it: packed by npm and installed into an empty folder. */
import { execFile } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { promisify } from "node:util";

export const CHECKOUT = new URL("../../../", import.meta.url).pathname;

const run = promisify(execFile);

export interface InstalledPackage {
  /** What npm would upload. */
  readonly tarball: string;
  /** An empty project with nothing but the package installed. */
  readonly folder: string;
  /** Lays a package of the checkout beside it, as the shop's own choice of it. */
  readonly provide: (name: string, from?: string) => void;
  readonly remove: () => void;
}

/** Packs build/package, which `npm run package` makes, and installs it without a network. */
export async function installPackage(): Promise<InstalledPackage> {
  const place = mkdtempSync(join(tmpdir(), "texelcast-package-"));
  const folder = join(place, "shop");
  mkdirSync(folder);
  const packed = await npm(place, ["pack", join(CHECKOUT, "build/package"), "--json"]);
  const [{ filename }] = JSON.parse(packed) as [{ filename: string }];
  const tarball = join(place, filename);
  writeFileSync(join(folder, "package.json"), JSON.stringify({ private: true, type: "module" }));
  await npm(folder, ["install", tarball, "--offline", "--ignore-scripts"]);
  return {
    tarball,
    folder,
    provide: (name, from = name) => {
      const place = join(folder, "node_modules", name);
      mkdirSync(dirname(place), { recursive: true });
      symlinkSync(join(CHECKOUT, "node_modules", from), place, "dir");
    },
    remove: () => rmSync(place, { recursive: true, force: true }),
  };
}

async function npm(folder: string, args: readonly string[]): Promise<string> {
  const quiet = ["--no-audit", "--no-fund", "--loglevel=error"];
  const { stdout } = await run("npm", [...args, ...quiet], { cwd: folder, shell: process.platform === "win32" });
  return stdout;
}

/** Runs a script of the shop's in bare Node; gives what it prints. */
export async function runInNode(folder: string, script: string): Promise<string> {
  const { stdout } = await run(process.execPath, ["--input-type=module", "--eval", script], { cwd: folder });
  return stdout.trim();
}

/** Copies the files of a test's shop into the folder. */
export function addShopFiles(folder: string, files: Readonly<Record<string, string | Uint8Array>>): void {
  for (const [name, content] of Object.entries(files)) {
    mkdirSync(join(folder, name, ".."), { recursive: true });
    writeFileSync(join(folder, name), content);
  }
  cpSync(join(CHECKOUT, "build/public/demo/mug.glb"), join(folder, "mug.glb"));
}
