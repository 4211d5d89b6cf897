/** node_modules as package-lock.json has it. */
import { existsSync, readFileSync } from "node:fs";
import { inRoot } from "./paths.mjs";
import { run } from "./run.mjs";

/** @type {import("./stamps.mjs").Step} */
export const nodePackages = {
  isFresh: isInstalled,
  async bringUpToDate(progress) {
    if (!isInstalled()) await progress.work("npm packages", () => npmCi());
  },
};

/**
 * Compares package-lock.json with npm's own record of what it installed. Better than a stamp: after a developer's
 * `npm install something` there is nothing to do, and no need to throw node_modules away.
 */
function isInstalled() {
  const installed = packagesOf("node_modules/.package-lock.json");
  const locked = packagesOf("package-lock.json");
  if (!installed || !locked) return false;
  return Object.entries(locked).every(([path, entry]) => {
    if (path === "") return true;
    const found = installed[path];
    // Other platforms' binaries are locked but not installed.
    return found ? found.version === entry.version : entry.optional === true;
  });
}

/**
 * @param {string} file
 * @returns {Record<string, {version?: string, optional?: boolean}> | null}
 */
function packagesOf(file) {
  return existsSync(inRoot(file)) ? JSON.parse(readFileSync(inRoot(file), "utf8")).packages : null;
}

/** @param {string} [folder] with a package-lock.json; default: the checkout */
export function npmCi(folder) {
  // No package of ours needs its install script; Playwright's browser is looked for by a step of its own.
  const args = ["ci", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"];
  const env = { ...process.env, PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD: "1" };
  const npm = process.env.npm_execpath;
  if (npm?.endsWith(".js")) return run(process.execPath, [npm, ...args], { cwd: folder, env });
  return run("npm", args, { cwd: folder, env, shell: process.platform === "win32" });
}
