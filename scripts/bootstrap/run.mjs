/** Running other programs. */
import { spawn, spawnSync } from "node:child_process";
import { ROOT } from "./paths.mjs";
import { SetUpError } from "./set-up-error.mjs";

const TAIL_LINES = 60;

/**
 * Runs a program to its end without showing its output; where it fails, throws with the last lines of it.
 * @param {string} program @param {readonly string[]} args
 * @param {{cwd?: string, env?: NodeJS.ProcessEnv, shell?: boolean}} [options]
 * @returns {Promise<string>} what it printed
 */
export function run(program, args, { cwd = ROOT, env = process.env, shell = false } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { cwd, env, shell, stdio: ["ignore", "pipe", "pipe"] });
    let output = "";
    for (const stream of [child.stdout, child.stderr]) {
      stream.setEncoding("utf8").on("data", (text) => {
        output += text;
      });
    }
    child.on("error", (error) => reject(new SetUpError(`${program} could not be started: ${error.message}`)));
    child.on("close", (code, signal) => {
      if (code === 0) return resolve(output);
      const tail = output.trimEnd().split("\n").slice(-TAIL_LINES).join("\n");
      reject(
        new SetUpError(`${[program, ...args].join(" ")}\nended with ${signal ?? `exit code ${code}`}:\n\n${tail}`),
      );
    });
  });
}

/**
 * Runs a short program and gives its output, or null where it is missing or fails.
 * @param {string} program @param {readonly string[]} args words without spaces @param {NodeJS.ProcessEnv} [env]
 * @param {boolean} [shell] without one, Windows starts no .bat; to it, a folder with a space is two words unless quoted
 */
export function outputOf(program, args, env = process.env, shell = process.platform === "win32") {
  const result = spawnSync(shell ? `"${program}"` : program, args, { cwd: ROOT, env, encoding: "utf8", shell });
  return result.status === 0 ? result.stdout.trim() : null;
}

/**
 * Runs a program that shares this one's terminal.
 * @param {string} program @param {readonly string[]} args @param {NodeJS.ProcessEnv} [env]
 * @returns {Promise<number>} its exit code; 128 and more where a signal ended it
 */
export function runVisibly(program, args, env = process.env) {
  return new Promise((resolve) => {
    const child = spawn(program, args, { cwd: ROOT, env, stdio: "inherit" });
    child.on("error", (error) => {
      process.stderr.write(`${program} could not be started: ${error.message}\n`);
      resolve(127);
    });
    child.on("close", (code) => resolve(code ?? 128));
  });
}
