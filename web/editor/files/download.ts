/** Hands bytes to the browser's own downloads. */
export function download(name: string, type: string, content: Uint8Array | string): void {
  const url = URL.createObjectURL(new Blob([content as BlobPart], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  // The download has taken hold of the bytes by the next turn in every browser; a minute is safe for slow disks.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}

/** "models/Shoe.glb" gives "Shoe"; characters that a file system refuses become "-". */
export function fileStem(name: string): string {
  const base = name.slice(name.lastIndexOf("/") + 1);
  return base.replace(/(\.design)?\.[^.]+$/, "").replace(/[\\/:*?"<>|]+/g, "-") || "texelcast";
}

/** A name as a file may have it before its ending: characters that a file system refuses become "-". */
export function fileNameOf(name: string): string {
  return name.replace(/[\\/:*?"<>|]+/g, "-").replace(/^\s+|[.\s]+$/g, "") || "texelcast";
}
