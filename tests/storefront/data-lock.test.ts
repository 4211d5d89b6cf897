/** Who may open the shop's database: one server at a time, and also the one that comes after a server was killed. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  utimesSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { afterEach, beforeEach, expect, it, onTestFinished, vi } from "vitest";
import { ShopDatabase } from "../../node/storefront/shop-database.ts";

let folder: string;
let file: string;
beforeEach(() => {
  folder = mkdtempSync(path.join(tmpdir(), "texelcast-lock-"));
  file = path.join(folder, "shop.sqlite");
});
afterEach(() => rmSync(folder, { recursive: true, force: true }));

const open = (): ShopDatabase => {
  const database = new ShopDatabase(file);
  onTestFinished(() => database.close());
  return database;
};

/** A process that lives until the test is over, or is ended by what this gives. */
async function otherProcess(): Promise<{ readonly pid: number; end(): Promise<void> }> {
  const child = spawn(process.execPath, ["-e", "setInterval(() => {}, 1000)"], { stdio: "ignore" });
  const ended = once(child, "exit");
  const end = async (): Promise<void> => {
    child.kill("SIGKILL");
    await ended;
  };
  onTestFinished(end);
  return { pid: Number(child.pid), end };
}

it("a server that was killed while it wrote does not keep the next one from starting", () => {
  const first = new ShopDatabase(file);
  const cart = first.makeCart();
  first.close();
  // What kill -9 leaves: SQLite's lock, and the id of a process that is no more.
  mkdirSync(`${file}.lock`);
  writeFileSync(`${file}.pid`, "2147483646");
  expect(open().hasCart(cart)).toBe(true);
});

it("a lock that was left by a server without a file of its own is taken away too", () => {
  mkdirSync(`${file}.lock`);
  expect(open().makeCart()).toMatch(/./);
});

it("a second server on the same data is refused while the first is at work, and may start after it", () => {
  const first = new ShopDatabase(file);
  expect(() => new ShopDatabase(file)).toThrow(
    expect.objectContaining({ code: "database-taken", subject: file, value: String(process.pid) }),
  );
  expect(first.makeCart()).toMatch(/./);
  first.close();
  expect(existsSync(`${file}.pid`)).toBe(false);
  expect(open().makeCart()).toMatch(/./);
});

it("another process's claim holds as long as it lives, and its lock with it", async () => {
  const other = await otherProcess();
  mkdirSync(`${file}.lock`);
  const started = existsSync("/proc/self/stat") ? ` ${startOf(other.pid)}` : "";
  writeFileSync(`${file}.pid`, `${other.pid}${started}`);
  expect(() => new ShopDatabase(file)).toThrow(expect.objectContaining({ code: "database-taken" }));
  expect(existsSync(`${file}.lock`)).toBe(true);
  await other.end();
  expect(open().makeCart()).toMatch(/./);
  expect(readdirSync(folder).filter((name) => name.includes(".pid."))).toEqual([]);
});

it.runIf(existsSync("/proc/self/stat"))("an id that the system gave to another process claims nothing", async () => {
  const other = await otherProcess();
  writeFileSync(`${file}.pid`, `${other.pid} 1`);
  expect(open().makeCart()).toMatch(/./);
});

it("a server in another container holds what it claimed for as long as it gives signs of life", () => {
  const claim = "1 4711 another-start/pid:[1]";
  writeFileSync(`${file}.pid`, claim);
  mkdirSync(`${file}.lock`);
  expect(() => new ShopDatabase(file)).toThrow(
    expect.objectContaining({ code: "database-taken", value: "1", hint: expect.stringContaining("another container") }),
  );
  expect(existsSync(`${file}.lock`)).toBe(true);
  expect(readFileSync(`${file}.pid`, "utf8")).toBe(claim);
  const aMinuteAgo = Date.now() / 1000 - 60;
  utimesSync(`${file}.pid`, aMinuteAgo, aMinuteAgo);
  expect(open().makeCart()).toMatch(/./);
  expect(readdirSync(folder).filter((name) => name.includes(".pid."))).toEqual([]);
});

it("gives signs of life in its own claim, and none in one that has taken its place", () => {
  vi.useFakeTimers({ toFake: ["setInterval", "clearInterval"] });
  onTestFinished(() => void vi.useRealTimers());
  const first = new ShopDatabase(file);
  const longAgo = Date.now() / 1000 - 3600;
  utimesSync(`${file}.pid`, longAgo, longAgo);
  vi.advanceTimersByTime(5000);
  expect(statSync(`${file}.pid`).mtimeMs / 1000).toBeGreaterThan(longAgo + 1800);
  // As when it was held for so long that another one took it for dead.
  const other = "1 4711 another-start/pid:[1]";
  rmSync(`${file}.pid`);
  writeFileSync(`${file}.pid`, other);
  vi.advanceTimersByTime(5000);
  first.close();
  expect(readFileSync(`${file}.pid`, "utf8")).toBe(other);
});

const startOf = (pid: number): string => {
  const stat = readFileSync(`/proc/${pid}/stat`, "utf8");
  return stat.slice(stat.lastIndexOf(")") + 2).split(" ")[19] ?? "";
};
