/** Running a program whose output is read. */
import { spawn } from "node:child_process";
import { ROOT } from "../bootstrap/paths.mjs";

/**
 * @param {string} program @param {readonly string[]} args @param {{show?: boolean}} [options] `show`: while it runs, too
 * @returns {Promise<{output: string, exitCode: number}>} exit code 128 where a signal ended it
 */
export function runAndRead(program, args, { show = false } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { cwd: ROOT, stdio: ["ignore", "pipe", "pipe"] });
    let output = "";
    for (const stream of [child.stdout, child.stderr]) {
      stream.setEncoding("utf8").on("data", (text) => {
        output += text;
        if (show) process.stdout.write(text);
      });
    }
    child.on("error", reject);
    child.on("close", (code) => resolve({ output, exitCode: code ?? 128 }));
  });
}
