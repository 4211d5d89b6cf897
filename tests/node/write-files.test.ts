import { readdirSync } from "node:fs";
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
