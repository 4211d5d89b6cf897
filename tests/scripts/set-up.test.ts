import { mkdirSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { chromiumPlaces } from "../../scripts/bootstrap/chromium.mjs";
import { findFirefox, whyNoFirefox } from "../../scripts/bootstrap/firefox.mjs";
import { inRoot } from "../../scripts/bootstrap/paths.mjs";
import { Progress } from "../../scripts/bootstrap/progress.mjs";
import { outputOf } from "../../scripts/bootstrap/run.mjs";
import { stampedStep } from "../../scripts/bootstrap/stamps.mjs";
import { howToInstall } from "../../scripts/bootstrap/system.mjs";
import { findWebkitDriver, whyNoWebkit } from "../../scripts/bootstrap/webkit.mjs";
import { clangOf } from "../../scripts/package/wasm-compiler.mjs";
import { stagesOf } from "../../scripts/test/stages.mjs";

const FOLDER = "build/test-set-up";
const STAMP = "test-set-up";
const progress = new Progress({ quiet: true });
progress.line = () => {};

function write(name: string, text: string): void {
  writeFileSync(inRoot(FOLDER, name), text);
}

function makeStep() {
  const counter = { runs: 0 };
  const step = stampedStep({
    name: STAMP,
    title: "a test's step",
    inputs: [`${FOLDER}/input`],
    outputs: [`${FOLDER}/output.txt`],
    work: async () => {
      counter.runs += 1;
      write("output.txt", "made");
    },
  });
  return { counter, step };
}

function cleanUp(): void {
  rmSync(inRoot(FOLDER), { recursive: true, force: true });
  rmSync(inRoot("build/.stamps", STAMP), { force: true });
}

describe("a step of the set-up", () => {
  beforeEach(() => {
    cleanUp();
    mkdirSync(inRoot(FOLDER, "input"), { recursive: true });
    write("input/a.txt", "one");
  });
  afterEach(cleanUp);

  test("is done once, and then fresh", async () => {
    const { counter, step } = makeStep();
    expect(step.isFresh()).toBe(false);
    await step.bringUpToDate(progress);
    await step.bringUpToDate(progress);
    expect(step.isFresh()).toBe(true);
    expect(counter.runs).toBe(1);
  });

  test.each([
    ["an input changed", () => write("input/a.txt", "two")],
    ["an input was added", () => write("input/b.txt", "")],
    ["an input was renamed", () => renameSync(inRoot(FOLDER, "input/a.txt"), inRoot(FOLDER, "input/c.txt"))],
    ["its product was deleted", () => rmSync(inRoot(FOLDER, "output.txt"))],
  ])("is done again when %s", async (_, change) => {
    const { counter, step } = makeStep();
    await step.bringUpToDate(progress);
    change();
    expect(step.isFresh()).toBe(false);
    await step.bringUpToDate(progress);
    expect(counter.runs).toBe(2);
  });

  test("is done again after it failed", async () => {
    const broken = stampedStep({
      name: STAMP,
      title: "a test's step",
      inputs: [`${FOLDER}/input`],
      outputs: [],
      work: () => Promise.reject(new Error("no")),
    });
    await expect(broken.bringUpToDate(progress)).rejects.toThrow("no");
    expect(broken.isFresh()).toBe(false);
  });

  test("that ends well without its product is a fault", async () => {
    const empty = stampedStep({
      name: STAMP,
      title: "a step",
      inputs: [],
      outputs: [`${FOLDER}/none`],
      work: async () => {},
    });
    await expect(empty.bringUpToDate(progress)).rejects.toThrow(`${FOLDER}/none is not there`);
  });
});

test("what is missing is asked for by name, with one command for each kind of system", () => {
  const message = howToInstall([
    { what: "CMake 3.22 or newer", debian: "cmake", brew: "cmake", choco: "cmake" },
    { what: "Chromium", debian: "chromium", note: "Chromium: by Playwright" },
  ]);
  expect(message).toContain("- CMake 3.22 or newer\n  - Chromium");
  expect(message).toContain("sudo apt-get install --no-install-recommends cmake chromium");
  expect(message).toContain("brew install cmake\n");
  expect(message).toContain("Chromium: by Playwright");
});

test("without a WebKit to drive, the reason says what to install", () => {
  vi.stubEnv("TEXELCAST_WEBKIT_DRIVER", inRoot("no-such-driver"));
  expect(findWebkitDriver()).toBeNull();
  expect(whyNoWebkit()).toContain("- WebKitGTK and its driver, for the page's tests in it");
  expect(whyNoWebkit()).toContain("sudo apt-get install --no-install-recommends webkit2gtk-driver");
  vi.unstubAllEnvs();
});

test("without a Firefox to drive, the reason says what to install", () => {
  vi.stubEnv("TEXELCAST_FIREFOX", inRoot("no-such-firefox"));
  expect(findFirefox()).toBeNull();
  expect(whyNoFirefox()).toContain("- Firefox, for the page's tests in it");
  expect(whyNoFirefox()).toContain("sudo apt-get install --no-install-recommends firefox-esr");
  vi.unstubAllEnvs();
});

describe("a program that is asked for its version", () => {
  beforeEach(() => mkdirSync(inRoot(FOLDER, "Program Files"), { recursive: true }));
  afterEach(cleanUp);

  test("may lie in a folder whose name has a space, also where a shell starts it", () => {
    const program = inRoot(FOLDER, "Program Files", "cmake");
    writeFileSync(program, '#!/bin/sh\necho "cmake $1"\n', { mode: 0o755 });
    expect(outputOf(program, ["--version"], process.env, true)).toBe("cmake --version");
    expect(outputOf(program, ["--version"], process.env, false)).toBe("cmake --version");
  });
});

describe("an installed Chrome that no PATH leads to", () => {
  test("is looked for where macOS and Windows put it", () => {
    expect(chromiumPlaces("darwin", {})[0]).toBe("/Applications/Google Chrome.app/Contents/MacOS/Google Chrome");
    const places = chromiumPlaces("win32", {
      ProgramFiles: "C:/Program Files",
      LOCALAPPDATA: "C:/Users/a/AppData/Local",
    });
    expect(places).toHaveLength(6);
    expect(places[0]).toBe("C:/Program Files/Google/Chrome/Application/chrome.exe");
    expect(places.at(-1)).toBe("C:/Users/a/AppData/Local/Microsoft/Edge/Application/msedge.exe");
  });
});

describe("the compiler that a build was made with", () => {
  beforeEach(() => mkdirSync(inRoot(FOLDER, "CMakeFiles", "3.31.6"), { recursive: true }));
  afterEach(cleanUp);

  test("is known by what CMake noted of it, and unknown where nothing was built", () => {
    expect(clangOf(inRoot(FOLDER))).toBe(null);
    expect(clangOf(inRoot(FOLDER, "nothing"))).toBe(null);
    const noted = 'set(CMAKE_CXX_COMPILER_ID "Clang")\nset(CMAKE_CXX_COMPILER_VERSION "19.1.7")\n';
    write("CMakeFiles/3.31.6/CMakeCXXCompiler.cmake", noted);
    expect(clangOf(inRoot(FOLDER))).toBe(19);
  });
});

describe("a stage of the tests that is asked for alone", () => {
  const keysOf = (...keys: string[]): string[] => stagesOf(keys).map(({ key }) => key);

  test("is run alone, but that a browser's has the site built before", () => {
    expect(keysOf("vitest")).toEqual(["vitest"]);
    for (const browser of ["e2e", "firefox", "webkit"]) expect(keysOf(browser)).toEqual(["build", browser]);
    expect(keysOf("webkit", "build", "lint")).toEqual(["lint", "build", "webkit"]);
  });
});
