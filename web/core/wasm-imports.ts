/**
 * What a standalone WebAssembly module may ask of its host: a handful of WASI calls and Emscripten's notice that memory
 * grew. The core neither reads files nor the clock, so each stub gives the plainest answer that WASI allows.
 */
import { TexelcastError } from "./texelcast-error.ts";

/** WASI errno: success; bad file descriptor; function not supported. */
const SUCCESS = 0;
const BADF = 8;
const NOSYS = 52;

/** The module's memory, known only once it is instantiated. */
export interface MemoryHolder {
  memory: WebAssembly.Memory | null;
}

/** Writes the module's standard output and error to the console, a line at a time. */
function makeWriter(holder: MemoryHolder): (...args: number[]) => number {
  const decoder = new TextDecoder();
  let line = "";
  return (descriptor = 0, vectors = 0, vectorCount = 0, writtenPointer = 0) => {
    if (holder.memory === null || (descriptor !== 1 && descriptor !== 2)) return BADF;
    const view = new DataView(holder.memory.buffer);
    let written = 0;
    for (let i = 0; i < vectorCount; i++) {
      const at = view.getUint32(vectors + 8 * i, true);
      const length = view.getUint32(vectors + 8 * i + 4, true);
      line += decoder.decode(new Uint8Array(holder.memory.buffer, at, length), { stream: true });
      written += length;
    }
    view.setUint32(writtenPointer, written, true);
    const lines = line.split("\n");
    line = lines.pop() ?? "";
    for (const whole of lines) console.error(`texelcast core: ${whole}`);
    return SUCCESS;
  };
}

function makeKnownImports(holder: MemoryHolder): Record<string, (...args: number[]) => number | undefined> {
  return {
    fd_write: makeWriter(holder),
    fd_close: () => BADF,
    fd_seek: () => BADF,
    fd_read: () => BADF,
    proc_exit: (code = 0) => {
      throw new TexelcastError("engine-crashed", `The engine stopped by itself (exit code ${code}).`);
    },
    environ_sizes_get: (countPointer = 0, sizePointer = 0) => {
      if (holder.memory === null) return BADF;
      const view = new DataView(holder.memory.buffer);
      view.setUint32(countPointer, 0, true);
      view.setUint32(sizePointer, 0, true);
      return SUCCESS;
    },
    environ_get: () => SUCCESS,
    // Nothing in the core may depend on the time (spec section 7): the same answer for every caller.
    clock_time_get: () => NOSYS,
    emscripten_notify_memory_growth: () => undefined,
  };
}

/**
 * Imports for exactly what the module asks for. Throws "unsupported" for one that no stub serves: such a module was
 * built in another way than the project's own build.
 */
export function makeImports(module: WebAssembly.Module, holder: MemoryHolder): WebAssembly.Imports {
  const known = makeKnownImports(holder);
  const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
  for (const wanted of WebAssembly.Module.imports(module)) {
    const stub = Object.hasOwn(known, wanted.name) ? known[wanted.name] : undefined;
    if (wanted.kind !== "function" || stub === undefined) {
      throw new TexelcastError(
        "unsupported",
        `The engine's WebAssembly asks for ${wanted.module}.${wanted.name}, which this host does not offer.`,
        { field: `${wanted.module}.${wanted.name}`, hint: "Build the module with the project's own preset." },
      );
    }
    const group = imports[wanted.module] ?? {};
    group[wanted.name] = stub;
    imports[wanted.module] = group;
  }
  return imports;
}
