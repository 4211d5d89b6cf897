/**
 * One server at a time on one database. SQLite's own lock here is a folder (`node-sqlite3-wasm` makes it), which outlives a
 * server that is killed while it writes, and then refuses every later one. So a server first says who it is in a file of its
 * own: what that file's process, if it lives no more, left locked may be taken away.
 *
 * Of a process in another container, or on another machine that has the folder too, nobody here can tell whether it lives. So
 * a server writes its claim anew every few seconds, and one from elsewhere holds until it has been silent for some more.
 */
import { randomUUID } from "node:crypto";
import {
  closeSync,
  linkSync,
  openSync,
  readFileSync,
  readlinkSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
  writeSync,
} from "node:fs";
import { hostname } from "node:os";
import { TexelcastError } from "../../web/core/texelcast-error.ts";

/** In the place of what the system does not tell. */
const UNKNOWN = "-";

/** Of this process: its own id in a file may also be that of an earlier one, as in a container where every server is 1. */
const held = new Set<string>();

/** Milliseconds between two signs of life, and those without one after which a claim from elsewhere has ended. */
const BEAT = 5000;
const SILENCE = 30_000;

/** Where process ids mean the same: what the system calls it, else the machine's name. */
const PLACE = placeOf();

/**
 * Claims a database and removes what a server that was killed left of its lock.
 *
 * @returns gives it back
 * @throws TexelcastError "database-taken" while another server is at work on it.
 */
export function claimDatabase(database: string): () => void {
  const file = `${database}.pid`;
  claim(file, database);
  held.add(file);
  rmSync(`${database}.lock`, { recursive: true, force: true });
  const own = identityOf(process.pid);
  // Held open: should another server have taken the claim away, what is written here does not reach its own.
  const claimed = openSync(file, "r+");
  const beat = setInterval(() => giveSign(claimed, own), BEAT).unref();
  return () => {
    if (!held.delete(file)) return;
    clearInterval(beat);
    closeSync(claimed);
    if (readOrNull(file) === own) rmSync(file, { force: true });
  };
}

/** A full disk, or a folder that is away for a moment, is no reason to end. */
function giveSign(claimed: number, own: string): void {
  try {
    writeSync(claimed, own, 0);
  } catch {}
}

function claim(file: string, database: string): void {
  // Twice: the other one may have ended meanwhile, or a third one may have come.
  for (let attempt = 0; attempt < 2; attempt += 1) {
    if (writeAnew(file)) return;
    const found = readOrNull(file);
    if (found !== null && isAtWork(file, found)) break;
    if (found !== null) takeAway(file, found);
  }
  const found = readOrNull(file) ?? "unknown";
  const elsewhere = isFromElsewhere(found)
    ? ` It is in another container or on another machine; if it was killed, its claim ends ${SILENCE / 1000} seconds after that.`
    : "";
  throw new TexelcastError("database-taken", "another server is at work on this database", {
    subject: database,
    field: "process",
    value: found.split(" ")[0] ?? "",
    hint: `End that server, or name another folder with --data.${elsewhere}`,
  });
}

/** Claims of servers before there were others elsewhere name no place. */
function isFromElsewhere(identity: string): boolean {
  const [, , place = PLACE] = identity.split(" ");
  return place !== PLACE;
}

/** Milliseconds since a file was written, both by the clock of the file system: two machines have two clocks. */
function silenceOf(file: string): number {
  const now = `${file}.${randomUUID()}`;
  try {
    writeFileSync(now, "");
    return statSync(now).mtimeMs - statSync(file).mtimeMs;
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== "ENOENT") throw error;
    return Number.POSITIVE_INFINITY;
  } finally {
    rmSync(now, { force: true });
  }
}

/** False where the file is there already. */
function writeAnew(file: string): boolean {
  const draft = `${file}.${randomUUID()}`;
  writeFileSync(draft, identityOf(process.pid));
  try {
    // Whole or not at all: no other server may read half an id.
    linkSync(draft, file);
    return true;
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== "EEXIST") throw error;
    return false;
  } finally {
    rmSync(draft, { force: true });
  }
}

/** Two servers may find the same stale file: what the slower one takes away must not be what the quicker one wrote. */
function takeAway(file: string, stale: string): void {
  const aside = `${file}.${randomUUID()}`;
  try {
    renameSync(file, aside);
    if (readFileSync(aside, "utf8") !== stale) linkSync(aside, file);
  } catch (error) {
    if (!["ENOENT", "EEXIST"].includes((error as NodeJS.ErrnoException).code ?? "")) throw error;
  } finally {
    rmSync(aside, { force: true });
  }
}

function isAtWork(file: string, identity: string): boolean {
  if (isFromElsewhere(identity)) return silenceOf(file) < SILENCE;
  const [id, started = UNKNOWN] = identity.split(" ");
  const pid = Number(id);
  if (!Number.isInteger(pid) || pid <= 0) return false;
  if (pid === process.pid) return held.has(file);
  try {
    process.kill(pid, 0);
  } catch (error) {
    // Somebody else's process may not be asked, but it is there.
    if ((error as NodeJS.ErrnoException).code !== "EPERM") return false;
  }
  return startOf(pid) === started;
}

const identityOf = (pid: number): string => `${pid} ${startOf(pid)} ${PLACE}`;

/** When a process began, where the system tells it: ids are given out again. */
function startOf(pid: number): string {
  // The name in the second column may hold spaces and brackets; what is counted begins after it. The start is column 22.
  const stat = readOrNull(`/proc/${pid}/stat`);
  return stat?.slice(stat.lastIndexOf(")") + 2).split(" ")[19] ?? UNKNOWN;
}

function placeOf(): string {
  try {
    const started = readFileSync("/proc/sys/kernel/random/boot_id", "utf8").trim();
    return `${started}/${readlinkSync("/proc/self/ns/pid")}`;
  } catch {
    return hostname();
  }
}

function readOrNull(file: string): string | null {
  try {
    return readFileSync(file, "utf8");
  } catch {
    return null;
  }
}
