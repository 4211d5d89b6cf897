/** The command line tool as a user runs it: the bundle, as a process of its own. */
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { onTestFinished } from "vitest";

const BUNDLE = fileURLToPath(new URL("../../build/node/texelcast.mjs", import.meta.url));

export interface Run {
  readonly code: number | null;
  readonly signal: NodeJS.Signals | null;
  readonly stdout: string;
  readonly stderr: string;
}

export interface RunOptions {
  readonly cwd?: string;
  /** Called with the process's id once it has begun to write into this folder. */
  readonly onStart?: (pid: number) => void;
  /** Ends the process, for a test of one that might not end by itself. */
  readonly signal?: AbortSignal;
  /** Written to instead of `Run.stdout`: an open file's number, or a pipe that its reader closes before a word is in it. */
  readonly stdout?: number | "closed pipe";
  /** As `stdout`, in place of `Run.stderr`. */
  readonly stderr?: number | "closed pipe";
}

export function texelcast(
  args: readonly string[],
  { cwd, onStart, signal: abort, stdout: sink, stderr: errorSink }: RunOptions = {},
): Promise<Run> {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [BUNDLE, ...args], {
      cwd,
      signal: abort,
      killSignal: "SIGKILL",
      stdio: ["ignore", ...[sink, errorSink].map((to) => (typeof to === "number" ? to : "pipe"))],
    });
    const out: Buffer[] = [];
    const err: Buffer[] = [];
    child.stdout?.on("data", (chunk: Buffer) => out.push(chunk));
    if (sink === "closed pipe") child.stdout?.destroy();
    if (errorSink === "closed pipe") child.stderr?.destroy();
    child.stderr?.on("data", (chunk: Buffer) => err.push(chunk));
    child.on("error", reject);
    child.on("close", (code, signal) => {
      const [stdout, stderr] = [out, err].map((chunks) => Buffer.concat(chunks).toString());
      resolve({ code, signal, stdout: stdout ?? "", stderr: stderr ?? "" });
    });
    if (child.pid !== undefined) onStart?.(child.pid);
  });
}

/** A folder of the running test's own, gone when it is over. */
export function temporaryFolder(): string {
  const folder = mkdtempSync(path.join(tmpdir(), "texelcast-test-"));
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}
