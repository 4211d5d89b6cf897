/** A screen that nobody sees, for browsers that draw WebGL on one alone. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import type { Readable } from "node:stream";
import { findXvfb } from "../../scripts/bootstrap/virtual-screen.mjs";

export interface VirtualScreen {
  /** What a browser's environment needs; nothing where the machine's own screen is used. */
  readonly environment: { readonly DISPLAY?: string };
  close(): void;
}

/** A screen with the first free number, which Xvfb writes to the descriptor that it is told. */
export async function openVirtualScreen(): Promise<VirtualScreen> {
  const xvfb = process.platform === "linux" ? findXvfb() : null;
  if (xvfb === null) return { environment: {}, close: () => {} };
  const args = ["-displayfd", "3", "-screen", "0", "1400x1000x24", "-nolisten", "tcp"];
  const child = spawn(xvfb, args, { stdio: ["ignore", "ignore", "pipe", "pipe"] });
  let words = "";
  child.stderr?.on("data", (text) => {
    words += text;
  });
  const ended = once(child, "close").then(([code]) => {
    throw new Error(`${xvfb} ended with exit code ${code}: ${words.trim()}`);
  });
  ended.catch(() => {}); // its end after the tests is no fault
  const [number] = await Promise.race([once(child.stdio[3] as Readable, "data"), ended]);
  return { environment: { DISPLAY: `:${String(number).trim()}` }, close: () => child.kill() };
}
