import { readFileSync } from "node:fs";
import { describe, expect, it, vi } from "vitest";
import { ABI_VERSION, CORE_FUNCTIONS } from "../../web/core/abi.ts";
import { Session } from "../../web/core/session.ts";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { makeImports } from "../../web/core/wasm-imports.ts";
import { CoreModule, loadCore } from "../../web/core/wasm-module.ts";

const address = new URL("../../build/wasm/texelcast.wasm", import.meta.url);

/** A core whose functions are JavaScript: everything answers 0 unless `functions` says otherwise. */
function fakeCore(functions: Record<string, unknown>): CoreModule {
  const exports: Record<string, unknown> = { memory: new WebAssembly.Memory({ initial: 1 }) };
  for (const name of Object.keys(CORE_FUNCTIONS)) exports[name] = () => 0;
  Object.assign(exports, { txc_abi_version: () => ABI_VERSION, ...functions });
  return new CoreModule({ exports } as unknown as WebAssembly.Instance, { memory: null });
}

/** The bytes of a module that does nothing but import functions. */
function moduleThatImports(...names: readonly (readonly [module: string, name: string])[]): WebAssembly.Module {
  const text = (value: string): number[] => [value.length, ...new TextEncoder().encode(value)];
  const imports = names.flatMap(([module, name]) => [...text(module), ...text(name), 0, 0]);
  const section = [names.length, ...imports];
  const bytes = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 4, 1, 0x60, 0, 0, 2, section.length, ...section];
  return new WebAssembly.Module(Uint8Array.from(bytes));
}

describe("loading the core", () => {
  it("works from an address, from bytes and from a compiled module", async () => {
    const bytes = readFileSync(address);
    for (const source of [undefined, address, address.href, bytes, await WebAssembly.compile(bytes)]) {
      const core = await loadCore(source);
      expect(core.statusNames).toContain("NO_UVS");
    }
  });

  it("names the address that cannot be read, and says to look at it", async () => {
    const missing = new URL("no-such.wasm", address);
    const told = { code: "missing-file", subject: missing.href, hint: expect.stringContaining("address") };
    await expect(loadCore(missing)).rejects.toMatchObject(told);
  });

  it("refuses bytes that are no WebAssembly, as a server's page for what it does not have", async () => {
    const page = new TextEncoder().encode("<!doctype html><title>Not found</title>");
    await expect(loadCore(page)).rejects.toMatchObject({ code: "unsupported" });
    const address = `data:text/html,${encodeURIComponent("<!doctype html>")}`;
    const told = { code: "unsupported", subject: address, hint: expect.stringContaining("address") };
    await expect(loadCore(address)).rejects.toMatchObject(told);
  });

  it("says so where the machine has no memory for it, which no other browser would mend", async () => {
    const core = await WebAssembly.compile(readFileSync(address));
    const { instantiate } = WebAssembly;
    let fault: Error;
    // Node starts WebAssembly of its own meanwhile.
    const spy = vi.spyOn(WebAssembly, "instantiate").mockImplementation((async (
      module: WebAssembly.Module,
      imports: WebAssembly.Imports,
    ) => {
      if (module === core) throw fault;
      return await instantiate(module, imports);
    }) as unknown as typeof instantiate);
    fault = new RangeError("WebAssembly.instantiate(): Out of memory: Cannot allocate Wasm memory for new instance");
    const told = { code: "out-of-budget", hint: expect.stringContaining("Close other"), cause: fault };
    await expect(loadCore(core)).rejects.toMatchObject(told);
    fault = new WebAssembly.LinkError("import 1");
    const strange = { code: "unsupported", reason: "no-engine", hint: expect.stringContaining("SIMD") };
    await expect(loadCore(core)).rejects.toMatchObject(strange);
    spy.mockRestore();
  });

  it("refuses a WebAssembly module that is not the core, naming what it lacks", async () => {
    const empty = new WebAssembly.Module(Uint8Array.from([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]));
    await expect(loadCore(empty)).rejects.toMatchObject({ code: "unsupported", field: "memory" });
  });

  it("refuses a core of another ABI version", () => {
    expect(() => fakeCore({ txc_abi_version: () => ABI_VERSION + 1 })).toThrow(
      new RegExp(`ABI version ${ABI_VERSION + 1}.*needs version ${ABI_VERSION}`),
    );
  });

  it("refuses a module that asks for an import which no stub serves", () => {
    const module = moduleThatImports(["wasi_snapshot_preview1", "fd_write"], ["env", "open_the_door"]);
    expect(() => makeImports(module, { memory: null })).toThrow(/env\.open_the_door/);
  });

  it("gives a module the imports that it asks for, and no others", () => {
    const module = moduleThatImports(
      ["wasi_snapshot_preview1", "fd_close"],
      ["env", "emscripten_notify_memory_growth"],
    );
    const imports = makeImports(module, { memory: null });
    expect(Object.keys(imports)).toEqual(["wasi_snapshot_preview1", "env"]);
    expect(Object.keys(imports.env ?? {})).toEqual(["emscripten_notify_memory_growth"]);
  });

  it("shows what the module prints as console errors, line by line", () => {
    const memory = new WebAssembly.Memory({ initial: 1 });
    const imports = makeImports(moduleThatImports(["wasi_snapshot_preview1", "fd_write"]), { memory });
    const write = imports.wasi_snapshot_preview1?.fd_write as (...args: number[]) => number;
    const shown = vi.spyOn(console, "error").mockImplementation(() => undefined);
    const text = new TextEncoder().encode("first\nsecond");
    new Uint8Array(memory.buffer).set(text, 64);
    new Uint32Array(memory.buffer).set([64, text.length, 0], 0);
    expect(write(2, 0, 1, 8)).toBe(0);
    expect(new Uint32Array(memory.buffer)[2]).toBe(text.length);
    expect(shown.mock.calls).toEqual([["texelcast core: first"]]);
    shown.mockRestore();
  });
});

describe("a core that traps", () => {
  it("throws engine-crashed, and refuses every further call", async () => {
    const core = await loadCore();
    const session = Session.create(core);
    expect(() => core.call("txc_session_def_default", 0xfffffff0)).toThrow(TexelcastError);
    expect(core.crashed).toBe(true);
    expect(() => session.stats()).toThrow(expect.objectContaining({ code: "engine-crashed" }));
    expect(() => core.call("txc_abi_version")).toThrow(expect.objectContaining({ code: "engine-crashed" }));
  });

  it("does not touch the core again to free what a call had borrowed", () => {
    const freed = vi.fn();
    const trap = (): never => {
      throw new WebAssembly.RuntimeError("unreachable");
    };
    const core = fakeCore({ txc_alloc: () => 64, txc_free: freed, txc_session_stats: trap });
    expect(() => core.collect(4, (pointer) => core.call("txc_session_stats", 1, pointer))).toThrow(/unreachable/);
    expect(freed).not.toHaveBeenCalled();
  });
});

describe("memory inside the core", () => {
  it("gives out-of-budget when there is none left", () => {
    const core = fakeCore({ txc_alloc: () => 0 });
    expect(() => core.withMemory(2 ** 20, () => 0)).toThrow(expect.objectContaining({ code: "out-of-budget" }));
  });

  it("gives out-of-budget for more than 32 bits can address, without asking the core", () => {
    const core = fakeCore({ txc_alloc: (bytes: number) => (bytes < 100 ? 64 : 0) });
    expect(() => core.withMemory(2 ** 32 + 4, () => 0)).toThrow(expect.objectContaining({ code: "out-of-budget" }));
  });
});
