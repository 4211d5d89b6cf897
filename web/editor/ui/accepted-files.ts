/** What the browser's own dialog offers, as the `accept` attribute of a file input. */
import { PICTURES } from "./file-picker.ts";

export const ACCEPT = {
  model: ".glb,.gltf,.texelcast,.bin,.png,.jpg,.jpeg,.webp,.avif",
  picture: PICTURES,
  font: ".ttf,.otf,font/ttf,font/otf",
  design: ".json,.texelcast,.png,.jpg,.jpeg,.webp,.avif,.svg,.ttf,.otf",
  any: ".texelcast,.glb,.gltf,.bin,.json,.png,.jpg,.jpeg,.webp,.avif,.svg",
} as const;
