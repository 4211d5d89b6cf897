/**
 * The core's WebAssembly as a typed object. Everything that touches the module's memory goes through here, and no view
 * of it outlives the call that made it: the memory may grow, which detaches every view.
 */
import { ABI_VERSION, CORE_FUNCTIONS, type CoreFunction } from "./abi.ts";
import { readBytes } from "./read-bytes.ts";
import { readStruct, type StructFields, type StructLayout, type StructValue, writeStruct } from "./struct-layout.ts";
import { TexelcastError, type TexelcastErrorDetails } from "./texelcast-error.ts";
import { type MemoryHolder, makeImports } from "./wasm-imports.ts";

declare global {
  namespace WebAssembly {
    /** Known to the DOM's types alone, which a server's project does not have. */
    interface Module {}
  }
}

export type CoreSource = URL | string | ArrayBuffer | ArrayBufferView<ArrayBuffer> | WebAssembly.Module;

const NO_ENGINE = {
  reason: "no-engine",
  hint: "Check its address. WebAssembly with SIMD is needed: Chrome 91, Firefox 89, Safari 16.4, Node 20 or newer.",
};
const NO_MEMORY = { hint: "Close other pages and programs, and try again." } as const;
const SAME_RELEASE = "Build or install both from the same release.";

/**
 * Loads the core: an address, its bytes, or a compiled module; the project's own build by default. Rejects with
 * "missing-file" when it cannot be read, "unsupported" when it cannot run here or speaks another ABI version, and "out-of-budget" when
 * the machine has no memory for it.
 */
export async function loadCore(source?: CoreSource): Promise<CoreModule> {
  const module = await compile(source ?? new URL("../../build/wasm/texelcast.wasm", import.meta.url));
  const holder: MemoryHolder = { memory: null };
  const imports = makeImports(module, holder);
  let instance: WebAssembly.Instance;
  try {
    instance = await WebAssembly.instantiate(module, imports);
  } catch (cause) {
    const isFull = cause instanceof RangeError;
    const told = `The engine's WebAssembly could not be started: ${reasonOf(cause)}.`;
    throw new TexelcastError(isFull ? "out-of-budget" : "unsupported", told, {
      ...(isFull ? NO_MEMORY : NO_ENGINE),
      cause,
    });
  }
  return new CoreModule(instance, holder);
}

async function compile(source: CoreSource): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  const isAddress = typeof source === "string" || source instanceof URL;
  const bytes = isAddress ? await readBytes(source, "The engine's WebAssembly") : source;
  try {
    return await WebAssembly.compile(bytes);
  } catch (cause) {
    throw new TexelcastError("unsupported", `The engine's WebAssembly could not be compiled: ${reasonOf(cause)}.`, {
      ...(isAddress && { subject: String(source) }),
      ...NO_ENGINE,
      cause,
    });
  }
}

function reasonOf(thrown: unknown): string {
  return (thrown instanceof Error ? thrown.message : String(thrown)).replace(/\.$/, "");
}

type RawFunction = (...args: number[]) => number | undefined;

/** One running module. After a trap it refuses every further call: its memory can no longer be trusted. */
export class CoreModule {
  readonly #memory: WebAssembly.Memory;
  readonly #functions: Readonly<Record<CoreFunction, RawFunction>>;
  /** Status names by number, as the module itself lists them: "OK", "PENDING", "BAD_ARGUMENT", … */
  readonly statusNames: readonly string[];
  readonly #ok: number;
  readonly #pending: number;
  #crash: TexelcastError | null = null;

  /** For `loadCore`: `holder` is where the module's imports look for its memory. @internal */
  constructor(instance: WebAssembly.Instance, holder: MemoryHolder) {
    const { memory } = instance.exports;
    if (!(memory instanceof WebAssembly.Memory)) throw notACore("memory");
    this.#memory = memory;
    holder.memory = memory;
    const functions: Partial<Record<CoreFunction, RawFunction>> = {};
    for (const name of Object.keys(CORE_FUNCTIONS) as CoreFunction[]) {
      const found = instance.exports[name];
      if (typeof found !== "function") throw notACore(name);
      functions[name] = found as RawFunction;
    }
    this.#functions = functions as Record<CoreFunction, RawFunction>;
    const { _initialize: initialize } = instance.exports;
    if (typeof initialize === "function") this.#guard(initialize as RawFunction, []);

    const version = this.call("txc_abi_version");
    if (version !== ABI_VERSION) {
      throw new TexelcastError(
        "unsupported",
        `The engine's WebAssembly has ABI version ${version}, but this program needs version ${ABI_VERSION}.`,
        { field: "txc_abi_version", value: String(version), hint: SAME_RELEASE },
      );
    }
    const names: string[] = [];
    for (let status = 0; status < this.call("txc_status_count"); status++) {
      names.push(this.readText(this.call("txc_status_name", status)));
    }
    this.statusNames = names;
    this.#ok = names.indexOf("OK");
    this.#pending = names.indexOf("PENDING");
  }

  /** Whether the module trapped; every call throws then. */
  get crashed(): boolean {
    return this.#crash !== null;
  }

  /** Bytes of the module's memory, for statistics: it never shrinks. */
  get memoryBytes(): number {
    return this.#memory.buffer.byteLength;
  }

  /** Calls a function of the module. Results are unsigned. Throws "engine-crashed" if it traps or has trapped. */
  call(name: CoreFunction, ...args: number[]): number {
    if (this.#crash !== null) throw this.#crash;
    return this.#guard(this.#functions[name], args);
  }

  #guard(raw: RawFunction, args: number[]): number {
    try {
      return (raw(...args) ?? 0) >>> 0;
    } catch (cause) {
      this.#crash = new TexelcastError("engine-crashed", `The engine crashed: ${reasonOf(cause)}.`, {
        hint: "Start a new engine and load the model again. Please report what led to this.",
        cause,
      });
      throw this.#crash;
    }
  }

  /** Calls a function that gives a status. Returns true when there is more to do; throws for every failure. */
  run(name: CoreFunction, ...args: number[]): boolean {
    const status = this.call(name, ...args);
    if (status === this.#ok) return false;
    if (status === this.#pending) return true;
    throw this.statusError(status, this.readText(this.call("txc_error_detail")));
  }

  /** A status as error: the code is its name in lower case with dashes, the message the module's own. */
  statusError(status: number, detail = "", details: TexelcastErrorDetails = {}): TexelcastError {
    return new TexelcastError(this.statusCode(status), sentence(this.statusMessage(status), detail), details);
  }

  /** "no-uvs" for NO_UVS. */
  statusCode(status: number): string {
    return (this.statusNames[status] ?? "UNKNOWN").toLowerCase().replaceAll("_", "-");
  }

  statusMessage(status: number): string {
    return this.readText(this.call("txc_status_message", status));
  }

  /** Whether a status number that came as data (not as a result) means "done". */
  isOk(status: number): boolean {
    return status === this.#ok;
  }

  /** Lends `byteCount` bytes inside the module for the time of `use`. Throws "out-of-budget" when there are none. */
  withMemory<Result>(byteCount: number, use: (pointer: number) => Result): Result {
    const pointer = byteCount <= 0xffffffff ? this.call("txc_alloc", Math.max(byteCount, 1)) : 0;
    if (pointer === 0) {
      throw new TexelcastError(
        "out-of-budget",
        `The engine's memory is used up: ${Math.ceil(byteCount / 2 ** 20)} MiB more could not be had.`,
        { value: String(byteCount), hint: "Choose a smaller size, or close targets that are no longer needed." },
      );
    }
    try {
      return use(pointer);
    } finally {
      if (!this.crashed) this.call("txc_free", pointer);
    }
  }

  /** Copies bytes into the module for the time of `use`; pointer 0 for null. */
  withBytes<Result>(bytes: ArrayBufferView | null, use: (pointer: number) => Result): Result {
    if (bytes === null) return use(0);
    return this.withMemory(bytes.byteLength, (pointer) => {
      const source = new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
      new Uint8Array(this.#memory.buffer, pointer, bytes.byteLength).set(source);
      return use(pointer);
    });
  }

  /** A copy of bytes of the module. */
  copyOut(pointer: number, byteCount: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.#memory.buffer, pointer, byteCount).slice();
  }

  /** Copies rows of the module's bytes, `stride` apart, to `to` from its byte `at` on, one after another. */
  copyRows(pointer: number, stride: number, rowBytes: number, rowCount: number, to: Uint8Array, at: number): void {
    const rows = new Uint8Array(this.#memory.buffer, pointer, (rowCount - 1) * stride + rowBytes);
    if (rowBytes === stride) {
      to.set(rows, at);
      return;
    }
    for (let row = 0; row < rowCount; row++) {
      to.set(rows.subarray(row * stride, row * stride + rowBytes), at + row * rowBytes);
    }
  }

  /** Lets `fill` write `byteCount` bytes into the module, and returns a copy of them. */
  collect(byteCount: number, fill: (pointer: number) => void): Uint8Array<ArrayBuffer> {
    return this.withMemory(byteCount, (pointer) => {
      fill(pointer);
      return this.copyOut(pointer, byteCount);
    });
  }

  /** Lets `fill` write one 32-bit number into the module, and returns it. */
  collectU32(fill: (pointer: number) => void): number {
    return this.withMemory(4, (pointer) => {
      fill(pointer);
      return new DataView(this.#memory.buffer).getUint32(pointer, true);
    });
  }

  /** Lets `fill` write a struct into the module, and reads it. */
  collectStruct<Fields extends StructFields>(
    layout: StructLayout<Fields>,
    fill: (pointer: number) => void,
  ): StructValue<Fields> {
    return this.withMemory(layout.byteSize, (pointer) => {
      fill(pointer);
      return this.readStructAt(layout, pointer);
    });
  }

  readStructAt<Fields extends StructFields>(layout: StructLayout<Fields>, pointer: number): StructValue<Fields> {
    return readStruct(layout, new DataView(this.#memory.buffer), pointer);
  }

  /** Lends a struct: the ABI's defaults by `makeDefault`, then the given fields over them. */
  withStruct<Fields extends StructFields, Result>(
    layout: StructLayout<Fields>,
    makeDefault: CoreFunction,
    value: Partial<StructValue<Fields>>,
    use: (pointer: number) => Result,
  ): Result {
    return this.withMemory(layout.byteSize, (pointer) => {
      this.call(makeDefault, pointer);
      writeStruct(layout, new DataView(this.#memory.buffer), pointer, value);
      return use(pointer);
    });
  }

  /** A zero-terminated UTF-8 string of the module; "" for null. */
  readText(pointer: number): string {
    if (pointer === 0) return "";
    const bytes = new Uint8Array(this.#memory.buffer);
    const end = bytes.indexOf(0, pointer);
    return new TextDecoder().decode(bytes.slice(pointer, end < 0 ? bytes.length : end));
  }
}

function notACore(missing: string): TexelcastError {
  return new TexelcastError("unsupported", `The WebAssembly given is not Texelcast's engine: it lacks ${missing}.`, {
    field: missing,
    hint: SAME_RELEASE,
  });
}

/** "The size is wrong: width is 0." out of a message and a detail, either with or without its own capitals and stop. */
function sentence(message: string, detail: string): string {
  const whole = detail === "" ? message : `${message}: ${detail}`;
  const capital = whole.charAt(0).toUpperCase() + whole.slice(1);
  return /[.!?]$/.test(capital) ? capital : `${capital}.`;
}
