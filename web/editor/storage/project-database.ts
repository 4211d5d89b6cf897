/** The browser's database of projects: its tables, and how it is opened. */

import { type DBSchema, type IDBPDatabase, openDB } from "idb";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";
import type { ProjectSummary, StoredModel } from "./project.ts";
import { StorageSilence } from "./storage-error.ts";

const NAME = "texelcast";
const VERSION = 1;
/** Some browsers never answer where they do not like to keep data. The page must not wait for them. */
const PATIENCE = 5_000;

export interface ProjectRow extends ProjectSummary {
  /** The revision before the newest: kept until the one after the newest is safe. */
  readonly previous: number | null;
  /** When it was deleted, milliseconds since 1970; it can be brought back until it is swept. */
  readonly deleted: number | null;
  /** When it was last opened, or come back to, milliseconds since 1970; rows of older pages lack it. */
  readonly opened?: number;
}

/** One save. Rows are written once and never changed. */
export interface RevisionRow {
  readonly project: string;
  readonly revision: number;
  /** JSON text whose pictures are named `sha256/HEX`. */
  readonly design: string;
  readonly model: StoredModel;
  readonly targets: readonly {
    readonly material: number;
    readonly size: number | null;
    readonly gutter: number | null;
  }[];
  /** Names of everything of `blobs` that it needs. */
  readonly blobs: readonly string[];
}

export interface BlobRow {
  readonly hash: string;
  readonly bytes: Uint8Array;
}

export interface ProjectSchema extends DBSchema {
  projects: { key: string; value: ProjectRow };
  revisions: { key: [string, number]; value: RevisionRow; indexes: { blobs: string } };
  blobs: { key: string; value: BlobRow };
}

export type ProjectDatabase = IDBPDatabase<ProjectSchema>;

/** Opens the database, and again after the browser has closed it. */
export class ProjectConnection {
  readonly #strings: Strings;
  #opening: Promise<ProjectDatabase> | null = null;

  constructor(strings: Strings) {
    this.#strings = strings;
  }

  open(): Promise<ProjectDatabase> {
    if (this.#opening) return this.#opening;
    // One that says late that it was closed is not the one that was opened since.
    const opening: Promise<ProjectDatabase> = this.#open(() => this.#forget(opening));
    this.#opening = opening;
    // The next wish tries anew.
    opening.catch(() => this.#forget(opening));
    return opening;
  }

  close(): void {
    void this.#opening?.then((database) => database.close()).catch(() => undefined);
    this.#opening = null;
  }

  async #open(terminated: () => void): Promise<ProjectDatabase> {
    if (typeof indexedDB === "undefined") throw new ToldError("storage-refused", this.#strings.storage.none);
    const opened = openDB<ProjectSchema>(NAME, VERSION, {
      upgrade(database) {
        database.createObjectStore("projects", { keyPath: "id" });
        const revisions = database.createObjectStore("revisions", { keyPath: ["project", "revision"] });
        revisions.createIndex("blobs", "blobs", { multiEntry: true });
        database.createObjectStore("blobs", { keyPath: "hash" });
      },
      // A newer page in another tab wants to change the tables: it goes first, this one opens again later.
      blocking: () => this.close(),
      terminated,
    });
    let timer: ReturnType<typeof setTimeout> | undefined;
    const patience = new Promise<never>((_, reject) => {
      timer = setTimeout(() => {
        // One that comes too late is nobody's.
        opened.then((database) => database.close()).catch(() => undefined);
        reject(new StorageSilence(this.#strings.storage.silent, opened));
      }, PATIENCE);
    });
    try {
      return await Promise.race([opened, patience]);
    } finally {
      clearTimeout(timer);
    }
  }

  #forget(opening: Promise<ProjectDatabase>): void {
    if (this.#opening === opening) this.#opening = null;
  }
}
