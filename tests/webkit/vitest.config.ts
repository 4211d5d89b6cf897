import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

/** The built site in WebKit with software WebGL. `npm run build` first; `npm test` does. */
export default defineConfig({
  root: fileURLToPath(new URL("../..", import.meta.url)),
  test: {
    environment: "node",
    include: ["tests/webkit/*.spec.ts"],
    // One browser with software WebGL already uses a small machine whole.
    fileParallelism: false,
    testTimeout: 90_000,
    hookTimeout: 90_000,
  },
});
