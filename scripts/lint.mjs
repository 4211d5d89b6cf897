/**
 * Format and lint. `npm run lint` checks; `npm run format` (--write) mends what can be mended.
 */
import { bootstrapOrExit } from "./bootstrap.mjs";

await bootstrapOrExit("lint", { quiet: true });
const { CHECKS } = await import("./lint/checks.mjs");
const write = process.argv.includes("--write");
for (const check of CHECKS) {
  const result = await check.run({ write });
  console.log(`${result.padEnd(8)}${check.name}`);
  if (result === "failed") process.exitCode = 1;
}
