import { defineConfig } from "@playwright/test";
import { chromiumLaunch } from "./scripts/bootstrap/chromium.mjs";

/** `npm test` names a free one. */
const PORT = Number(process.env.TEXELCAST_TEST_PORT ?? 4173);
const LAUNCH = chromiumLaunch();

/** The built site in Chromium with software WebGL. `npm run build` first; `npm test` does. */
export default defineConfig({
  testDir: "tests/e2e",
  outputDir: "build/test-results/e2e",
  // Two browsers on two processors take three quarters of one's time, and double what each story waits for: two of 314 failed then,
  // as letters typed that slowly are steps of their own, and a file dialog that is asked for too late does not open.
  workers: 1,
  retries: 0,
  timeout: 120_000,
  expect: { timeout: 20_000 },
  forbidOnly: true,
  reporter: [["list"], ["json", { outputFile: "build/test-results/playwright.json" }]],
  use: {
    baseURL: `http://localhost:${PORT}/`,
    viewport: { width: 1280, height: 800 },
    // To write one of each story, for those that fail, takes a fifth of the time: `--trace on` writes it when it is wanted.
    trace: "off",
    screenshot: "only-on-failure",
    launchOptions: {
      ...LAUNCH,
      args: [
        ...LAUNCH.args,
        // In software a smoothed picture costs a quarter more time, and no test looks at its edges.
        "--webgl-antialiasing-mode=none",
        // The page's own layers put together without the software GPU, which redraws all of them for one that changed:
        // 27 stories take 2.5 minutes instead of 3.1. WebGL stays as it is.
        "--disable-gpu-compositing",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--no-first-run",
      ],
    },
  },
  webServer: {
    command: `node node_modules/vite/bin/vite.js preview --port ${PORT} --strictPort`,
    url: `http://localhost:${PORT}/`,
    reuseExistingServer: false,
  },
});
