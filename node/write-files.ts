/** Writing results so that no reader, and no interruption, ever meets half a file. */
import { randomUUID } from "node:crypto";
import { closeSync, constants, openSync, renameSync, rmSync } from "node:fs";
import { access, type FileHandle, lstat, open, readlink, realpath, stat } from "node:fs/promises";
import path from "node:path";
import { TexelcastError } from "../web/core/texelcast-error.ts";
import { makeFolder } from "./make-folder.ts";
import { systemReason } from "./system-reason.ts";

const SIGNALS = ["SIGINT", "SIGTERM", "SIGHUP"] as const;
/** Who may read, write and run a file. */
const PERMISSIONS = 0o777;

export interface PendingFile {
  append(bytes: Uint8Array): Promise<void>;
}

interface Pending {
  readonly temporary: string;
  /** What the name leads to. */
  readonly place: string;
  file?: FileHandle;
}

/**
 * Files that appear under their names together, at `commit`, or not at all. Until then each is written beside its
 * place, where a rename is one step of the file system.
 */
export class PendingFiles {
  /** By the names that were asked for. */
  readonly #pending = new Map<string, Pending>();

  /** Ctrl-C, kill and a terminal that is closed must not leave what is half written; at any other time the system's own way of ending is fine. */
  readonly #onSignal = (signal: NodeJS.Signals): void => {
    this.#removeTemporaries();
    this.#release();
    process.kill(process.pid, signal);
  };

  /** Opens a file for writing; its folder is made where there is none. */
  async create(target: string): Promise<PendingFile> {
    const file = await writing(target, async () => {
      if (this.#pending.size === 0) for (const signal of SIGNALS) process.on(signal, this.#onSignal);
      const place = await placeOf(target);
      const folder = path.dirname(place);
      await makeFolder(folder).catch((cause: unknown) => {
        throw cannotWrite(target, `its folder cannot be made: ${systemReason(cause)}`, cause);
      });
      // Not by `path.join`, to which a link's folder and a way up are none.
      const temporary = `${folder}${path.sep}.texelcast-${randomUUID()}.tmp`;
      // Made and listed in one go: a signal between the two would leave it behind.
      const pending: Pending = { temporary, place };
      closeSync(openSync(temporary, "wx"));
      this.#pending.set(target, pending);
      // Not made anew, as "a" would, where a signal has taken it away meanwhile.
      pending.file = await open(temporary, constants.O_WRONLY | constants.O_APPEND);
      // Before a byte is in it: what nobody else might read must not become readable by being written anew.
      await keepMode(pending.file, target);
      return pending.file;
    });
    return { append: (bytes) => writing(target, () => file.appendFile(bytes)) };
  }

  /** Writes a whole file. */
  async write(target: string, bytes: Uint8Array): Promise<void> {
    await (await this.create(target)).append(bytes);
  }

  async commit(): Promise<void> {
    for (const [target, { file }] of this.#pending) await writing(target, async () => file?.close());
    // In one go: a signal between two of them would leave some of the files new and some of them old.
    for (const [target, { temporary, place }] of this.#pending) {
      renaming(target, () => renameSync(temporary, place));
      this.#pending.delete(target);
    }
    this.#release();
  }

  /** Removes what was not committed. Does nothing after a commit that succeeded. */
  async discard(): Promise<void> {
    for (const { file } of this.#pending.values()) await file?.close().catch(() => {});
    this.#removeTemporaries();
    this.#release();
  }

  #removeTemporaries(): void {
    for (const { temporary } of this.#pending.values()) rmSync(temporary, { force: true });
    this.#pending.clear();
  }

  #release(): void {
    for (const signal of SIGNALS) process.removeListener(signal, this.#onSignal);
  }
}

/**
 * Tells of an output that cannot be before the work is done that would be lost.
 *
 * @param inputs what the command reads: painted once more, a model or picture that was overwritten would be painted twice
 * @throws TexelcastError "cannot-write" where something that is no file stands in the file's place, or a file in that of its folder,
 * or one of the two may not be written to; "bad-argument" where the file is one of the inputs, by whatever name.
 */
export async function checkOutputFile(target: string, inputs: readonly string[] = []): Promise<void> {
  const place = await writing(target, () => placeOf(target));
  await checkFolderOf(target, place);
  const found = await stat(target).catch((cause: NodeJS.ErrnoException) => {
    if (cause.code === "ENAMETOOLONG") throw cannotWrite(target, "its name is too long", cause);
    return null;
  });
  if (found === null) return;
  for (const input of inputs) {
    const read = await stat(input).catch(() => null);
    if (read?.dev !== found.dev || read.ino !== found.ino) continue;
    const why = `--out: ${JSON.stringify(target)} is read by this command, and would be lost`;
    throw new TexelcastError("bad-argument", why, { field: "out", value: target, hint: "Give --out another name." });
  }
  if (found.isFile()) {
    // Its folder would let another file take its place; whoever protected it did so from that, too.
    await access(place, constants.W_OK).catch((cause: unknown) => {
      throw cannotWrite(
        target,
        `there is a file of that name that may not be written to: ${systemReason(cause)}`,
        cause,
      );
    });
    return;
  }
  if (found.isDirectory()) throw cannotWrite(target, "there is a folder of that name");
  throw cannotWrite(target, "it is a pipe or a device, and a result takes the place of what has its name");
}

/** That the file's folder is there or can be made, as far as the folders above it tell. */
async function checkFolderOf(target: string, place: string): Promise<void> {
  for (let folder = path.dirname(place); ; folder = path.dirname(folder)) {
    const found = await stat(folder).catch(() => null);
    if (found !== null && !found.isDirectory()) {
      throw cannotWrite(target, `${JSON.stringify(folder)} is a file, not a folder`);
    }
    if (found !== null) {
      await access(folder, constants.W_OK).catch((cause: unknown) => {
        throw cannotWrite(target, `the folder ${JSON.stringify(folder)} takes no files: ${systemReason(cause)}`, cause);
      });
    }
    if (found !== null || folder === path.dirname(folder)) return;
  }
}

/** Where what is written under a name comes to lie: a link stays, and the file that it leads to is written, there already or not. */
async function placeOf(target: string): Promise<string> {
  try {
    if (!(await lstat(target)).isSymbolicLink()) return target;
    return await realpath(target);
  } catch (cause) {
    // A ring of links leads nowhere, and is told.
    if ((cause as NodeJS.ErrnoException).code === "ELOOP") throw cause;
  }
  const next = await readlink(target).catch(() => null);
  if (next === null) return target;
  // Not by `path.join`, as above.
  return placeOf(path.isAbsolute(next) ? next : `${path.dirname(target)}${path.sep}${next}`);
}

/** Gives a file that takes another's place the owner, group and permissions of that one, as far as the system lets it. */
async function keepMode(file: FileHandle, target: string): Promise<void> {
  const replaced = await stat(target).catch(() => null);
  if (!replaced?.isFile()) return;
  // Only the superuser gives files away; a group that one is in, everybody may give them to.
  await file.chown(replaced.uid, replaced.gid).catch(() => file.chown(-1, replaced.gid).catch(() => {}));
  // Some file systems know no permissions.
  await file.chmod(replaced.mode & PERMISSIONS).catch(() => {});
}

async function writing<Result>(target: string, action: () => Promise<Result>): Promise<Result> {
  try {
    return await action();
  } catch (cause) {
    if (cause instanceof TexelcastError) throw cause;
    throw cannotWrite(target, systemReason(cause), cause);
  }
}

function renaming(target: string, action: () => void): void {
  try {
    action();
  } catch (cause) {
    throw cannotWrite(target, systemReason(cause), cause);
  }
}

function cannotWrite(target: string, why: string, cause?: unknown): TexelcastError {
  return new TexelcastError("cannot-write", `cannot be written: ${why}`, {
    subject: target,
    hint: "Give --out another place, or make room there.",
    cause,
  });
}
