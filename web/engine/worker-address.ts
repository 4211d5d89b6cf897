/** The worker's own address is another one than the page's, so a relative address must be made whole here. */
export function absoluteAddress(address: URL | string): string {
  return typeof location === "undefined" ? String(address) : new URL(address, location.href).href;
}
