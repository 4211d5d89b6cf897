/** One set-up at a time: two commands started together in one checkout must not build into the same folder. */
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { setTimeout as wait } from "node:timers/promises";
import { BUILD } from "./paths.mjs";

const LOCK = join(BUILD, ".set-up.lock");

/**
 * @param {import("./progress.mjs").Progress} progress
 * @param {() => Promise<void>} work
 */
export async function withLock(progress, work) {
  mkdirSync(BUILD, { recursive: true });
  let waiting = false;
  while (!take()) {
    if (!waiting) progress.line("Another command is setting up this checkout; waiting for it.");
    waiting = true;
    await wait(300);
  }
  try {
    await work();
  } finally {
    rmSync(LOCK, { force: true });
  }
}

function take() {
  try {
    writeFileSync(LOCK, String(process.pid), { flag: "wx" });
    return true;
  } catch {
    // The file is there. Its owner may have been killed: then it is ours to take on the next try.
    const owner = existsSync(LOCK) ? Number(readFileSync(LOCK, "utf8")) : 0;
    if (owner > 0 && !isRunning(owner)) rmSync(LOCK, { force: true });
    return false;
  }
}

/** @param {number} pid */
function isRunning(pid) {
  try {
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return /** @type {NodeJS.ErrnoException} */ (error).code === "EPERM";
  }
}
