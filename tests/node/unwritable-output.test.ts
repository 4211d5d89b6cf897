import { closeSync, existsSync, linkSync, mkdirSync, openSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, it, onTestFinished } from "vitest";
import { solidPng } from "../support/png-file.ts";
import { planeDocument, planeGlb } from "./plane-model.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

function folderWithPlane(): string {
  const folder = temporaryFolder();
  writeFileSync(path.join(folder, "plane.glb"), planeGlb());
  writeFileSync(path.join(folder, "design.json"), '{"format":"texelcast-design","version":1,"layers":[]}');
  return folder;
}

/** Linux's folder of processes is there, and yet it says ENOENT to whoever makes a folder in it, root or not. */
describe.runIf(existsSync("/proc/self"))("a folder in which none can be made", () => {
  it.for([
    ["bake", ["bake", "plane.glb", "--out", "/proc/no-such/maps", "--size", "8"], "/proc/no-such/maps/positions.npy"],
    ["render", ["render", "plane.glb", "design.json", "--out", "/proc/no-such/x.glb"], "/proc/no-such/x.glb"],
    [
      "print",
      ["print", "plane.glb", "design.json", "--out", "/proc/no-such/x.png", "--size", "8"],
      "/proc/no-such/x.png",
    ],
  ] as const)("ends %s with exit code 3, in words that name the file", async ([, args, target], { signal }) => {
    const { code, stdout, stderr } = await texelcast(args, { cwd: folderWithPlane(), signal });
    expect(code).toBe(3);
    expect(stdout).toBe("");
    const [wrong, hint, ...rest] = stderr.split("\n");
    expect(wrong).toBe(
      `texelcast: ${target}: cannot be written: its folder cannot be made: ENOENT: no such file or directory`,
    );
    expect(hint).toMatch(/^ {2}Give --out another place/);
    expect(rest).toEqual([""]);
  });
});

describe.runIf(existsSync("/proc/self"))("a place that takes no files", () => {
  const LONG = `${"a".repeat(300)}.png`;

  it.for([
    ["a folder of the system's", "/proc/x.png", "/proc/x.png: cannot be written: ENOENT: no such file or directory"],
    ["a name that is too long", LONG, `${LONG}: cannot be written: its name is too long`],
    ["a folder's own name", "maps.png", "maps.png: cannot be written: there is a folder of that name"],
    [
      "a folder that is a file",
      "plane.glb/x.png",
      'plane.glb/x.png: cannot be written: "plane.glb" is a file, not a folder',
    ],
  ] as const)("is told by the path that was asked for, and no other: %s", async ([, out, told], { signal }) => {
    const folder = folderWithPlane();
    mkdirSync(path.join(folder, "maps.png"));
    const args = ["render", "plane.glb", "design.json", "--out", out, "--size", "8"];
    const { code, stderr } = await texelcast(args, { cwd: folder, signal });
    expect(stderr).toBe(`texelcast: ${told}\n  Give --out another place, or make room there.\n`);
    expect(code).toBe(3);
  });
});

describe("an output that is one of the inputs", () => {
  const PICTURE = '"logo":{"type":"image/png","uri":"logo.png"}';

  it.each([
    ["the model", ["render", "plane.glb", "design.json", "--out", "plane.glb"], "plane.glb"],
    ["the model by another name", ["render", "plane.glb", "design.json", "--out", "same.glb"], "same.glb"],
    [
      "the picture below",
      ["render", "plane.glb", "design.json", "--base", "skin.png", "--out", "skin.png"],
      "skin.png",
    ],
    ["one of the design's pictures", ["render", "plane.glb", "design.json", "--out", "logo.png"], "logo.png"],
    ["one of the design's pictures", ["print", "plane.glb", "design.json", "--out", "logo.png"], "logo.png"],
  ] as const)("is refused as wrong usage, and left as it is: %s (%j)", async (_what, args, out) => {
    const folder = folderWithPlane();
    const at = (name: string): string => path.join(folder, name);
    linkSync(at("plane.glb"), at("same.glb"));
    writeFileSync(at("design.json"), `{"format":"texelcast-design","version":1,"assets":{${PICTURE}},"layers":[]}`);
    for (const name of ["skin.png", "logo.png"]) writeFileSync(at(name), solidPng(8, 8, [1, 2, 3, 255]));
    const before = readFileSync(at(out));
    const { code, stdout, stderr } = await texelcast([...args, "--size", "8"], { cwd: folder });
    expect(stderr).toBe(
      `texelcast: --out: "${out}" is read by this command, and would be lost\n  Give --out another name.\n`,
    );
    expect({ code, stdout }).toEqual({ code: 2, stdout: "" });
    expect(readFileSync(at(out)).equals(before)).toBe(true);
  });
});

describe("a side file of a .gltf", () => {
  /** The plane beside its two files, which have the names of what a bake writes. */
  function folderWithSideFiles(): string {
    const folder = temporaryFolder();
    const { gltf, bin } = planeDocument({ texture: solidPng(8, 8, [1, 2, 3, 255]) });
    const [picture] = gltf.images as { bufferView?: number; mimeType?: string; uri?: string }[];
    const view = (gltf.bufferViews as { byteOffset: number; byteLength: number }[])[picture?.bufferView ?? -1];
    if (!picture || !view) throw new Error("the plane has no picture");
    writeFileSync(path.join(folder, "normals.png"), bin.subarray(view.byteOffset, view.byteOffset + view.byteLength));
    delete picture.bufferView;
    picture.uri = "normals.png";
    gltf.buffers = [{ byteLength: bin.length, uri: "overlap.npy" }];
    writeFileSync(path.join(folder, "overlap.npy"), bin);
    writeFileSync(path.join(folder, "plane.gltf"), JSON.stringify(gltf));
    writeFileSync(path.join(folder, "design.json"), '{"format":"texelcast-design","version":1,"layers":[]}');
    return folder;
  }

  it.each([
    ["render", ["render", "plane.gltf", "design.json", "--out", "normals.png"], "normals.png"],
    ["print", ["print", "plane.gltf", "design.json", "--out", "normals.png"], "normals.png"],
    ["bake", ["bake", "plane.gltf", "--out", "."], "normals.png"],
  ])("is no place for what %s writes, and is left as it is", async (_what, args, out) => {
    const folder = folderWithSideFiles();
    const before = readFileSync(path.join(folder, out));
    const { code, stdout, stderr } = await texelcast([...args, "--size", "8"], { cwd: folder });
    expect(stderr).toBe(
      `texelcast: --out: "${out}" is read by this command, and would be lost\n  Give --out another name.\n`,
    );
    expect({ code, stdout }).toEqual({ code: 2, stdout: "" });
    expect(readFileSync(path.join(folder, out)).equals(before)).toBe(true);
  });
});

const WRITERS: [string, string[]][] = [
  ["inspect", ["inspect", "plane.glb"]],
  ["inspect --json", ["inspect", "plane.glb", "--json"]],
  ["check", ["check", "plane.glb", "design.json"]],
  ["render", ["render", "plane.glb", "design.json", "--out", "x.png", "--size", "8"]],
  ["schema", ["schema"]],
  ["--help", ["--help"]],
];

/** Linux's device that takes not a byte. */
describe.runIf(existsSync("/dev/full"))("a standard output without room", () => {
  it.each(WRITERS)("ends %s with exit code 3, one line of what is wrong and one of what to do", async (_what, args) => {
    const full = openSync("/dev/full", "w");
    onTestFinished(() => closeSync(full));
    const { code, stderr } = await texelcast(args, { cwd: folderWithPlane(), stdout: full });
    expect(stderr).toMatch(/^texelcast: stdout: cannot be written: ENOSPC: [^\n]+\n {2}[A-Z][^\n]+\.\n$/);
    expect(code).toBe(3);
  });
});

describe("a reader that has seen enough", () => {
  it.each(WRITERS)("ends %s with exit code 0 and without a word", async (_what, args) => {
    const run = await texelcast(args, { cwd: folderWithPlane(), stdout: "closed pipe" });
    expect(run).toMatchObject({ code: 0, stderr: "" });
  });
});

const UNREADABLE: [string, string[], number][] = [
  ["a model that is not there", ["inspect", "nope.glb"], 3],
  ["an unknown command", ["nope"], 2],
];

describe("a standard error that takes not a byte", () => {
  it.each(UNREADABLE)("leaves %s its exit code when its reader has gone", async (_what, args, code) => {
    const run = await texelcast(args, { cwd: folderWithPlane(), stderr: "closed pipe" });
    expect(run).toMatchObject({ code, stdout: "" });
  });

  it.runIf(existsSync("/dev/full")).each(UNREADABLE)(
    "leaves %s its exit code without room",
    async (_what, args, code) => {
      const full = openSync("/dev/full", "w");
      onTestFinished(() => closeSync(full));
      expect(await texelcast(args, { cwd: folderWithPlane(), stderr: full })).toMatchObject({ code, stdout: "" });
    },
  );
});
