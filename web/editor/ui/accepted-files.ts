/** What the browser's own dialog offers, as the `accept` attribute of a file input. */
import { PICTURES } from "./file-picker.ts";

export const ACCEPT = {
  model: ".glb,.gltf,.zip,.texelcast,.bin,.png,.jpg,.jpeg,.webp,.avif",
  picture: PICTURES,
  font: ".ttf,.otf,font/ttf,font/otf",
  design: ".json,.texelcast,.zip,.png,.jpg,.jpeg,.webp,.avif,.svg,.ttf,.otf",
  any: ".texelcast,.zip,.glb,.gltf,.bin,.json,.png,.jpg,.jpeg,.webp,.avif,.svg",
} as const;
