/** An address, or null where it is none. (`URL.canParse` and `URL.parse` are younger than browsers that customers still have.) */
export function parseUrl(address: string | URL, base?: string | URL): URL | null {
  try {
    return new URL(address, base);
  } catch {
    return null;
  }
}
