/**
 * Files by their SHA-256: a file's name is what its bytes say, so equal files are stored once, none can be replaced by
 * another, and no name from outside ever becomes a path.
 */
import { createHash, randomUUID } from "node:crypto";
import { mkdir, readdir, readFile, rename, rm, stat, utimes, writeFile } from "node:fs/promises";
import path from "node:path";
import type { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { Sha256 } from "../../web/storefront/api/shop-api.ts";
import { notFound, shopError } from "./shop-error.ts";

const HASH = /^[0-9a-f]{64}$/;
/** What a disk says that is full, or whose share for the server is used up. */
const NO_ROOM: ReadonlySet<string> = new Set(["ENOSPC", "EDQUOT"]);

/** 64 digits in lower case, as the store writes them. */
export const isSha256 = (value: string): boolean => HASH.test(value);
/** The name under which the store keeps these bytes. */
export const sha256Of = (bytes: Uint8Array): Sha256 => createHash("sha256").update(bytes).digest("hex");

export class AssetStore {
  readonly #folder: string;
  readonly #mostBytes: number;
  #storedBytes: number;
  /** What is being stored: bytes that come twice at once are written and counted once. */
  readonly #coming = new Map<Sha256, Promise<void>>();

  private constructor(folder: string, mostBytes: number, storedBytes: number) {
    this.#folder = folder;
    this.#mostBytes = mostBytes;
    this.#storedBytes = storedBytes;
  }

  /** @param mostBytes of all files together */
  static async open(folder: string, mostBytes: number): Promise<AssetStore> {
    await mkdir(folder, { recursive: true });
    let bytes = 0;
    for (const entry of await readdir(folder, { withFileTypes: true, recursive: true })) {
      const file = path.join(entry.parentPath, entry.name);
      if (!entry.isFile()) continue;
      // Left by a server that ended while it wrote.
      if (!isSha256(entry.name)) await rm(file, { force: true });
      else bytes += (await stat(file)).size;
    }
    return new AssetStore(folder, mostBytes, bytes);
  }

  /**
   * Keeps the bytes, once.
   *
   * @throws TexelcastError "storage-full".
   */
  async put(bytes: Uint8Array): Promise<Sha256> {
    const hash = sha256Of(bytes);
    let coming = this.#coming.get(hash);
    if (coming === undefined) {
      coming = this.#keep(hash, bytes).finally(() => this.#coming.delete(hash));
      this.#coming.set(hash, coming);
    }
    await coming;
    return hash;
  }

  async #keep(hash: Sha256, bytes: Uint8Array): Promise<void> {
    const file = this.#fileOf(hash);
    const there = await readFile(file).catch(() => null);
    // One that the disk has damaged is replaced.
    if (there !== null && sha256Of(there) === hash) return await this.#touch(hash);
    const more = there === null ? bytes.length : 0;
    if (this.#storedBytes + more > this.#mostBytes) throw noRoom();
    // Before it is written: others that come meanwhile must not be promised the same room.
    this.#storedBytes += more;
    // Whole or not at all: a reader never meets half a file.
    const draft = `${file}.${randomUUID()}`;
    try {
      await mkdir(path.dirname(file), { recursive: true });
      await writeFile(draft, bytes, { flag: "wx" });
      await rename(draft, file);
    } catch (error) {
      this.#storedBytes -= more;
      await rm(draft, { force: true });
      throw NO_ROOM.has((error as NodeJS.ErrnoException).code ?? "") ? noRoom(error) : error;
    }
  }

  async has(hash: Sha256): Promise<boolean> {
    if (!isSha256(hash)) return false;
    return stat(this.#fileOf(hash)).then(
      (found) => found.isFile(),
      () => false,
    );
  }

  /**
   * The bytes, checked against their name: a damaged disk must not reach the printer.
   *
   * @throws TexelcastError "not-found", "hash-mismatch".
   */
  async read(hash: Sha256): Promise<Uint8Array> {
    if (!isSha256(hash)) throw notFound("file", hash);
    const bytes = await readFile(this.#fileOf(hash)).catch(() => null);
    if (bytes === null) throw notFound("file", hash);
    if (sha256Of(bytes) !== hash) {
      throw shopError("hash-mismatch", "a stored file is damaged", { subject: hash, hint: "Send the file again." });
    }
    await this.#touch(hash);
    return bytes;
  }

  /**
   * Takes away the files that nothing names, and that nobody stored or read since then (milliseconds, -Infinity for none): what is on its way into a cart is
   * younger.
   *
   * @returns how many
   */
  async removeUnused(used: ReadonlySet<Sha256>, since: number): Promise<number> {
    let removed = 0;
    for (const entry of await readdir(this.#folder, { withFileTypes: true, recursive: true })) {
      if (!entry.isFile() || !isSha256(entry.name) || used.has(entry.name)) continue;
      const file = this.#fileOf(entry.name);
      const { size, mtimeMs } = await stat(file);
      if (mtimeMs >= since) continue;
      await rm(file);
      this.#storedBytes -= size;
      removed += 1;
    }
    return removed;
  }

  /** It is in use: its time is now. Where the disk takes nothing more, nothing is taken away from it either. */
  async #touch(hash: Sha256): Promise<void> {
    const now = new Date();
    await utimes(this.#fileOf(hash), now, now).catch((error: NodeJS.ErrnoException) => {
      if (error.code === "ENOENT") throw error;
    });
  }

  #fileOf(hash: Sha256): string {
    return path.join(this.#folder, hash.slice(0, 2), hash);
  }
}

/** @param cause of a disk that was full before the shop's own limit */
const noRoom = (cause?: unknown): TexelcastError =>
  shopError("storage-full", "the shop has no room for more files", {
    hint: "Try again later.",
    ...(cause !== undefined && { cause }),
  });
