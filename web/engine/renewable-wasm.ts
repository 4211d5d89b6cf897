/**
 * An instance of WebAssembly that can be replaced, for packages whose own code makes one and keeps it for good: once Rust has
 * panicked or its stack has overflown, what it held is never given back, and soon nothing works any more.
 */

/** Memory and functions by their names. */
type Exports = Record<string, WebAssembly.ExportValue>;

/**
 * Runs what makes an instance of the module and keeps its exports. Gives what replaces these by a new instance's; all that
 * the package holds of the old one is then void.
 *
 * @param run of one package: it is handed an object in place of the instance, and only while it runs
 */
export async function runRenewable(module: WebAssembly.Module, run: () => Promise<unknown>): Promise<() => void> {
  const { instantiate } = WebAssembly;
  let renew = (): void => {};
  const renewable = async (source: WebAssembly.Module, imports: WebAssembly.Imports): Promise<unknown> => {
    if (source !== module) return await instantiate(source, imports);
    const { ...exports }: Exports = (await instantiate(module, imports)).exports;
    renew = () => {
      const { memory } = exports;
      Object.assign(exports, new WebAssembly.Instance(module, imports).exports);
      // By this its buffer is detached, which tells the package to look for the new one.
      if (memory instanceof WebAssembly.Memory) memory.grow(0);
    };
    return { instance: { exports }, module };
  };
  // The packages have no other place to hand an instance in.
  Object.assign(WebAssembly, { instantiate: renewable });
  try {
    await run();
  } finally {
    Object.assign(WebAssembly, { instantiate });
  }
  return renew;
}
