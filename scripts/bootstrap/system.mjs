/** What this machine has, and how to add to it where we may. */
import { accessSync, constants, existsSync, statSync } from "node:fs";
import { delimiter, join } from "node:path";
import { run } from "./run.mjs";
import { SetUpError } from "./set-up-error.mjs";

const WINDOWS = process.platform === "win32";

/**
 * The first program of these names on PATH, as a full path; null where there is none.
 * @param {...string} names
 */
export function onPath(...names) {
  const folders = (process.env.PATH ?? "").split(delimiter).filter(Boolean);
  const endings = WINDOWS ? [".exe", ".bat", ".cmd"] : [""];
  for (const name of names) {
    for (const folder of folders) {
      for (const ending of endings) {
        const file = join(folder, name + ending);
        if (isProgram(file)) return file;
      }
    }
  }
  return null;
}

/** @param {string} file */
export function isProgram(file) {
  try {
    accessSync(file, WINDOWS ? constants.R_OK : constants.X_OK);
    return statSync(file).isFile();
  } catch {
    return false;
  }
}

/** Whether we may add packages ourselves: root on Debian or a system made from it. */
export function canAptInstall() {
  return existsSync("/etc/debian_version") && process.getuid?.() === 0 && onPath("apt-get") !== null;
}

/** @param {readonly string[]} packages */
export async function aptInstall(packages) {
  const env = { ...process.env, DEBIAN_FRONTEND: "noninteractive" };
  await run("apt-get", ["update"], { env });
  await run("apt-get", ["install", "--yes", "--no-install-recommends", ...packages], { env });
}

/**
 * @typedef {object} Need
 * @property {string} what what is missing, for people
 * @property {string} debian the Debian package
 * @property {string} [brew]
 * @property {string} [choco]
 * @property {string} [note] another way to it
 */

/**
 * Installs what is missing where that is ours to do, else ends with a message that says exactly what to install.
 * @param {readonly Need[]} needs @param {import("./progress.mjs").Progress} progress
 */
export async function provide(needs, progress) {
  if (needs.length === 0) return;
  const packages = needs.map((need) => need.debian);
  if (canAptInstall()) {
    await progress.work(`Debian packages: ${packages.join(" ")}`, () => aptInstall(packages));
    return;
  }
  throw new SetUpError(howToInstall(needs));
}

/** @param {readonly Need[]} needs */
export function howToInstall(needs) {
  const missing = needs.map((need) => `  - ${need.what}`).join("\n");
  /** @param {string} title @param {string} command @param {(string | undefined)[]} names */
  const way = (title, command, names) => {
    const known = names.filter(Boolean);
    return known.length > 0 ? [`  ${title.padEnd(16)} ${command} ${known.join(" ")}`] : [];
  };
  const ways = [
    ...way(
      "Debian, Ubuntu:",
      "sudo apt-get install --no-install-recommends",
      needs.map((need) => need.debian),
    ),
    ...way(
      "macOS:",
      "brew install",
      needs.map((need) => need.brew),
    ),
    ...way(
      "Windows:",
      "choco install",
      needs.map((need) => need.choco),
    ),
    ...needs.flatMap((need) => (need.note ? [`  ${need.note}`] : [])),
  ];
  return `This machine lacks:\n${missing}\n\nInstall that, then run the same command again:\n${ways.join("\n")}`;
}
