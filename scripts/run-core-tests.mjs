/**
 * Runs the core's tests as WebAssembly: `node scripts/run-core-tests.mjs [doctest options]`.
 *
 * The module gets its arguments, a terminal to write to and a clock, and nothing else of this machine. By hand, as
 * Node 20's own node:wasi ends in a segmentation fault after a long run that grew its memory (every test had passed).
 */
import { readFileSync, writeSync } from "node:fs";
import { inRoot } from "./bootstrap/paths.mjs";

const SUCCESS = 0;
const NOT_SEEKABLE = 70; // WASI's ESPIPE

class Exit extends Error {
  /** @param {number} code */
  constructor(code) {
    super(`exit ${code}`);
    this.code = code;
  }
}

const args = ["core_tests", ...process.argv.slice(2)].map((text) => Buffer.from(`${text}\0`));
/** @type {WebAssembly.Memory} */
let memory;
const view = () => new DataView(memory.buffer);

/** @type {Record<string, (...values: any[]) => number | void>} */
const wasi = {
  args_sizes_get(count, size) {
    view().setUint32(count, args.length, true);
    view().setUint32(size, Buffer.concat(args).length, true);
    return SUCCESS;
  },
  args_get(list, text) {
    let at = text;
    args.forEach((bytes, i) => {
      view().setUint32(list + i * 4, at, true);
      new Uint8Array(memory.buffer).set(bytes, at);
      at += bytes.length;
    });
    return SUCCESS;
  },
  environ_sizes_get(count, size) {
    view().setUint32(count, 0, true);
    view().setUint32(size, 0, true);
    return SUCCESS;
  },
  environ_get: () => SUCCESS,
  clock_time_get(_clock, _precision, time) {
    view().setBigUint64(time, BigInt(Math.round(performance.now() * 1e6)), true);
    return SUCCESS;
  },
  fd_write(file, pieces, count, written) {
    let total = 0;
    for (let i = 0; i < count; i++) {
      const start = view().getUint32(pieces + i * 8, true);
      const length = view().getUint32(pieces + i * 8 + 4, true);
      if (length > 0) writeSync(file === 2 ? 2 : 1, new Uint8Array(memory.buffer, start, length));
      total += length;
    }
    view().setUint32(written, total, true);
    return SUCCESS;
  },
  fd_read(_file, _pieces, _count, read) {
    view().setUint32(read, 0, true);
    return SUCCESS;
  },
  fd_fdstat_get(_file, stat) {
    new Uint8Array(memory.buffer, stat, 24).fill(0);
    return SUCCESS;
  },
  fd_seek: () => NOT_SEEKABLE,
  fd_close: () => SUCCESS,
  proc_exit(code) {
    throw new Exit(code);
  },
};

const module = await WebAssembly.compile(readFileSync(inRoot("build", "wasm", "core_tests.wasm")));
/** @type {Record<string, Record<string, WebAssembly.ImportValue>>} */
const imports = {};
for (const { module: from, name } of WebAssembly.Module.imports(module)) {
  imports[from] ??= {};
  imports[from][name] =
    from === "env"
      ? name === "emscripten_notify_memory_growth"
        ? () => {}
        : () => refuse(name)
      : (wasi[name] ?? (() => refuse(name)));
}
const { exports } = await WebAssembly.instantiate(module, imports);
memory = /** @type {WebAssembly.Memory} */ (exports.memory);
try {
  /** @type {() => void} */ (exports._start)();
} catch (thrown) {
  if (!(thrown instanceof Exit)) throw thrown;
  process.exitCode = thrown.code;
}

/** @param {string} name */
function refuse(name) {
  throw new Error(`the core called ${name}, which no host offers`);
}
