/** Meshes of a page's own three.js scene, painted by the installed package in a real Chromium: each looks as it did, and stays so. */
import type { Browser } from "@playwright/test";
import { afterAll, beforeAll, expect, test } from "vitest";
import { paintPng, solidPng } from "../support/png-file.ts";
import { guideFile } from "./support/guide.ts";
import { addShopFiles, type InstalledPackage, installPackage } from "./support/installed.ts";
import { openBrowser, openPage, type StaticServer, serveFolder } from "./support/serve.ts";

type Rgb = readonly [number, number, number];

const [RED, GREEN, BLUE, YELLOW]: readonly Rgb[] = [
  [255, 0, 0],
  [0, 255, 0],
  [0, 0, 255],
  [255, 255, 0],
];
const SIDE = 32;
/** Red and green above blue and yellow. */
const QUARTERS = paintPng(SIDE, SIDE, (x, y) => {
  const [left, right] = y < SIDE / 2 ? [RED, GREEN] : [BLUE, YELLOW];
  return [...((x < SIDE / 2 ? left : right) as Rgb), 255] as [number, number, number, number];
});

/** A square of one metre before a camera that sees nothing else, and the middles of its quarters: above left to right, then below. */
const SCENE = `
  import * as THREE from "three";
  import { PaintedMesh } from "texelcast/three";
  let renderer = new THREE.WebGLRenderer();
  renderer.setSize(64, 64);
  const camera = new THREE.OrthographicCamera(-0.5, 0.5, 0.5, -0.5, 0, 10);
  camera.position.z = 1;
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(1, 1), new THREE.MeshBasicMaterial());
  const world = new THREE.Scene().add(mesh);
  const bytes = async (address) => await (await fetch(address)).arrayBuffer();
  const picture = new Uint8Array(await bytes("/quarters.png"));
  const base = { name: "quarters.png", bytes: picture };
  const map = await new THREE.TextureLoader().loadAsync("/quarters.png");
  map.colorSpace = THREE.SRGBColorSpace;
  const quarters = () => {
    renderer.render(world, camera);
    const gl = renderer.getContext();
    return [[16, 48], [48, 48], [16, 16], [48, 16]].map(([x, y]) => {
      const rgba = new Uint8Array(4);
      gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
      return [...rgba.subarray(0, 3)];
    });
  };
`;

let installed: InstalledPackage;
let browser: Browser;
let server: StaticServer;

beforeAll(async () => {
  installed = await installPackage();
  installed.provide("three");
  addShopFiles(installed.folder, { "quarters.png": QUARTERS, "white.png": solidPng(2, 2, [255, 255, 255, 255]) });
  server = await serveFolder(installed.folder);
  browser = await openBrowser();
});
afterAll(async () => {
  await browser?.close();
  await server?.stop();
  installed?.remove();
});

let pages = 0;

/** What a script's lines after the scene put into `story`, in a page of their own. */
async function tell(lines: string): Promise<unknown> {
  const name = `story-${++pages}`;
  addShopFiles(installed.folder, {
    [`${name}.html`]: `<!doctype html><html lang="en"><title>Scene</title><link rel="icon" href="data:," />
<script type="importmap">{ "imports": {
  "three": "/node_modules/three/build/three.module.js",
  "three/addons/": "/node_modules/three/examples/jsm/",
  "texelcast/three": "/node_modules/texelcast/dist/three.js"
} }</script>
<script type="module" src="/${name}.js"></script></html>`,
    [`${name}.js`]: `async function tell() { ${lines} }
${SCENE}
tell().then((told) => { globalThis.story = told; }, (error) => { globalThis.story = String(error?.stack ?? error); });`,
  });
  const { page } = await openPage(browser, `${server.origin}/${name}.html`);
  await page.waitForFunction(() => "story" in globalThis, null, { timeout: 50_000 });
  const story = await page.evaluate(() => (globalThis as unknown as { story: unknown }).story);
  await page.close();
  return story;
}

/** The square with a material, as three.js shows it and as it is painted on that picture, with a decal on its quarter above left. */
const painted = (material: string): Promise<unknown> =>
  tell(`
    ${material}
    Object.assign(mesh.material, { map, needsUpdate: true });
    const before = quarters();
    const painted = await PaintedMesh.create(renderer, mesh, { size: 64, base });
    await painted.idle();
    const after = quarters();
    await painted.setPicture("white", await bytes("/white.png"));
    const place = { position: [-0.25, 0.25, 0], rotation: [0, 0, 0, 1], size: [0.4, 0.4, 0.1] };
    painted.setDecals([{ id: "d", picture: "white", ...place }]);
    await painted.idle();
    const decalled = quarters();
    painted.dispose();
    return { before, after, decalled, again: quarters() };`);

test("a picture from three.js's own loader lies under the decals as it lay on the mesh", async () => {
  const before = [RED, GREEN, BLUE, YELLOW];
  expect(await painted("")).toEqual({
    before,
    after: before,
    decalled: [[255, 255, 255], GREEN, BLUE, YELLOW],
    again: before,
  });
});

test.each([
  [
    "shifted and turned",
    "map.wrapS = map.wrapT = THREE.RepeatWrapping; map.offset.set(0.5, 0); map.rotation = Math.PI / 2;",
  ],
  [
    "on the geometry's second UV set",
    `const second = mesh.geometry.getAttribute("uv").clone();
    for (let i = 0; i < 4; i++) second.setX(i, 1 - second.getX(i));
    mesh.geometry.setAttribute("uv1", second);
    map.channel = 1;`,
  ],
  ["of glTF's form, from above to below", "map.flipY = false; map.needsUpdate = true;"],
  [
    "that is an ImageBitmap, which three.js does not turn",
    "map.image = await createImageBitmap(map.image); map.needsUpdate = true;",
  ],
  ["under a colour of the material", "mesh.material.color.set('#808080');"],
])("a picture %s lies under the decals as it lay on the mesh", async (_how, lines) => {
  const told = (await painted(lines)) as Record<"before" | "after" | "decalled", readonly Rgb[]>;
  expect(told.before).not.toEqual([RED, GREEN, BLUE, YELLOW]);
  expect(told.after).toEqual(told.before);
  expect(told.decalled.slice(1)).toEqual(told.before.slice(1));
  expect(told.decalled[0]).not.toEqual(told.before[0]);
});

test("after the graphics were lost, the mesh has its decals again, and those that were set meanwhile", async () => {
  const story = await tell(`
    const painted = await PaintedMesh.create(renderer, mesh, { size: 64, base });
    await painted.setPicture("white", await bytes("/white.png"));
    const flat = { rotation: [0, 0, 0, 1], size: [0.4, 0.4, 0.1], picture: "white" };
    painted.setDecals([{ id: "a", ...flat, position: [-0.25, 0.25, 0] }]);
    await painted.idle();
    const before = quarters();
    const lost = renderer.getContext().getExtension("WEBGL_lose_context");
    const told = (name) => new Promise((resolve) => renderer.domElement.addEventListener(name, resolve, { once: true }));
    picture.fill(0);
    const gone = told("webglcontextlost");
    lost.loseContext();
    await gone;
    painted.setDecals([{ id: "a", ...flat, position: [0.25, 0.25, 0] }]);
    await painted.idle();
    const back = told("webglcontextrestored");
    setTimeout(() => lost.restoreContext());
    await back;
    await painted.idle();
    const after = quarters();
    return { before, after };`);
  const white: Rgb = [255, 255, 255];
  // A picture counts its rows from above, the square's texture coordinates from below.
  expect(story).toEqual({ before: [white, YELLOW, RED, GREEN], after: [BLUE, white, RED, GREEN] });
});

test("the guide's lines lay a decal upright where a ray hits, on a mesh that is turned, moved and scaled", async () => {
  addShopFiles(installed.folder, { "placed-at.js": guideFile("placed-at.js") });
  const story = await tell(`
    const { placedAt } = await import("/placed-at.js");
    const turned = new THREE.Group().add(mesh);
    turned.rotation.z = Math.PI / 2;
    mesh.scale.set(2, 2, 2);
    mesh.position.set(0.5, 0, 0);
    world.add(turned).updateMatrixWorld(true);
    mesh.material.color.set("#ffffff");
    const painted = await PaintedMesh.create(renderer, mesh, { size: 128, base: [1, 1, 1, 1] });
    await painted.setPicture("quarters", picture);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2(0, 0), camera);
    const [hit] = ray.intersectObject(mesh);
    painted.setDecals([{ id: "d", picture: "quarters", size: [0.5, 0.5, 0.1], ...placedAt(hit, mesh, camera) }]);
    await painted.idle();
    return quarters();`);
  expect(story).toEqual([RED, GREEN, BLUE, YELLOW]);
});

test("triangles beyond a geometry's draw range, which nobody sees, hide no decal", async () => {
  const story = await tell(`
    const [back, front] = [new THREE.PlaneGeometry(1, 1), new THREE.PlaneGeometry(1, 1).translate(0, 0, 0.02)].map((plane) => plane.toNonIndexed());
    const joined = (name) => [...back.getAttribute(name).array, ...front.getAttribute(name).array];
    mesh.geometry = new THREE.BufferGeometry();
    mesh.geometry.setAttribute("position", new THREE.Float32BufferAttribute(joined("position"), 3));
    mesh.geometry.setAttribute("uv", new THREE.Float32BufferAttribute(joined("uv"), 2));
    mesh.geometry.setDrawRange(0, 6);
    mesh.material.color.set("#ff0000");
    const painted = await PaintedMesh.create(renderer, mesh, { size: 64 });
    await painted.setPicture("white", await bytes("/white.png"));
    painted.setDecals([{ id: "d", picture: "white", position: [-0.25, 0.25, 0], rotation: [0, 0, 0, 1], size: [0.4, 0.4, 0.1] }]);
    await painted.idle();
    return quarters();`);
  expect(story).toEqual([[255, 255, 255], RED, RED, RED]);
});

test.each([
  ["another wrapping", "painted.texture.wrapS = THREE.ClampToEdgeWrapping; painted.texture.needsUpdate = true;"],
  [
    "other filters",
    "painted.texture.minFilter = THREE.LinearFilter; painted.texture.anisotropy = 2; painted.texture.needsUpdate = true;",
  ],
  ["a disposal on the GPU", "painted.texture.dispose();"],
  ["the renderer's own disposal", "renderer.dispose();"],
])("the mesh keeps its decals after %s, and gets the next ones", async (_what, lines) => {
  const story = await tell(`
    mesh.material.color.set("#ff0000");
    const painted = await PaintedMesh.create(renderer, mesh, { size: 50 });
    await painted.setPicture("white", await bytes("/white.png"));
    const place = { id: "d", picture: "white", rotation: [0, 0, 0, 1], size: [0.4, 0.4, 0.1] };
    painted.setDecals([{ ...place, position: [-0.25, 0.25, 0] }]);
    await painted.idle();
    quarters();
    ${lines}
    const kept = quarters();
    painted.setDecals([{ ...place, position: [0.25, -0.25, 0] }]);
    await painted.idle();
    return { kept, moved: quarters() };`);
  const white: Rgb = [255, 255, 255];
  expect(story).toEqual({ kept: [white, RED, RED, RED], moved: [RED, RED, RED, white] });
});

test("a second renderer shows the decals, and three.js's exporter writes them", async () => {
  const story = await tell(`
    const { GLTFExporter } = await import("three/addons/exporters/GLTFExporter.js");
    mesh.material = new THREE.MeshStandardMaterial({ color: "#ff0000" });
    const painted = await PaintedMesh.create(renderer, mesh, { size: 50 });
    await painted.setPicture("white", await bytes("/white.png"));
    painted.setDecals([{ id: "d", picture: "white", rotation: [0, 0, 0, 1], size: [0.4, 0.4, 0.1], position: [-0.25, 0.25, 0] }]);
    await painted.idle();
    const glb = await new GLTFExporter().parseAsync(world, { binary: true });
    mesh.material = new THREE.MeshBasicMaterial({ map: painted.texture });
    renderer = new THREE.WebGLRenderer();
    renderer.setSize(64, 64);
    return { shown: quarters(), exported: glb.byteLength > 500 };`);
  expect(story).toEqual({ shown: [[255, 255, 255], RED, RED, RED], exported: true });
});

test("a material that patches its shader keeps its patch under the decals", async () => {
  const story = await tell(`
    mesh.material.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace("#include <opaque_fragment>", "outgoingLight.g = 0.0;\\n#include <opaque_fragment>");
    };
    const before = quarters();
    const painted = await PaintedMesh.create(renderer, mesh, { size: 64 });
    await painted.idle();
    return { before, after: quarters() };`);
  const quarters = [1, 2, 3, 4].map(() => [255, 0, 255]);
  expect(story).toEqual({ before: quarters, after: quarters });
});

const triangle = (fields: string): string =>
  `PaintedMesh.create(renderer, new THREE.Mesh(Object.entries(${fields}).reduce(
    (geometry, [name, [size, ...values]]) => geometry.setAttribute(name, new THREE.Float32BufferAttribute(values, size)),
    new THREE.BufferGeometry()), mesh.material))`;
const onMesh = (lines: string): string =>
  `PaintedMesh.create(renderer, mesh, { size: 64 }).then(async (painted) => { ${lines} })`;
const badArgument = (field: string, value?: string) => ({ code: "bad-argument", field, ...(value && { value }) });

test.each([
  [
    "another renderer",
    "PaintedMesh.create({ isWebGPURenderer: true }, mesh)",
    { code: "unsupported", field: "renderer" },
  ],
  ["a group", "PaintedMesh.create(renderer, new THREE.Group())", badArgument("mesh", "Group")],
  ["no mesh", "PaintedMesh.create(renderer)", badArgument("mesh", "undefined")],
  [
    "a mesh of several materials",
    "PaintedMesh.create(renderer, new THREE.Mesh(mesh.geometry, [mesh.material]), { base: [1, 1, 1, 1] })",
    badArgument("material"),
  ],
  ["null for options", "PaintedMesh.create(renderer, mesh, null)", badArgument("options", "null")],
  ["a size that is none", "PaintedMesh.create(renderer, mesh, { size: Number.NaN })", badArgument("size", "NaN")],
  ["a size beyond the largest", "PaintedMesh.create(renderer, mesh, { size: 1e6 })", badArgument("size", "1000000")],
  [
    "a base whose bytes are none",
    "PaintedMesh.create(renderer, mesh, { base: { name: 'a.png', bytes: picture.buffer } })",
    badArgument("bytes", "[object ArrayBuffer]"),
  ],
  [
    "a Blob as base",
    "PaintedMesh.create(renderer, mesh, { base: new Blob([picture]) })",
    badArgument("name", "[object Undefined]"),
  ],
  ["a geometry without uv", triangle("{ position: [3, 0, 0, 0, 1, 0, 0, 0, 1, 0] }"), badArgument("uv")],
  [
    "a uv of fewer vertices",
    triangle("{ position: [3, 0, 0, 0, 1, 0, 0, 0, 1, 0], uv: [2, 0, 0, 1, 0] }"),
    badArgument("uv", "2"),
  ],
  [
    "a normal of fewer vertices",
    triangle("{ position: [3, 0, 0, 0, 1, 0, 0, 0, 1, 0], uv: [2, 0, 0, 1, 0, 0, 1], normal: [3, 0, 0, 1] }"),
    badArgument("normal", "1"),
  ],
  [
    "a Blob as picture",
    onMesh("await painted.setPicture('a', new Blob([picture]));"),
    badArgument("bytes", "[object Blob]"),
  ],
  ["no picture", onMesh("await painted.setPicture('a');"), badArgument("bytes", "[object Undefined]")],
  ["no list of decals", onMesh("painted.setDecals(null);"), badArgument("decals", "null")],
  ["a decal that is none", onMesh("painted.setDecals([null]);"), badArgument("decals[0]", "null")],
])("%s is refused by its name", async (_what, call, refused) => {
  const story = await tell(`
    const { material } = mesh;
    const told = await (async () => ${call})().then(String, (error) => ({ ...error, name: error.name }));
    return { told, isSame: mesh.material === material || told.field.startsWith("decals") || told.field === "bytes" };`);
  expect(story).toMatchObject({ told: { name: "TexelcastError", ...refused }, isSame: true });
});
