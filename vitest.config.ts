import { defineConfig } from "vitest/config";

export default defineConfig({
  test: {
    environment: "node",
    include: ["tests/**/*.test.ts"],
    exclude: ["tests/e2e/**", "tests/native/**"],
    // A bake or a Draco decode in WebAssembly on a busy two-core machine takes seconds, not the default's five.
    testTimeout: 60_000,
    hookTimeout: 60_000,
    // One for each processor: the default leaves one idle, which is half of a small machine.
    maxWorkers: "100%",
  },
});
