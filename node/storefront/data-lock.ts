/**
 * One server at a time on one database. SQLite's own lock here is a folder (`node-sqlite3-wasm` makes it), which outlives a
 * server that is killed while it writes, and then refuses every later one. So a server first says who it is in a file of its
 * own: what that file's process, if it lives no more, left locked may be taken away.
 */
import { randomUUID } from "node:crypto";
import { linkSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { TexelcastError } from "../../web/core/texelcast-error.ts";

/** Of this process: its own id in a file may also be that of an earlier one, as in a container where every server is 1. */
const held = new Set<string>();

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
  return () => {
    if (held.delete(file)) rmSync(file, { force: true });
  };
}

function claim(file: string, database: string): void {
  // Twice: the other one may have ended meanwhile, or a third one may have come.
  for (let attempt = 0; attempt < 2; attempt += 1) {
    if (writeAnew(file)) return;
    const found = readOrNull(file);
    if (found !== null && isAtWork(file, found)) break;
    if (found !== null) takeAway(file, found);
  }
  throw new TexelcastError("database-taken", "another server is at work on this database", {
    subject: database,
    field: "process",
    value: readOrNull(file)?.split(" ")[0] ?? "unknown",
    hint: "End that server, or name another folder with --data.",
  });
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
  const pid = Number(identity.split(" ")[0]);
  if (!Number.isInteger(pid) || pid <= 0) return false;
  if (pid === process.pid) return held.has(file);
  try {
    process.kill(pid, 0);
  } catch (error) {
    // Somebody else's process may not be asked, but it is there.
    if ((error as NodeJS.ErrnoException).code !== "EPERM") return false;
  }
  return identityOf(pid) === identity;
}

/** A process's id, and where the system tells it, when it began: ids are given out again. */
function identityOf(pid: number): string {
  // The name in the second column may hold spaces and brackets; what is counted begins after it. The start is column 22.
  const stat = readOrNull(`/proc/${pid}/stat`);
  const started = stat?.slice(stat.lastIndexOf(")") + 2).split(" ")[19];
  return started === undefined ? String(pid) : `${pid} ${started}`;
}

function readOrNull(file: string): string | null {
  try {
    return readFileSync(file, "utf8");
  } catch {
    return null;
  }
}
