import { existsSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { access, open } from "node:fs/promises";
import path from "node:path";
import { afterEach, expect, it, vi } from "vitest";
import { checkOutputFile, PendingFiles } from "../../node/write-files.ts";
import { temporaryFolder } from "./run-cli.ts";

vi.mock("node:fs/promises", async (original) => {
  const real = await original<typeof import("node:fs/promises")>();
  return { ...real, access: vi.fn(real.access), open: vi.fn(real.open) };
});
afterEach(() => {
  vi.restoreAllMocks();
  for (const mocked of [access, open]) vi.mocked(mocked).mockReset();
});

it("a signal that comes while a file is being opened leaves none behind", async () => {
  const folder = temporaryFolder();
  const killed = vi.spyOn(process, "kill").mockReturnValue(true);
  const { open: realOpen } = await vi.importActual<typeof import("node:fs/promises")>("node:fs/promises");
  vi.mocked(open).mockImplementation((...args) => {
    process.emit("SIGTERM", "SIGTERM");
    return realOpen(...args);
  });
  const files = new PendingFiles();
  await expect(files.create(path.join(folder, "map.png"))).rejects.toMatchObject({ code: "cannot-write" });
  expect(killed).toHaveBeenCalledWith(process.pid, "SIGTERM");
  expect(readdirSync(folder)).toEqual([]);
});

it("a folder that may not be written to is told of before the work is done", async () => {
  const folder = temporaryFolder();
  // To the superuser, as whom tests may run, every folder is open.
  vi.mocked(access).mockRejectedValue(new Error("EACCES: permission denied, access '/x/.hidden'"));
  const file = path.join(folder, "x.png");
  await expect(checkOutputFile(file)).rejects.toMatchObject({
    code: "cannot-write",
    subject: file,
    message: `cannot be written: the folder ${JSON.stringify(folder)} takes no files: EACCES: permission denied`,
  });
});

it("a file that may not be written to is told of before the work is done, though its folder could take another in its place", async () => {
  const folder = temporaryFolder();
  const file = path.join(folder, "approved.png");
  writeFileSync(file, "approved");
  const { access: realAccess } = await vi.importActual<typeof import("node:fs/promises")>("node:fs/promises");
  vi.mocked(access).mockImplementation(async (place, mode) => {
    if (place === file) throw new Error(`EACCES: permission denied, access '${file}'`);
    await realAccess(place, mode);
  });
  await expect(checkOutputFile(file)).rejects.toMatchObject({
    code: "cannot-write",
    subject: file,
    message: "cannot be written: there is a file of that name that may not be written to: EACCES: permission denied",
  });
});

it("a signal that comes while files take their places finds all of them there, or none", async () => {
  const folder = temporaryFolder();
  const places = Array.from({ length: 8 }, (_, index) => path.join(folder, `${index}.npy`));
  vi.spyOn(process, "kill").mockReturnValue(true);
  const files = new PendingFiles();
  for (const place of places) await files.write(place, Uint8Array.of(1));
  let isDone = false;
  const done = files.commit().catch(() => {});
  void done.then(() => {
    isDone = true;
  });
  while (!isDone) {
    if (places.some(existsSync)) process.emit("SIGTERM", "SIGTERM");
    await new Promise(setImmediate);
  }
  expect(readdirSync(folder).length % places.length).toBe(0);
});

it("a file that takes another's place has that one's owner and group, or at least its group, before a byte is in it", async () => {
  const file = path.join(temporaryFolder(), "shared.png");
  writeFileSync(file, "old");
  const { uid, gid } = statSync(file);
  const { open: realOpen } = await vi.importActual<typeof import("node:fs/promises")>("node:fs/promises");
  const asked: unknown[] = [];
  vi.mocked(open).mockImplementation(async (...args) => {
    const handle = await realOpen(...args);
    vi.spyOn(handle, "chown").mockImplementation(async (user, group) => {
      asked.push([user, group, (await handle.stat()).size]);
      if (user === uid) throw new Error("EPERM: operation not permitted");
    });
    return handle;
  });
  const files = new PendingFiles();
  await files.write(file, Uint8Array.of(1));
  await files.commit();
  expect(asked).toEqual([
    [uid, gid, 0],
    [-1, gid, 0],
  ]);
});
