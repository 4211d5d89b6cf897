/** Files as a user hands them over: chosen in a dialog, or dropped as files and folders. Paths use "/" and are relative. */

export interface CollectedFile {
  /** Path inside the drop ("shoe/textures/sole.png"), the plain name for single files. */
  readonly path: string;
  readonly file: File;
}

/** More than any honest model has; a dropped home folder must not be read to its end. */
const MAX_FILES = 2000;

export function collectInput(list: FileList | readonly File[] | null): CollectedFile[] {
  return [...(list ?? [])].slice(0, MAX_FILES).map((file) => ({ path: file.webkitRelativePath || file.name, file }));
}

/** Folders are read to their ends. Must be called before the drop event's handler returns: the transfer is emptied then. */
export function collectDrop(transfer: DataTransfer): Promise<CollectedFile[]> {
  const entries = [...transfer.items]
    .filter((item) => item.kind === "file")
    .map((item) => {
      const entry = item.webkitGetAsEntry?.();
      // Only a folder needs it: WebKit cannot read a file's where a script has made the drop, as tests do.
      return entry?.isDirectory ? entry : item.getAsFile();
    });
  return (async () => {
    const collected: CollectedFile[] = [];
    for (const entry of entries) {
      if (entry instanceof File) collected.push({ path: entry.name, file: entry });
      else if (entry) await readEntry(entry, collected);
    }
    return collected;
  })();
}

export function carriesFiles(transfer: DataTransfer | null): boolean {
  return transfer?.types.includes("Files") ?? false;
}

async function readEntry(entry: FileSystemEntry, into: CollectedFile[]): Promise<void> {
  if (into.length >= MAX_FILES || entry.name.startsWith(".")) return;
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    into.push({ path: entry.fullPath.replace(/^\/+/, ""), file });
    return;
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  // A reader gives its entries in parts (a hundred at a time in Chromium) until it gives none.
  for (;;) {
    const part = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (part.length === 0) return;
    for (const child of part) await readEntry(child, into);
  }
}
