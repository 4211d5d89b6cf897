import { mkdirSync, rmSync, symlinkSync, truncateSync, writeFileSync } from "node:fs";
import path from "node:path";
import { beforeEach, describe, expect, it } from "vitest";
import { MAX_FILE_BYTES, readFileBytes, resolveInFolder } from "../../node/read-file.ts";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { temporaryFolder } from "./run-cli.ts";

async function refusal(action: Promise<unknown>): Promise<TexelcastError> {
  const error = await action.then(
    () => null,
    (thrown: unknown) => thrown,
  );
  expect(error).toBeInstanceOf(TexelcastError);
  return error as TexelcastError;
}

let root: string;
let inside: (name: string) => string;
const resolve = (uri: string) => resolveInFolder(uri, { file: inside("model.gltf"), field: "images[0].uri" });

beforeEach(() => {
  root = temporaryFolder();
  inside = (name) => path.join(root, "models", name);
  mkdirSync(inside("textures"), { recursive: true });
  writeFileSync(inside("skin.png"), "skin");
  writeFileSync(inside("textures/red & blue.png"), "red");
  writeFileSync(inside("100%.png"), "full");
  writeFileSync(path.join(root, "secret.png"), "secret");
});

describe("a file that a document names", () => {
  it.each([
    ["beside it", "skin.png", "skin.png"],
    ["in a folder below", "textures/red & blue.png", "textures/red & blue.png"],
    ["percent-encoded", "textures/red%20%26%20blue.png", "textures/red & blue.png"],
    ["with a percent sign that encodes nothing", "100%.png", "100%.png"],
    ["by a way that goes up and comes back", "textures/../skin.png", "skin.png"],
    ["with a backslash, as Windows writes it", "textures\\red & blue.png", "textures/red & blue.png"],
    ["by a way that stays", "./skin.png", "skin.png"],
  ])("is found %s", async (_what, uri, name) => {
    expect(await resolve(uri)).toBe(inside(name));
  });

  it("is found through a link that stays in the folder", async () => {
    symlinkSync(inside("skin.png"), inside("link.png"));
    expect(await resolve("link.png")).toBe(inside("skin.png"));
  });

  it("is found however the letters of its path are spelled, there or in the document", async () => {
    const name = "größe/äußere haut.png";
    for (const [stored, named] of [
      ["NFD", "NFC"],
      ["NFC", "NFD"],
    ] as const) {
      mkdirSync(inside("größe".normalize(stored)), { recursive: true });
      writeFileSync(inside(name.normalize(stored)), stored);
      const found = await readFileBytes(await resolve(encodeURI(name.normalize(named))), { code: "bad-model" });
      expect(new TextDecoder().decode(found)).toBe(stored);
      rmSync(inside("größe".normalize(stored)), { recursive: true });
    }
  });

  it("is refused through a link outside however its letters are spelled", async () => {
    symlinkSync(path.join(root, "secret.png"), inside("würfel.png".normalize("NFD")));
    const error = await refusal(resolve("würfel.png".normalize("NFC")));
    expect(error.message).toContain("is a link that leads outside the folder");
  });

  it.each([
    ["a way up", "../secret.png", "lies outside the folder"],
    ["a way up in disguise", "..%2fsecret.png", "lies outside the folder"],
    ["a way up as Windows writes it", "..\\secret.png", "lies outside the folder"],
    ["a way up from below", "textures/../../secret.png", "lies outside the folder"],
    ["the folder itself", ".", "lies outside the folder"],
    ["the folder above", "..", "lies outside the folder"],
    ["an absolute path", "/etc/passwd", "is an absolute path"],
    ["an absolute path in disguise", "%2Fetc%2Fpasswd", "is an absolute path"],
    ["a path as Windows writes it", "C:\\secret.png", "is an absolute path"],
    ["a path of Windows with slashes", "c:/secret.png", "is an absolute path"],
    ["a network path", "\\\\host\\share\\secret.png", "is an absolute path"],
    ["a network address", "//host/secret.png", "is an absolute path"],
    ["a file address", "file:///etc/passwd", "is a file: address"],
    ["a web address", "http://host/skin.png", "is a http: address"],
    ["a secure web address", "https://host/skin.png", "is a https: address"],
    ["a name with a zero byte", "skin.png%00", "is not a file name"],
  ])("is refused by %s", async (_what, uri, message) => {
    const error = await refusal(resolve(uri));
    expect(error.code).toBe("outside-folder");
    expect(error.subject).toBe(inside("model.gltf"));
    expect(error.field).toBe("images[0].uri");
    expect(error.value).toBe(uri);
    expect(error.message).toContain(`${JSON.stringify(uri)} ${message}`);
    expect(error.hint).toBeTruthy();
  });

  it.each([
    ["a file", "leak.png", "leak.png"],
    ["a folder", "up", "up/secret.png"],
  ])("is refused through a link to %s outside", async (_what, link, uri) => {
    symlinkSync(link === "up" ? root : path.join(root, "secret.png"), inside(link));
    const error = await refusal(resolve(uri));
    expect(error.code).toBe("outside-folder");
    expect(error.message).toContain("is a link that leads outside the folder");
  });

  it("may lie under a folder that is itself reached by a link", async () => {
    symlinkSync(path.join(root, "models"), path.join(root, "alias"));
    const target = await resolveInFolder("skin.png", { file: path.join(root, "alias", "model.gltf") });
    expect(target).toBe(inside("skin.png"));
  });

  it("lies beside its document where that is reached by a link and a way up, and not where the link stands", async () => {
    mkdirSync(inside("releases"));
    symlinkSync(inside("releases"), path.join(root, "current"));
    writeFileSync(path.join(root, "skin.png"), "another");
    writeFileSync(path.join(root, "private.png"), "private");
    const reference = { file: `${root}/current/../model.gltf` };
    expect(await resolveInFolder("skin.png", reference)).toBe(inside("skin.png"));
    const missing = await resolveInFolder("private.png", reference);
    expect(await refusal(readFileBytes(missing, { code: "bad-model" }))).toMatchObject({ code: "missing-file" });
  });

  it("is missing where only the way up behind a link that leads out would have it", async () => {
    mkdirSync(path.join(root, "elsewhere/deep"), { recursive: true });
    writeFileSync(path.join(root, "elsewhere/lost.png"), "private");
    symlinkSync(path.join(root, "elsewhere/deep"), inside("up"));
    const error = await refusal(readFileBytes(await resolve("up/../lost.png"), { code: "bad-model" }));
    expect(error.code).toBe("missing-file");
  });

  it("is told with the document and the field when it is missing", async () => {
    const file = inside("model.gltf");
    const namedBy = { file, field: "images[0].uri" };
    const error = await refusal(readFileBytes(await resolve("lost.png"), { code: "bad-model", namedBy }));
    expect(error).toMatchObject({ code: "missing-file", subject: file, field: "images[0].uri" });
    expect(error.message).toBe(`images[0].uri: ${JSON.stringify(inside("lost.png"))}: there is no such file`);
  });
});

describe("a file that the user names", () => {
  it("is read whole", async () => {
    expect(new TextDecoder().decode(await readFileBytes(inside("skin.png"), { code: "bad-model" }))).toBe("skin");
  });

  it("is missing when it is not there, or what should be its folder is a file", async () => {
    expect((await refusal(readFileBytes(inside("lost.glb"), { code: "bad-model" }))).code).toBe("missing-file");
    expect((await refusal(readFileBytes(inside("skin.png/a.glb"), { code: "bad-model" }))).code).toBe("missing-file");
  });

  it("is said to have a name that is no UTF-8 where that is why it is missing: what Node is given of such a name leads nowhere", async () => {
    // "größe.glb" in Latin-1, as a command's arguments and a folder's list have it.
    const name = new TextDecoder().decode(Uint8Array.from(Buffer.from("größe.glb", "latin1")));
    const error = await refusal(readFileBytes(inside(name), { code: "bad-model" }));
    expect(error.code).toBe("missing-file");
    expect(error.hint).toBe("Its name is not written in UTF-8: rename it.");
  });

  it("is told as an empty name where a script has given one", async () => {
    expect(await refusal(readFileBytes("", { code: "bad-model" }))).toMatchObject({
      code: "missing-file",
      subject: '""',
    });
  });

  it("is told once and cut short, however long its name is", async () => {
    const name = `${"long ".repeat(1000)}.glb`;
    const refused = await refusal(readFileBytes(name, { code: "bad-picture", namedBy: { file: "design.json" } }));
    expect(refused).toMatchObject({ code: "bad-picture", subject: "design.json" });
    expect(refused.message).toHaveLength(
      `"${name.slice(0, 119)}…": cannot be read: ENAMETOOLONG: name too long`.length,
    );
  });

  it("is refused when it is a folder or a device", async () => {
    const folder = await refusal(readFileBytes(inside("textures"), { code: "bad-model" }));
    expect(folder).toMatchObject({ code: "bad-model", message: "is a folder", subject: inside("textures") });
    const device = await refusal(readFileBytes("/dev/zero", { code: "bad-model" }));
    expect(device).toMatchObject({ code: "bad-model", message: "is not a regular file" });
  });

  it("is refused before it is read when it is 2 GiB or more", async () => {
    const file = inside("huge.glb");
    writeFileSync(file, "");
    // Sparse: the file takes no room on the disk.
    truncateSync(file, MAX_FILE_BYTES + 1);
    const error = await refusal(readFileBytes(file, { code: "bad-model" }));
    expect(error).toMatchObject({ code: "bad-model", value: "2147483648 bytes" });
    expect(error.message).toBe("has 2147483648 bytes, the limit is 2147483647");
  });
});
