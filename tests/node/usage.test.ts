import { existsSync, readdirSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import packageJson from "../../package.json" with { type: "json" };
import { temporaryFolder, texelcast } from "./run-cli.ts";

describe("the command line's usage", () => {
  it.each([
    ["--help", ["--help"]],
    ["help", ["help"]],
    ["help render", ["help", "render"]],
    ["inspect --help", ["inspect", "--help"]],
    ["bake --help", ["bake", "--help"]],
    ["render --help", ["render", "--help"]],
    ["check --help", ["check", "--help"]],
    ["print --help", ["print", "--help"]],
    ["schema --help", ["schema", "--help"]],
  ])("is told on stdout with examples by %s", async (_what, args) => {
    const { code, stdout, stderr } = await texelcast(args);
    expect(code).toBe(0);
    expect(stdout).toMatch(/^Usage: texelcast/);
    expect(stdout).toContain("Examples:\n  texelcast ");
    expect(stderr).toBe("");
  });

  it("tells its version", async () => {
    expect(await texelcast(["--version"])).toMatchObject({ code: 0, stdout: `${packageJson.version}\n`, stderr: "" });
  });

  it.each<[string, string[], string]>([
    ["no command", [], "Usage: texelcast"],
    ["an unknown command", ["rendr"], "unknown command 'rendr'"],
    ["a question for help with no command", ["help", "nothing"], "texelcast: unknown command 'nothing'\n"],
    ["a question for help with two commands", ["help", "bake", "render"], "too many arguments for 'help'"],
    ["an unknown option", ["inspect", "a.glb", "--jsn"], "unknown option '--jsn'"],
    ["a missing argument", ["inspect"], "missing required argument 'model'"],
    ["a missing design", ["render", "a.glb", "--out", "a.png"], "missing required argument 'design'"],
    ["an argument too many", ["inspect", "a.glb", "b.glb"], "too many arguments"],
    ["a bake without --out", ["bake", "a.glb"], "required option '--out <dir>' not specified"],
    ["an empty --out", ["bake", "a.glb", "--out", ""], "must not be empty"],
    ["an option without its value", ["bake", "a.glb", "--out"], "argument missing"],
    ["a folder that was forgotten", ["bake", "a.glb", "--out", "--size", "16"], "'--out <dir>' argument '--size'"],
    [
      "a ground that was forgotten",
      ["render", "a.glb", "b.json", "--out", "a.png", "--base", "--size", "16"],
      "'--base <ground>' argument '--size'",
    ],
    [
      "a zones file that was forgotten by check",
      ["check", "a.glb", "b.json", "--zones", "--json"],
      "'--zones <file>' argument '--json'",
    ],
    [
      "a zones file that was forgotten by print",
      ["print", "a.glb", "b.json", "--out", "a.png", "--zones", "--zone", "front"],
      "'--zones <file>' argument '--zone'",
    ],
    ["a zones file without a name", ["check", "a.glb", "b.json", "--zones", ""], "must not be empty"],
    [
      "a material that is no number",
      ["bake", "a.glb", "--out", "x", "--material", "one"],
      "must be a whole number from 0",
    ],
    ["a material below zero", ["bake", "a.glb", "--out", "x", "--material", "-1"], "must be a whole number from 0"],
    ["a size of nothing", ["bake", "a.glb", "--out", "x", "--size", "0"], "must be a whole number from 1 to 8192"],
    ["a size above the largest", ["bake", "a.glb", "--out", "x", "--size", "8193"], "from 1 to 8192"],
    ["a size of half a texel", ["bake", "a.glb", "--out", "x", "--size", "0.5"], "from 1 to 8192"],
    ["a size of three sides", ["bake", "a.glb", "--out", "x", "--size", "2x2x2"], "2048x1024"],
    ["a size of one side and a half", ["bake", "a.glb", "--out", "x", "--size", "2x"], "from 1 to 8192"],
    ["a gutter above the largest", ["bake", "a.glb", "--out", "x", "--gutter", "65"], "from 0 to 64"],
    ["an output of another kind", ["render", "a.glb", "b.json", "--out", "a.jpg"], "must end in .png"],
    [
      "a model for each material",
      ["render", "a.glb", "b.json", "--out", "a-{material}.glb"],
      "A .glb holds all materials",
    ],
    ["an output without a kind", ["render", "a.glb", "b.json", "--out", "png"], "must end in .png"],
    [
      "a colour of four digits",
      ["render", "a.glb", "b.json", "--out", "a.png", "--base", "#1234"],
      'must be "#rrggbb"',
    ],
  ])("answers %s with exit code 2 and nothing on stdout", async (_what, args, told) => {
    const folder = temporaryFolder();
    const { code, stdout, stderr } = await texelcast(args, { cwd: folder });
    expect(code).toBe(2);
    expect(stdout).toBe("");
    expect(stderr).toContain(told);
    expect(readdirSync(folder)).toEqual([]);
  });

  it.each([
    ["an unknown option", ["inspect", "a.glb", "--jsn"], "unknown option '--jsn' (Did you mean --json?)"],
    ["an unknown command", ["rendr"], "unknown command 'rendr' (Did you mean render?)"],
    ["a command that no terminal should see", ["\u001b[31m\nred"], "unknown command '\\u001b[31m\\u000ared'"],
  ])("says of %s in one line what is wrong, and in one what to do", async (_what, args, told) => {
    const { stderr } = await texelcast(args);
    expect(stderr.split("\n")).toEqual([
      `texelcast: ${told}`,
      "  `texelcast --help` and `texelcast COMMAND --help` tell the usage.",
      "",
    ]);
  });

  it("looks at the arguments before it looks at the files", async () => {
    const { code, stderr } = await texelcast(["bake", "no-such-file.glb", "--out", "x", "--size", "0"]);
    expect(code).toBe(2);
    expect(stderr).not.toContain("no-such-file");
  });

  it("writes errors as program, subject, message, and a hint below", async () => {
    const { code, stdout, stderr } = await texelcast(["inspect", "no-such-file.glb"]);
    expect(code).toBe(3);
    expect(stdout).toBe("");
    expect(stderr).toBe(
      "texelcast: no-such-file.glb: there is no such file\n  Check the name; upper and lower case differ.\n",
    );
  });

  it("does not let a file's name write to the terminal", async () => {
    const { stderr } = await texelcast(["inspect", "\u001b[31mred.glb"]);
    expect(stderr).not.toContain("\u001b");
    expect(stderr).toContain("\\u001b[31mred.glb");
  });

  it("makes no folder for an output that it cannot make", async () => {
    const folder = temporaryFolder();
    await texelcast(["bake", "no-such-file.glb", "--out", "maps"], { cwd: folder });
    expect(existsSync(path.join(folder, "maps"))).toBe(false);
  });
});
