/** Building one of CMakePresets.json. */
import { existsSync, readFileSync, rmSync } from "node:fs";
import { availableParallelism } from "node:os";
import { inRoot } from "./paths.mjs";
import { run } from "./run.mjs";

/**
 * @param {string} folder the configure preset, which is also its folder's name under build/
 * @param {string} buildPreset
 * @param {NodeJS.ProcessEnv} env
 */
export async function buildPreset(folder, buildPreset, env) {
  const cache = inRoot("build", folder, "CMakeCache.txt");
  // A folder keeps the generator it began with: CMake refuses another one.
  const generator = existsSync(cache) && /^CMAKE_GENERATOR:INTERNAL=(.*)$/m.exec(readFileSync(cache, "utf8"))?.[1];
  const configure = () =>
    run("cmake", ["--preset", folder], { env: generator ? { ...env, CMAKE_GENERATOR: generator } : env });
  try {
    await configure();
  } catch (error) {
    // The cache may come from another place or compiler: once more from nothing, which fails for the real reason if any.
    if (!existsSync(cache)) throw error;
    rmSync(cache);
    rmSync(inRoot("build", folder, "CMakeFiles"), { recursive: true, force: true });
    await run("cmake", ["--preset", folder], { env });
  }
  await run("cmake", ["--build", "--preset", buildPreset, "--parallel", String(availableParallelism())], { env });
}
