/**
 * A model as USDZ, which iPhones and iPads show in the room (Quick Look), the textures as they are in the file: what is seen there
 * is what is printed. three.js has a writer of USDZ, too; it draws every texture on a canvas, which changes texels and which Node
 * has not, and leaves skins and morph targets out.
 */
import { Accessors } from "../accessors.ts";
import { layAsStored } from "../as-stored.ts";
import { parseJson, readContainer } from "../gltf-container.ts";
import { joinBytes } from "../join-bytes.ts";
import { loadModelFile } from "../model-loader.ts";
import { posedParts } from "./posed-parts.ts";
import { type UsdMaterial, usdMaterial } from "./usd-material.ts";
import { usdMesh } from "./usd-mesh.ts";
import { UsdPictures } from "./usd-pictures.ts";
import { packUsdz } from "./usdz-archive.ts";

/**
 * The model at rest: no animation, cameras or lights. `glb` is self-contained and may hold whatever models may; it is taken over.
 * The same bytes in the browser and in Node. Throws as `loadModelFile`, and "bad-picture" for a picture that has to be written anew.
 */
export async function writeUsdz(glb: Uint8Array, name: string): Promise<Uint8Array<ArrayBuffer>> {
  const { glb: readable } = await loadModelFile({ name, bytes: glb }, true);
  layAsStored(readable, name);
  const container = readContainer({ name, bytes: readable });
  const json = parseJson(container);
  const accessors = new Accessors(json, container.binary, name);
  const pictures = new UsdPictures(json, container.binary, name);
  const materials = new Map<number, UsdMaterial>();
  const pieces: Uint8Array[] = [utf8(HEADER)];
  let count = 0;
  for (const part of posedParts(json, accessors, name)) {
    let material = materials.get(part.material);
    if (material === undefined) {
      material = usdMaterial(json, part.material, pathOf(part.material), (image) => pictures.pathOf(image), name);
      materials.set(part.material, material);
    }
    pieces.push(
      utf8(`${usdMesh(part, material, pathOf(part.material), `Mesh_${count++}`).map(indented).join("\n")}\n`),
    );
  }
  const lines = [...materials.values()].flatMap((material) => material.lines);
  pieces.push(utf8(`${['def Scope "Materials"', "{", ...lines.map(indented), "}"].map(indented).join("\n")}\n}\n`));
  return packUsdz([{ path: "model.usda", bytes: joinBytes(pieces) }, ...(await pictures.files())]);
}

const utf8 = (text: string): Uint8Array => new TextEncoder().encode(text);
const indented = (line: string): string => `    ${line}`;
const pathOf = (material: number): string => `/Model/Materials/Material_${material}`;

const HEADER = `#usda 1.0
(
    customLayerData = {
        string creator = "Texelcast"
    }
    defaultPrim = "Model"
    metersPerUnit = 1
    upAxis = "Y"
)

def Xform "Model" (
    kind = "component"
)
{
`;
