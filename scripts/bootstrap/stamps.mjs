/**
 * Stamps: after a step has done its work, the hash of what it read is kept in build/.stamps. While the hash is the same
 * and the step's products are there, the step has nothing to do.
 */
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { BUILD, inRoot } from "./paths.mjs";

const STAMPS = join(BUILD, ".stamps");

/**
 * @typedef {object} Step
 * @property {() => boolean} isFresh
 * @property {() => import("./system.mjs").Need[]} [needs] what it lacks on this machine
 * @property {(progress: import("./progress.mjs").Progress) => Promise<void>} bringUpToDate
 */

/**
 * A step that is done again when its inputs change.
 * @param {object} options
 * @param {string} options.name of the stamp
 * @param {string} options.title for people
 * @param {readonly string[]} options.inputs files and folders, relative to the checkout; those that are missing count too
 * @param {readonly string[]} options.outputs files that must be there afterwards
 * @param {() => import("./system.mjs").Need[]} [options.needs]
 * @param {() => Promise<unknown>} options.work
 * @returns {Step}
 */
export function stampedStep({ name, title, inputs, outputs, needs, work }) {
  const stamp = join(STAMPS, name);
  /** @param {string} digest */
  const isStamped = (digest) =>
    existsSync(stamp) && readFileSync(stamp, "utf8") === digest && outputs.every((file) => existsSync(inRoot(file)));
  return {
    isFresh: () => isStamped(digestOf(inputs)),
    needs,
    async bringUpToDate(progress) {
      // Hashed before the work: a file edited meanwhile makes the next run do it again.
      const digest = digestOf(inputs);
      if (isStamped(digest)) return;
      await progress.work(title, work);
      const missing = outputs.find((file) => !existsSync(inRoot(file)));
      if (missing) throw new Error(`${title}: it ended well, but ${missing} is not there`);
      mkdirSync(STAMPS, { recursive: true });
      writeFileSync(stamp, digest);
    },
  };
}

/** @param {readonly string[]} paths relative to the checkout */
export function digestOf(paths) {
  const hash = createHash("sha256");
  for (const path of paths) addToHash(hash, path);
  return hash.digest("hex");
}

/** @param {import("node:crypto").Hash} hash @param {string} path */
function addToHash(hash, path) {
  const file = inRoot(path);
  if (!existsSync(file)) {
    hash.update(`${path}\0missing\0`);
  } else if (statSync(file).isDirectory()) {
    for (const entry of readdirSync(file).sort()) {
      if (!entry.startsWith(".")) addToHash(hash, `${path}/${entry}`);
    }
  } else {
    const bytes = readFileSync(file);
    hash.update(`${path}\0${bytes.length}\0`).update(bytes);
  }
}
