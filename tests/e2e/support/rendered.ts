/** The command line's picture of what a page has saved: the bytes that a page's own export must equal. */
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";

const COMMAND_LINE = fileURLToPath(new URL("../../../scripts/texelcast.mjs", import.meta.url));

interface SavedFile {
  readonly name: string;
  readonly bytes: Buffer;
}

/** The PNG of `texelcast render` with these files as its arguments, in a folder that holds nothing else. */
export const rendered = (...files: readonly SavedFile[]): Buffer => renderedAs("rendered.png", files);

/** The same under a name whose ending says what it is. */
export function renderedAs(out: string, files: readonly SavedFile[], options: readonly string[] = []): Buffer {
  const folder = mkdtempSync(path.join(tmpdir(), "texelcast-e2e-"));
  try {
    for (const { name, bytes } of files) writeFileSync(path.join(folder, name), bytes);
    const names = files.map(({ name }) => name);
    execFileSync(process.execPath, [COMMAND_LINE, "render", ...names, "--out", out, ...options], {
      cwd: folder,
      // npm names its own folder there, which the tool would go to.
      env: { ...process.env, INIT_CWD: folder },
    });
    return readFileSync(path.join(folder, out));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
