/** Starting the shop's server: options that cannot be meant are told in words, and it ends with 2. */
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { expect, it, onTestFinished } from "vitest";
import { PLANE } from "./shop-fixture.ts";

const SERVER = fileURLToPath(new URL("../../build/node/storefront.mjs", import.meta.url));

const start = (...args: string[]) => startFrom({}, ...args);
const startFrom = (env: Readonly<Record<string, string>>, ...args: string[]) =>
  spawnSync(process.execPath, [SERVER, ...args], {
    encoding: "utf8",
    timeout: 20_000,
    env: { ...process.env, ...env },
  });

it("tells its usage on stdout when it is asked for", () => {
  const { status, stdout, stderr } = start("--help");
  expect(stdout).toMatch(/^Usage: npm run storefront/);
  expect({ status, stderr }).toEqual({ status: 0, stderr: "" });
});

it.each([
  ["an unknown option", ["--nope"], "Unknown option '--nope'"],
  ["a port without a number", ["--port"], "Option '--port <value>' argument missing"],
  ["a site that is not there", ["--site", "/no-such"], "--site must be a folder"],
  ["a data folder without a name", ["--data", ""], "--data must name a folder."],
  [
    "an origin without a scheme",
    ["--origin", "shop.example"],
    '--origin must be as "https://shop.example", is "shop.example".',
  ],
  ["an origin that is a page", ["--origin", "https://shop.example/cart"], "--origin must be as"],
  ["an origin of no web server", ["--editor-origin", "file:///"], "--editor-origin must be as"],
  [
    "an origin with a name and a password",
    ["--editor-origin", "https://a:b@shop.example"],
    "--editor-origin must be as",
  ],
])("refuses %s in words", (_what, args, told) => {
  const { status, stderr } = start(...args);
  expect(stderr).toContain(told);
  expect(stderr).not.toMatch(/^ {4}at /m);
  expect(status).toBe(2);
});

it("takes an origin with the slash that browsers show at its end, and an empty PORT for none", () => {
  const { status, stderr } = startFrom({ PORT: "" }, "--origin", "https://shop.example/", "--site", "/no-such");
  expect(stderr).toContain("--site must be a folder");
  expect(status).toBe(2);
});

it("takes folders as seen from where npm was called, which runs it in the checkout", () => {
  const folder = mkdtempSync(path.join(tmpdir(), "texelcast-start-"));
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  mkdirSync(path.join(folder, "pages"));
  writeFileSync(path.join(folder, "file"), "");
  const { status, stderr } = startFrom({ INIT_CWD: folder }, "--site", "pages", "--data", "file");
  expect(stderr).toContain(`--data: ${JSON.stringify(path.join(folder, "file"))} cannot be made: `);
  expect(status).toBe(2);
});

it("refuses a data folder that is a file, or that can never be made", () => {
  const folder = mkdtempSync(path.join(tmpdir(), "texelcast-start-"));
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  const file = path.join(folder, "file");
  writeFileSync(file, "");
  const unmakable = existsSync("/proc/self") ? [file, "/proc/no-such"] : [file];
  for (const data of unmakable) {
    const { status, stderr } = start("--site", folder, "--data", data);
    expect(stderr).toContain(`--data: ${JSON.stringify(data)} cannot be made: `);
    expect(status).toBe(2);
  }
});

it.each([
  ["whose database is another file", "shop.sqlite", (file: string) => writeFileSync(file, "no database ".repeat(100))],
  ["whose database is a folder", "shop.sqlite", (file: string) => mkdirSync(file)],
  ["whose files are one file", "files", (file: string) => writeFileSync(file, "")],
])("refuses a data folder %s, in words, and leaves it as it is", (_what, name, spoil) => {
  const folder = mkdtempSync(path.join(tmpdir(), "texelcast-start-"));
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  const [site, data] = [path.join(folder, "site"), path.join(folder, "data")];
  for (const each of [path.join(site, "shop"), data]) mkdirSync(each, { recursive: true });
  writeFileSync(path.join(site, "shop", "products.json"), JSON.stringify([PLANE]));
  const file = path.join(data, name);
  spoil(file);
  const { status, stderr } = start("--site", site, "--data", data, "--port", "0");
  expect(stderr).toMatch(/^[^\n]+\n$/);
  expect(stderr).toContain(file);
  expect(stderr).toContain("--data");
  expect(status).toBe(2);
  expect(existsSync(path.join(data, "shop.sqlite.pid"))).toBe(false);
  expect(existsSync(file)).toBe(true);
});

it.each([
  ["is not there", null, "products.json: there is no such file."],
  ["is not JSON", "[{", "products.json: the list of products is not valid JSON: "],
  ["says one thing twice", '[{"id":"mug","id":"cup"}]', "products.json: [0].id: stands twice in one object."],
])("refuses pages whose list of products %s, in words", (_what, list, told) => {
  const site = mkdtempSync(path.join(tmpdir(), "texelcast-start-"));
  onTestFinished(() => rmSync(site, { recursive: true, force: true }));
  mkdirSync(path.join(site, "shop"));
  if (list !== null) writeFileSync(path.join(site, "shop", "products.json"), list);
  const { status, stderr } = start("--site", site, "--data", path.join(site, "data"));
  expect(stderr).toContain(told);
  expect(stderr).not.toMatch(/^ {4}at /m);
  expect(status).toBe(2);
});
