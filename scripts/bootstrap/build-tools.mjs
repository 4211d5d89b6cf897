/** The programs that the C++ side needs: what is missing, where they are, how CMake is to be called. */
import { accessSync, constants, existsSync } from "node:fs";
import { delimiter, dirname, join } from "node:path";
import { inRoot } from "./paths.mjs";
import { outputOf } from "./run.mjs";
import { SetUpError } from "./set-up-error.mjs";
import { canAptInstall, howToInstall, isProgram, onPath } from "./system.mjs";

/** @typedef {import("./system.mjs").Need} Need */

const OLDEST_EMSCRIPTEN = [3, 1, 6];
const OLDEST_CMAKE = [3, 22, 0];
/** The version whose output the sources have; others differ in small things. */
export const CLANG_FORMAT_VERSION = 14;

/** @type {Need} */
const EMSCRIPTEN = {
  what: `Emscripten (emcc) ${OLDEST_EMSCRIPTEN.join(".")} or newer, which compiles the C++ core to WebAssembly`,
  debian: "emscripten",
  brew: "emscripten",
  choco: "emscripten",
  note: "Emscripten:      https://emscripten.org/docs/getting_started/downloads.html (emsdk; then set EMSDK or PATH)",
};
/** @type {Need} */
const CMAKE = {
  what: `CMake ${OLDEST_CMAKE.slice(0, 2).join(".")} or newer`,
  debian: "cmake",
  brew: "cmake",
  choco: "cmake",
};
/** @type {Need} */
const NINJA = { what: "Ninja (or make)", debian: "ninja-build", brew: "ninja", choco: "ninja" };
/** @type {Need} */
const COMPILER = { what: "a C++20 compiler (g++ or clang++)", debian: "g++", brew: "llvm", choco: "llvm" };
/** @type {Need} */
const CLANG_FORMAT = {
  what: "clang-format",
  debian: "clang-format",
  brew: "clang-format",
  choco: "llvm",
};
/** Installed on Debian; elsewhere CMake fetches what it does not find. */
const DEBIAN_HEADERS = [
  { header: "/usr/include/glm/glm.hpp", debian: "libglm-dev" },
  { header: "/usr/include/tiny_gltf.h", debian: "libtinygltf-dev" },
  { header: "/usr/include/rapidjson/document.h", debian: "rapidjson-dev" },
  { header: "/usr/include/doctest/doctest.h", debian: "doctest-dev" },
];

/** What compiling the core to WebAssembly lacks here. */
export function wasmNeeds() {
  return [...(findEmcc() ? [] : [EMSCRIPTEN]), ...cmakeNeeds()];
}

/** What building and testing the core natively lacks here. */
export function nativeNeeds() {
  const compiler = findCompiler() ? [] : [COMPILER];
  // Elsewhere the lint says that it was skipped: a developer without clang-format can still run the tests.
  const format = canAptInstall() && !findClangFormat() ? [CLANG_FORMAT] : [];
  return [...compiler, ...format, ...cmakeNeeds()];
}

/** The environment in which CMake finds Emscripten. Throws where it is missing or too old. */
export function wasmEnvironment() {
  const emcc = findEmcc();
  if (!emcc) throw new SetUpError(howToInstall(wasmNeeds()));
  checkVersion("Emscripten", emcc, outputOf(emcc, ["--version"]), OLDEST_EMSCRIPTEN);
  checkCMake();
  const env = { ...process.env, PATH: [dirname(emcc), process.env.PATH].join(delimiter), ...generator() };
  return { ...env, ...writableCache(env) };
}

/** The environment in which CMake builds natively. */
export function nativeEnvironment() {
  checkCMake();
  return { ...process.env, ...generator() };
}

/** @type {import("./stamps.mjs").Step} */
export const testTools = {
  isFresh: () => nativeNeeds().length === 0,
  needs: nativeNeeds,
  bringUpToDate: async () => checkCMake(),
};

export function findClangFormat() {
  return onPath(`clang-format-${CLANG_FORMAT_VERSION}`, "clang-format");
}

function findEmcc() {
  const sdk = process.env.EMSDK;
  const ours = sdk ? join(sdk, "upstream", "emscripten", process.platform === "win32" ? "emcc.bat" : "emcc") : null;
  return ours && isProgram(ours) ? ours : onPath("emcc");
}

function findCompiler() {
  return onPath("g++", "clang++", "c++", "cl");
}

/** CMake, a program for it to build with, and on Debian the headers. @returns {Need[]} */
function cmakeNeeds() {
  const headers = canAptInstall() ? DEBIAN_HEADERS.filter(({ header }) => !existsSync(header)) : [];
  return [
    ...(onPath("cmake") ? [] : [CMAKE]),
    ...(onPath("ninja", "make", "mingw32-make") ? [] : [NINJA]),
    ...headers.map(({ header, debian }) => ({ what: header, debian })),
  ];
}

function checkCMake() {
  const cmake = onPath("cmake");
  if (cmake) checkVersion("CMake", cmake, outputOf(cmake, ["--version"]), OLDEST_CMAKE);
}

/** @param {string} name @param {string} program @param {string | null} text @param {readonly number[]} oldest */
function checkVersion(name, program, text, oldest) {
  const found = /(\d+)\.(\d+)\.(\d+)/.exec(text ?? "");
  if (!found) throw new SetUpError(`${program} --version did not say its version. Is ${name} installed whole?`);
  const version = found.slice(1).map(Number);
  const difference = version.map((part, index) => part - oldest[index]).find((part) => part !== 0) ?? 0;
  if (difference < 0) {
    throw new SetUpError(`${program} is ${name} ${version.join(".")}; ${oldest.join(".")} or newer is needed.`);
  }
}

/** Ninja where it is there; CMake's own choice otherwise (make; on Windows that would be Visual Studio, so no). */
function generator() {
  if (process.env.CMAKE_GENERATOR) return {};
  if (onPath("ninja")) return { CMAKE_GENERATOR: "Ninja" };
  return { CMAKE_GENERATOR: onPath("make") ? "Unix Makefiles" : "MinGW Makefiles" };
}

/**
 * Emscripten builds its system libraries into its cache when they are first needed. Where that folder belongs to
 * somebody else and is not shipped complete, ours is used.
 * @param {NodeJS.ProcessEnv} env
 */
function writableCache(env) {
  if (env.EM_CACHE || outputOf("em-config", ["FROZEN_CACHE"], env) === "True") return {};
  const cache = outputOf("em-config", ["CACHE"], env);
  try {
    if (cache) accessSync(existsSync(cache) ? cache : dirname(cache), constants.W_OK);
    return {};
  } catch {
    return { EM_CACHE: inRoot("build", "emscripten-cache") };
  }
}
