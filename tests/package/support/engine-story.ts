/** The same short story for every way to use the engine: a mug, a decal in front, the hash of the texture. */
import { readFileSync } from "node:fs";
import { parseDesign } from "../../../web/editor/document/parse-design.ts";
import { resolveLayers } from "../../../web/editor/document/resolve-layers.ts";
import { createEngineHost } from "../../../web/engine/engine-host.ts";
import { CHECKOUT } from "./installed.ts";

const SIZE = 256;

/** A design as a shop might keep it; the picture is handed over by the page. */
export const DESIGN = {
  format: "texelcast-design",
  version: 1,
  assets: { logo: { uri: "logo.png", type: "image/png" } },
  layers: [
    {
      type: "decal",
      id: "logo",
      material: 0,
      asset: "logo",
      projector: { kind: "planar", position: [0, 0.05, 0.04], rotation: [0, 0, 0, 1], size: [0.05, 0.05, 0.08] },
    },
  ],
};

/**
 * A script that runs the story and puts the hash into `globalThis.story`, or what went wrong.
 * @param core what the script imports @param options for `createEngine`, as source text
 */
export const storyScript = (core: string, options = "{}"): string => `
import { createEngine, parseDesign, resolveLayers } from ${JSON.stringify(core)};
const bytes = async (address) => new Uint8Array(await (await fetch(address)).arrayBuffer());
async function story() {
  const engine = createEngine(${options});
  await engine.loadModel({ name: "mug.glb", bytes: await bytes("/mug.glb") });
  await engine.setAsset("logo", { name: "logo.png", bytes: await bytes("/logo.png") });
  await engine.openTarget({ material: 0, width: ${SIZE}, height: ${SIZE} });
  const design = parseDesign(await (await fetch("/design.json")).text(), "design.json");
  engine.setLayers(resolveLayers(design), 1);
  const hash = await engine.hash(0);
  engine.dispose();
  return hash;
}
story().then((hash) => { globalThis.story = hash; }, (error) => { globalThis.story = String(error?.stack ?? error); });
`;

/**
 * A script that opens the element, puts words and then a picture on a mug, and tells the hash of its texture as the other does:
 * the engine loads parts of itself on the way.
 * @param define what the script imports
 */
export const wordsScript = (define: string): string => `
import ${JSON.stringify(define)};
const editor = document.createElement("texelcast-editor");
editor.style.cssText = "display: block; inline-size: 600px; block-size: 500px";
Object.assign(editor, { src: "/mug.glb", loading: "eager", size: ${SIZE} });
async function story() {
  document.body.append(editor);
  await editor.start();
  await editor.addText("Hi");
  await editor.addDecal("/logo.png");
  return (await editor.exportTexture()).sha256;
}
story().then((hash) => { globalThis.story = hash; }, (error) => { globalThis.story = String(error?.stack ?? error); });
`;

export const STORY_FILES = {
  "logo.png": readFileSync(`${CHECKOUT}build/public/demo/decals/badge.png`),
  "design.json": JSON.stringify(DESIGN),
};

/** What the story must give, by the engine's own sources in Node. */
export async function storyHash(): Promise<string> {
  const engine = createEngineHost();
  await engine.loadModel({ name: "mug.glb", bytes: readFileSync(`${CHECKOUT}build/public/demo/mug.glb`) });
  await engine.setAsset("logo", { name: "logo.png", bytes: STORY_FILES["logo.png"] });
  await engine.openTarget({ material: 0, width: SIZE, height: SIZE });
  engine.setLayers(resolveLayers(parseDesign(STORY_FILES["design.json"], "design.json")), 1);
  const hash = await engine.hash(0);
  engine.dispose();
  return hash;
}
