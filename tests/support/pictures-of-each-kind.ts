/** Pictures of each kind that is read, small, for browsers that decode them as Node does. */
import { avifFile } from "./avif-file.ts";
import { jpegOf, webpOf } from "./encoded-pictures.ts";
import { curves, iccChunk, jpegWith, PRIMARIES, rgbProfile } from "./icc-profile.ts";
import { makePng } from "./png-file.ts";
import { turnedPictures } from "./turned-pictures.ts";

/** What can be sent into a page. */
export interface SentPicture {
  readonly name: string;
  readonly base64: string;
}

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" width="120" height="60">
  <circle cx="30" cy="30" r="28" fill="#c2410c"/><text x="50" y="40" font-family="Lobster" font-size="30">Ahoy</text></svg>`;

const [WIDTH, HEIGHT] = [48, 32];

/** Eight of them: with 16 bits a channel and a profile, turned by EXIF, with and without losses, drawn. */
export async function picturesOfEachKind(): Promise<readonly SentPicture[]> {
  const rgba = Uint8Array.from({ length: WIDTH * HEIGHT * 4 }, (_, at) => (at % 4 === 3 ? 255 : (at * 37) % 256));
  const picture = { width: WIDTH, height: HEIGHT, rgba };
  const profile = rgbProfile(PRIMARIES.displayP3, curves.gamma(2.2));
  const rows = Array.from({ length: HEIGHT }, (_, y) =>
    Array.from({ length: WIDTH * 8 }, (__, x) => (x * 41 + y * 13) % 256),
  );
  const deep = makePng({ width: WIDTH, height: HEIGHT, bitDepth: 16, colorType: 6, rows, extra: [iccChunk(profile)] });
  const turned = (await turnedPictures()).map(
    ({ mimeType, bytes }) => [`turned.${mimeType.slice("image/".length)}`, bytes] as const,
  );
  const files = [
    ["deep.png", deep],
    ...turned,
    ["photo.jpg", jpegWith(await jpegOf(picture, 80), profile)],
    ["photo.webp", await webpOf(picture, 70)],
    ["gradient.avif", await avifFile(picture, 70)],
    ["ahoy.svg", Buffer.from(DRAWING)],
  ] as const;
  return files.map(([name, bytes]) => ({ name, base64: Buffer.from(bytes).toString("base64") }));
}

/** For the driver's `page.evaluate`: puts them one above the other on the mug of `element.html`, and words under them. */
export async function addPicturesInPage(files: readonly SentPicture[]): Promise<void> {
  await customElements.whenDefined("texelcast-editor");
  const element = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
  for (const [place, { name, base64 }] of files.entries()) {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    await element.addDecal(new File([bytes], name), { position: [0, 0.025 + 0.008 * place, 0.04], width: 0.02 });
  }
  await element.addText("Moin שלום नमस्ते", { position: [0, 0.02, 0.04] });
}
