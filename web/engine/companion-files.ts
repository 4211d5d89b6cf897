/** Files that came together: one names another by a relative address. */

/**
 * The file that a relative address means: by its path beside `base`, else (files dropped without their folders) the
 * only one of that name, or of that name but for capitals, which Windows does not tell apart.
 */
export function findCompanion<File extends { readonly path: string }>(
  address: string,
  base: string,
  files: readonly File[],
): File | undefined {
  // Exporters on Windows write backslashes.
  const wanted = decodeAddress(address).replaceAll("\\", "/").replace(/^\.\//, "");
  const folder = base.slice(0, base.lastIndexOf("/") + 1);
  const exact = files.find(({ path }) => composed(path) === composed(folder + wanted));
  if (exact) return exact;
  const name = composed(nameOf(wanted));
  const named = files.filter(({ path }) => composed(nameOf(path)) === name);
  const alike =
    named.length > 0 ? named : files.filter(({ path }) => composed(nameOf(path)).toLowerCase() === name.toLowerCase());
  return alike.length === 1 ? alike[0] : undefined;
}

/** Macs pack "ü" as a "u" and its dots, which the model that names the file has as one letter. */
const composed = (path: string): string => path.normalize("NFC");

/** The last part of a path or an address. */
export const nameOf = (path: string): string => path.slice(path.lastIndexOf("/") + 1);

/** An address as a person would write the file's name; as it stands where a stray "%" is no encoding. */
export function decodeAddress(address: string): string {
  try {
    return decodeURIComponent(address);
  } catch {
    return address;
  }
}
