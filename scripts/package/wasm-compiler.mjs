/** What the core was compiled to WebAssembly with. */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { inRoot } from "../bootstrap/paths.mjs";

/** Clang's first number, as CMake has found it; null where nothing was built. @param {string} [folder] the build's */
export function clangOf(folder = inRoot("build", "wasm")) {
  const notes = join(folder, "CMakeFiles");
  // One folder for each version of CMake that has configured it.
  const files = (existsSync(notes) ? readdirSync(notes) : [])
    .map((name) => join(notes, name, "CMakeCXXCompiler.cmake"))
    .filter((file) => existsSync(file));
  const found = files.map((file) => /^set\(CMAKE_CXX_COMPILER_VERSION "(\d+)\./m.exec(readFileSync(file, "utf8")));
  return found[0] ? Number(found[0][1]) : null;
}
