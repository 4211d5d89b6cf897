import { execFile } from "node:child_process";
import { promisify } from "node:util";
import { expect, test } from "vitest";
import { inRoot } from "../../scripts/bootstrap/paths.mjs";

const run = (script: string, ...words: string[]): Promise<{ code: number; stdout: string; stderr: string }> =>
  promisify(execFile)(process.execPath, [inRoot(script), ...words]).then(
    (said) => ({ code: 0, ...said }),
    ({ code, stdout, stderr }) => ({ code, stdout, stderr }),
  );

test.each(["start", "test"])("`npm %s` tells its usage, and answers what it does not know with it", async (name) => {
  const script = `scripts/${name}.mjs`;
  const { code, stdout } = await run(script, "--help");
  expect([code, stdout]).toEqual([0, expect.stringContaining(`npm ${name} -- `)]);
  const refused = await run(script, "--prot", "80");
  expect(refused.code).toBe(2);
  expect(refused.stderr).toContain("--prot");
  expect(refused.stderr).toContain(stdout);
  expect(refused.stderr).not.toContain("node:internal");
});

test.each(["eighty", "65536", "-1"])("`npm start` does not take %s for a port", async (port) => {
  const { code, stderr } = await run("scripts/start.mjs", `--port=${port}`);
  expect([code, stderr]).toEqual([2, expect.stringContaining(port)]);
});
