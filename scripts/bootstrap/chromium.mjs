/** A Chromium for the end-to-end tests. */
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { isProgram, onPath } from "./system.mjs";

/** @type {import("./system.mjs").Need} */
const CHROMIUM = {
  what: "Chromium, for the end-to-end tests",
  debian: "chromium",
  note: "Chromium:        npx playwright install --with-deps chromium, or TEXELCAST_CHROMIUM=/path/to/chrome",
};

/** @type {import("./stamps.mjs").Step} */
export const chromium = {
  isFresh: () => findChromium() !== null,
  needs: () => (findChromium() ? [] : [CHROMIUM]),
  bringUpToDate: async () => {},
};

/** The path of the browser to test with: TEXELCAST_CHROMIUM, the system's, or Playwright's own; null where there is none. */
export function findChromium() {
  const named = process.env.TEXELCAST_CHROMIUM;
  if (named) return isProgram(named) ? named : null;
  const onItsPath = onPath("chromium", "chromium-browser", "google-chrome", "google-chrome-stable");
  return onItsPath ?? chromiumPlaces().find(isProgram) ?? playwrightsOwn();
}

/**
 * Where installers put it on systems whose PATH does not lead there.
 * @param {string} [platform] @param {NodeJS.ProcessEnv} [env]
 */
export function chromiumPlaces(platform = process.platform, env = process.env) {
  if (platform === "darwin") {
    return ["Google Chrome", "Chromium", "Microsoft Edge"].map(
      (name) => `/Applications/${name}.app/Contents/MacOS/${name}`,
    );
  }
  if (platform !== "win32") return [];
  const folders = [env.ProgramFiles, env["ProgramFiles(x86)"], env.LOCALAPPDATA].filter(
    (folder) => folder !== undefined,
  );
  const programs = [
    ["Google", "Chrome", "Application", "chrome.exe"],
    ["Chromium", "Application", "chrome.exe"],
    ["Microsoft", "Edge", "Application", "msedge.exe"],
  ];
  return programs.flatMap((parts) => folders.map((folder) => join(folder, ...parts)));
}

/**
 * What Chromium leaves out. The first two are its own pages behind the address bar, which no test sees: it loads them for each
 * new context, which takes a third of a page's opening. The last list on the command line wins, so what of Playwright's own
 * list can change how a page behaves stands here again (playwright-core, chromiumSwitches).
 */
const FEATURES_LEFT_OUT = [
  "WebUIOmniboxPopup",
  "WebUIOmniboxAimPopup",
  "AimEnabled",
  "AvoidUnnecessaryBeforeUnloadCheckSync",
  "DestroyProfileOnBrowserClose",
  "HttpsFirstBalancedModeAutoEnable",
  "HttpsUpgrades",
  "LensOverlay",
  "MediaRouter",
  "NetworkTimeServiceQuerying",
  "OptimizationHints",
  "PaintHolding",
  "PreconnectToSearch",
  "ThirdPartyStoragePartitioning",
];

/** Mesa's entry in the list of EGLs, there where it is installed; and where its drivers lie, by system. */
const MESA_EGL = "/usr/share/glvnd/egl_vendor.d/50_mesa.json";
const MESA_DRIVERS = ["x86_64-linux-gnu/dri", "aarch64-linux-gnu/dri", "dri", "../lib64/dri"];

/** Whether Mesa can draw in software here. */
function hasLlvmpipe() {
  return existsSync(MESA_EGL) && MESA_DRIVERS.some((folder) => existsSync(join("/usr/lib", folder, "swrast_dri.so")));
}

/**
 * How Chromium is launched here: it draws WebGL in software, and refuses its sandbox to root, as in a container. Where there is Mesa,
 * its llvmpipe draws in a third of the time that Chromium's own SwiftShader takes: 42 stories take 179 seconds instead of 225.
 */
export function chromiumLaunch() {
  const mesa = hasLlvmpipe();
  return {
    executablePath: findChromium() ?? undefined,
    args: [
      ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
      ...(mesa ? ["--use-gl=angle", "--use-angle=gl-egl"] : ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]),
      "--ignore-gpu-blocklist",
      `--disable-features=${FEATURES_LEFT_OUT.join()}`,
    ],
    // Neither another maker's EGL nor a GPU, so that it is drawn alike on all of them.
    ...(mesa && { env: { ...process.env, LIBGL_ALWAYS_SOFTWARE: "1", __EGL_VENDOR_LIBRARY_FILENAMES: MESA_EGL } }),
  };
}

function playwrightsOwn() {
  try {
    const file = createRequire(import.meta.url)("playwright-core").chromium.executablePath();
    return existsSync(file) ? file : null;
  } catch {
    return null; // before npm ci
  }
}
