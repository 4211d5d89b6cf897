/**
 * Projects kept in the browser. A save is one transaction that writes a new revision, points the project at it and
 * drops the one before the last: whatever ends it half-way, the save before stands. Every method rejects with a
 * TexelcastError: "storage-full" or "storage-refused" when the browser will not, else what is said there.
 */

import type { IDBPTransaction } from "idb";
import { TexelcastError } from "../../core/texelcast-error.ts";
import { countedName } from "../files/counted-name.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";
import { randomId } from "./content-hash.ts";
import type { LastWords } from "./last-words.ts";
import { type PackedProject, unpackDesign, unpackModel } from "./packed-project.ts";
import type { LoadedProject, ProjectSummary } from "./project.ts";
import {
  ProjectConnection,
  type ProjectDatabase,
  type ProjectRow,
  type ProjectSchema,
  type RevisionRow,
} from "./project-database.ts";
import { storageError } from "./storage-error.ts";

/** A deleted project can be brought back for this long, milliseconds. */
const SWEEP_AFTER = 10 * 60_000;

/**
 * What a database that the browser has closed ends with: what is asked after that, what was asked before, and
 * transactions. Chromium closes that of a page whose data is cleared some milliseconds before it says so.
 */
const OF_CLOSED: ReadonlySet<string> = new Set(["InvalidStateError", "AbortError", "UnknownError"]);

/** What is kept of a project that a tab comes back to. */
export type ProjectTouch = Pick<ProjectSummary, "name" | "revision">;

type Tables = ["projects", "revisions", "blobs"];
const TABLES: Tables = ["projects", "revisions", "blobs"];
type Transaction<Mode extends IDBTransactionMode> = IDBPTransaction<ProjectSchema, Tables, Mode>;
type Reading = Transaction<"readonly">;
type Writing = Transaction<"readwrite">;

export class ProjectStore {
  readonly #connection: ProjectConnection;
  readonly #strings: Strings;
  readonly #now: () => number;

  constructor(strings: Strings, now: () => number = Date.now) {
    this.#connection = new ProjectConnection(strings);
    this.#strings = strings;
    this.#now = now;
  }

  /** Newest first. */
  list(): Promise<ProjectSummary[]> {
    return this.#read(async (tables) => {
      const rows = await tables.objectStore("projects").getAll();
      return rows
        .filter(({ deleted }) => deleted === null)
        .sort((a, b) => b.modified - a.modified)
        .map(summaryOf);
    });
  }

  /** The project that was open or saved last, of which a new visit goes on. */
  newest(): Promise<ProjectSummary | null> {
    return this.#read(async (tables) => {
      const rows = (await tables.objectStore("projects").getAll()).filter(({ deleted }) => deleted === null);
      const [newest] = rows.sort((a, b) => lastSeen(b) - lastSeen(a));
      return newest ? summaryOf(newest) : null;
    });
  }

  /** Notes that a project is open again, without a change of it. Null for one that is not there, or deleted. */
  touch(id: string): Promise<ProjectTouch | null> {
    return this.#write(async (tables) => {
      const row = await tables.objectStore("projects").get(id);
      if (!row || row.deleted !== null) return null;
      await tables.objectStore("projects").put({ ...row, opened: await this.#afterAll(tables) });
      return { name: row.name, revision: row.revision };
    });
  }

  /**
   * Writes a revision and returns its number.
   *
   * @param seen the revision that the caller has; 0 for a new project.
   * @throws TexelcastError "storage-conflict" where somebody else (another tab) has saved another one since.
   */
  save(id: string, packed: PackedProject, seen: number): Promise<number> {
    return this.#write(async (tables) => {
      const projects = tables.objectStore("projects");
      const row = await projects.get(id);
      // A project that is gone was deleted elsewhere: saving brings it back, since somebody works on it.
      if (row && row.revision !== seen) {
        throw new ToldError("storage-conflict", this.#strings.storage.conflict(packed.name), {
          subject: packed.name,
        });
      }
      const { name, size, layers, model } = packed;
      const summary = { id, name, size, layers, modelTitle: model.title, thumbnail: row?.thumbnail ?? null };
      const revision = Math.max(seen, row?.revision ?? 0) + 1;
      const kept = row && (await tables.objectStore("revisions").get([id, row.revision]));
      await addBlobs(tables, packed.blobs, new Set(kept?.blobs));
      return this.#addRevision(tables, row, { ...summary, revision }, rowOf(packed));
    });
  }

  /**
   * Writes what a page that was left had not saved. Nothing happens, and false is returned, where it does not go on from what
   * is kept: the project was deleted, somebody else has saved it since, or a picture is missing.
   */
  amend(id: string, { revision: seen, name, design, targets, layers, pictures }: LastWords): Promise<boolean> {
    return this.#write(async (tables) => {
      const row = await tables.objectStore("projects").get(id);
      const kept = row && (await tables.objectStore("revisions").get([id, row.revision]));
      if (!kept || row.deleted !== null || !pictures.every((picture) => kept.blobs.includes(picture))) return false;
      // A save that was under way may have ended.
      if (row.revision !== seen && row.revision !== seen + 1) return false;
      const { thumbnail, modelTitle } = row;
      const size = row.size + design.length - kept.design.length;
      const summary = { id, name, size, layers, modelTitle, thumbnail, revision: row.revision + 1 };
      await this.#addRevision(tables, row, summary, { ...kept, design, targets });
      return true;
    });
  }

  /** Points a project at a new revision, whose number is returned, and drops the one before the last. */
  async #addRevision(
    tables: Writing,
    row: ProjectRow | undefined,
    summary: Omit<ProjectSummary, "modified">,
    content: Omit<RevisionRow, "project" | "revision">,
  ): Promise<number> {
    const { id, revision } = summary;
    await tables.objectStore("revisions").put({ ...content, project: id, revision });
    const previous = row?.revision ?? null;
    const opened = row === undefined ? await this.#afterAll(tables) : row.opened;
    const saved = { ...summary, modified: this.#now(), previous, deleted: null };
    await tables.objectStore("projects").put(opened === undefined ? saved : { ...saved, opened });
    if (row?.previous != null) await dropRevision(tables, id, row.previous, new Set(content.blobs));
    return revision;
  }

  /** Now; behind all that was open or saved before, where the clock was set back since. */
  async #afterAll(tables: Writing): Promise<number> {
    const rows = await tables.objectStore("projects").getAll();
    return Math.max(this.#now(), ...rows.map((row) => lastSeen(row) + 1));
  }

  /**
   * The project as it was saved last. Where that cannot be read (`fromBackup`), as it was saved before.
   *
   * @throws TexelcastError "missing-file" for a project that is not there, or the fault of its newest revision.
   */
  async load(id: string): Promise<LoadedProject> {
    const row = await this.#read((tables) => tables.objectStore("projects").get(id));
    if (!row || row.deleted !== null) {
      throw new ToldError("missing-file", this.#strings.storage.gone, { subject: row?.name ?? id });
    }
    // A row that cannot be read ends the transaction that asks for it. What was read is put together after it.
    const saved = async (revision: number) => {
      const read = await this.#read((tables) => readRevision(tables, row, revision, this.#strings));
      return unpackRevision(read, this.#strings).catch((thrown: unknown) => {
        if (thrown instanceof TexelcastError) throw thrown;
        throw new ToldError("missing-file", this.#strings.storage.unreadable(row.name), {
          subject: row.name,
          cause: thrown,
        });
      });
    };
    try {
      return { ...(await saved(row.revision)), fromBackup: false };
    } catch (fault) {
      if (row.previous === null) throw fault;
      const backup = await saved(row.previous).catch(() => {
        throw fault;
      });
      return { ...backup, fromBackup: true };
    }
  }

  /** The name, or with a number behind it where another project than `id` has it already. */
  freeName(name: string, id: string | null): Promise<string> {
    return this.#read(async (tables) => {
      const others = (await tables.objectStore("projects").getAll()).filter(
        (row) => row.deleted === null && row.id !== id,
      );
      return countedName(name, new Set(others.map((row) => row.name)));
    });
  }

  /** The name that a project has now; null for one that is not there, or deleted. */
  nameOf(id: string): Promise<string | null> {
    return this.#read(async (tables) => {
      const row = await tables.objectStore("projects").get(id);
      return row && row.deleted === null ? row.name : null;
    });
  }

  async rename(id: string, name: string): Promise<void> {
    await this.#patch(id, { name });
  }

  async setThumbnail(id: string, thumbnail: string): Promise<void> {
    await this.#patch(id, { thumbnail });
  }

  /**
   * It can be brought back by `restore` until it is swept. Where the browser's space is used up, not even a mark can be written:
   * then it goes at once, which makes room, and false is returned.
   */
  async remove(id: string): Promise<boolean> {
    try {
      await this.#patch(id, { deleted: this.#now() });
      return true;
    } catch (thrown) {
      if (!(thrown instanceof TexelcastError) || thrown.code !== "storage-full") throw thrown;
      await this.#write(async (tables) => {
        const row = await tables.objectStore("projects").get(id);
        if (row) await erase(tables, row);
      });
      return false;
    }
  }

  /** @throws TexelcastError "missing-file" for a project that was swept meanwhile. */
  async restore(id: string): Promise<void> {
    if (!(await this.#patch(id, { deleted: null }))) {
      throw new ToldError("missing-file", this.#strings.storage.gone, { subject: id });
    }
  }

  /** Makes a copy under another name; returns its id. */
  duplicate(id: string, name: string): Promise<string> {
    return this.#write(async (tables) => {
      const row = await tables.objectStore("projects").get(id);
      const revision = row && (await tables.objectStore("revisions").get([id, row.revision]));
      if (!revision) throw new ToldError("missing-file", this.#strings.storage.gone, { subject: name });
      const copy = randomId();
      await tables.objectStore("revisions").put({ ...revision, project: copy, revision: 1 });
      const copied = { ...row, id: copy, name, revision: 1, previous: null, deleted: null, modified: this.#now() };
      await tables.objectStore("projects").put(copied);
      return copy;
    });
  }

  /** Frees what was deleted long ago, by any tab, which may still offer to bring back what it has deleted since. */
  sweep(age = SWEEP_AFTER): Promise<void> {
    return this.#eraseDeleted((row) => this.#now() - (row.deleted ?? 0) >= age);
  }

  /** Frees those of them that are deleted. */
  sweepThese(ids: ReadonlySet<string>): Promise<void> {
    return this.#eraseDeleted(({ id }) => ids.has(id));
  }

  #eraseDeleted(goes: (row: ProjectRow) => boolean): Promise<void> {
    return this.#write(async (tables) => {
      for (const row of await tables.objectStore("projects").getAll()) {
        if (row.deleted !== null && goes(row)) await erase(tables, row);
      }
    });
  }

  close(): void {
    this.#connection.close();
  }

  /** False for a project that is not there. */
  #patch(id: string, patch: Partial<ProjectRow>): Promise<boolean> {
    return this.#write(async (tables) => {
      const row = await tables.objectStore("projects").get(id);
      if (row) await tables.objectStore("projects").put({ ...row, ...patch });
      return row !== undefined;
    });
  }

  #read<Result>(work: (tables: Reading) => Promise<Result>): Promise<Result> {
    return this.#within("readonly", work);
  }

  #write<Result>(work: (tables: Writing) => Promise<Result>): Promise<Result> {
    return this.#within("readwrite", work);
  }

  async #within<Mode extends "readonly" | "readwrite", Result>(
    mode: Mode,
    work: (tables: Transaction<Mode>) => Promise<Result>,
  ): Promise<Result> {
    try {
      return await this.#withDatabase((database) => transact(database.transaction(TABLES, mode), work));
    } catch (thrown) {
      throw storageError(thrown, this.#strings);
    }
  }

  /** A database that the browser closes, before or meanwhile, is opened once more. What was not ended is not written. */
  async #withDatabase<Result>(work: (database: ProjectDatabase) => Promise<Result>): Promise<Result> {
    try {
      return await work(await this.#connection.open());
    } catch (thrown) {
      if (!(thrown instanceof Error && OF_CLOSED.has(thrown.name))) throw thrown;
      this.#connection.close();
      return work(await this.#connection.open());
    }
  }
}

/** Resolves when all of the work is written, or rejects and nothing is. */
async function transact<Mode extends IDBTransactionMode, Result>(
  tables: Transaction<Mode>,
  work: (tables: Transaction<Mode>) => Promise<Result>,
): Promise<Result> {
  // Whoever aborts it knows the reason better than the transaction's own promise.
  const done = tables.done.catch((thrown: unknown) => ({ thrown }));
  let result: Result;
  try {
    result = await work(tables);
  } catch (thrown) {
    try {
      tables.abort();
    } catch {
      // It has ended by itself.
    }
    throw thrown;
  }
  const end = await done;
  if (end) throw end.thrown ?? new DOMException("The transaction was aborted.", "AbortError");
  return result;
}

function summaryOf({
  previous: _previous,
  deleted: _deleted,
  opened: _opened,
  ...summary
}: ProjectRow): ProjectSummary {
  return summary;
}

function lastSeen({ modified, opened = 0 }: ProjectRow): number {
  return Math.max(modified, opened);
}

function rowOf({ design, model, targets, blobs }: PackedProject): Omit<RevisionRow, "project" | "revision"> {
  return { design, model, targets, blobs: [...blobs.keys()] };
}

/** `known`: of those that are there. */
async function addBlobs(tables: Writing, blobs: PackedProject["blobs"], known: ReadonlySet<string>): Promise<void> {
  const store = tables.objectStore("blobs");
  for (const [hash, { bytes }] of blobs) {
    if (known.has(hash)) continue;
    if ((await store.getKey(hash)) === undefined) await store.put({ hash, bytes: bytes() });
  }
}

async function erase(tables: Writing, { id, revision, previous }: ProjectRow): Promise<void> {
  await tables.objectStore("projects").delete(id);
  for (const each of [revision, previous]) if (each !== null) await dropRevision(tables, id, each);
}

/** Its blobs go with it, unless another revision needs them; `needed`: of those that one does. */
async function dropRevision(
  tables: Writing,
  project: string,
  revision: number,
  needed: ReadonlySet<string> = new Set(),
): Promise<void> {
  const revisions = tables.objectStore("revisions");
  const row = await revisions.get([project, revision]);
  await revisions.delete([project, revision]);
  for (const hash of row?.blobs ?? []) {
    if (needed.has(hash)) continue;
    if ((await revisions.index("blobs").getKey(hash)) === undefined) await tables.objectStore("blobs").delete(hash);
  }
}

interface ReadRevision {
  readonly row: ProjectRow;
  readonly revision: RevisionRow;
  readonly blobs: ReadonlyMap<string, Uint8Array>;
}

async function readRevision(tables: Reading, row: ProjectRow, number: number, strings: Strings): Promise<ReadRevision> {
  const revision = await tables.objectStore("revisions").get([row.id, number]);
  if (!revision) {
    throw new ToldError("missing-file", strings.storage.unreadable(row.name), { subject: row.name });
  }
  const blobs = new Map<string, Uint8Array>();
  for (const hash of revision.blobs) {
    const blob = await tables.objectStore("blobs").get(hash);
    if (blob) blobs.set(hash, blob.bytes);
  }
  return { row, revision, blobs };
}

async function unpackRevision(
  { row, revision: { design, model, targets }, blobs }: ReadRevision,
  strings: Strings,
): Promise<Omit<LoadedProject, "fromBackup">> {
  const bytesOf = (hash: string): Uint8Array | undefined => blobs.get(hash);
  return {
    summary: summaryOf(row),
    design: await unpackDesign(design, row.name, bytesOf, strings),
    model: model.kind === "demo" ? model : unpackModel(model, row.name, bytesOf, strings),
    targets: new Map(targets.map(({ material, size, gutter }) => [material, { size, gutter }])),
  };
}
