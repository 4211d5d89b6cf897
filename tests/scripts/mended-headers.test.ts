import { execFileSync } from "node:child_process";
import { lstatSync, mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { inRoot } from "../../scripts/bootstrap/paths.mjs";

const FOLDER = inRoot("build/test-mended-headers");
const INSTALLED = `${FOLDER}/usr/include/rapidjson`;
const LINK = `${FOLDER}/deps/rapidjson`;

const AROUND = ["#if A[1] /* ; \\ $B{} */", "#endif"] as const;
const header = (line: string): string => `${AROUND[0]}\n    ${line}\n${AROUND[1]}\n`;
const BROKEN = header("GenericStringRef& operator=(const GenericStringRef& rhs) { s = rhs.s; length = rhs.length; }");
const MENDED = header("GenericStringRef& operator=(const GenericStringRef& rhs) = delete;");
const NUMBERS = "internal/strtod.h";
const OLD_ZERO = header("if (int(length) + exp < -324)");
const NEW_ZERO = header("if (*decimals == '0' || int(length) + exp < -324)");

function mend(): void {
  execFileSync("cmake", [`-DFOLDER=${LINK}`, "-P", inRoot("cmake/mend_rapidjson.cmake")]);
}

const read = (file: string): string => readFileSync(file, "utf8");

describe("an installed RapidJSON", () => {
  const cleanUp = (): void => rmSync(FOLDER, { recursive: true, force: true });
  beforeEach(() => {
    cleanUp();
    mkdirSync(`${INSTALLED}/internal`, { recursive: true });
    mkdirSync(`${FOLDER}/deps`);
    writeFileSync(`${INSTALLED}/reader.h`, "reader");
    writeFileSync(`${INSTALLED}/${NUMBERS}`, NEW_ZERO);
    symlinkSync(INSTALLED, LINK);
  });
  afterEach(cleanUp);

  it("that new compilers refuse is replaced by a copy that they take, and stays as it was itself", () => {
    writeFileSync(`${INSTALLED}/document.h`, BROKEN);
    mend();
    mend();
    expect([read(`${LINK}/document.h`), read(`${LINK}/reader.h`)]).toEqual([MENDED, "reader"]);
    expect(read(`${INSTALLED}/document.h`)).toBe(BROKEN);
  });

  it("that makes other numbers of some zeros is replaced by a copy that does not, once", () => {
    writeFileSync(`${INSTALLED}/document.h`, BROKEN);
    writeFileSync(`${INSTALLED}/${NUMBERS}`, OLD_ZERO);
    mend();
    mend();
    expect([read(`${LINK}/document.h`), read(`${LINK}/${NUMBERS}`)]).toEqual([MENDED, NEW_ZERO]);
    expect(read(`${INSTALLED}/${NUMBERS}`)).toBe(OLD_ZERO);
  });

  it("that has nothing to mend is used where it lies", () => {
    writeFileSync(`${INSTALLED}/document.h`, MENDED);
    mend();
    expect(lstatSync(LINK).isSymbolicLink()).toBe(true);
  });
});

describe("an installed tinygltf", () => {
  const INCLUDE = `${FOLDER}/include`;
  const FILE = `${FOLDER}/deps/tiny_gltf.h`;
  const WALK = "for (auto &mesh : model->meshes) {";
  const cleanUp = (): void => rmSync(FOLDER, { recursive: true, force: true });
  beforeEach(() => {
    cleanUp();
    for (const folder of [INCLUDE, `${FOLDER}/deps`]) mkdirSync(folder, { recursive: true });
    symlinkSync(`${INCLUDE}/tiny_gltf.h`, FILE);
  });
  afterEach(cleanUp);

  it("is replaced by a copy that does not go through the meshes again, once, and stays as it was itself", () => {
    writeFileSync(`${INCLUDE}/tiny_gltf.h`, header(WALK));
    for (let time = 0; time < 2; time++) {
      execFileSync("cmake", [`-DFILE=${FILE}`, "-P", inRoot("cmake/mend_tinygltf.cmake")]);
    }
    expect(read(FILE)).toBe(header(`if (false) ${WALK}`));
    expect(read(`${INCLUDE}/tiny_gltf.h`)).toBe(header(WALK));
  });
});
