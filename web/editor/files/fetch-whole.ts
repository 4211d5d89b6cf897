/** The bytes at an address; undefined where no answer comes, one that refuses, or one that breaks off on its way. */
export async function fetchWhole(address: URL): Promise<Uint8Array | undefined> {
  try {
    const response = await fetch(address);
    if (response.ok) return new Uint8Array(await response.arrayBuffer());
  } catch {
    // Browsers say no more of it than that.
  }
  return undefined;
}
