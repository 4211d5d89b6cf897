import type { ModelRef } from "./design-state.ts";

/** A model that takes the place of another one, which it was made of: it has its title, and is no demo's any more. */
export const changedModel = ({ source, title }: ModelRef, glb: Uint8Array<ArrayBuffer>): ModelRef => ({
  source: { name: source.name.replace(/\.(gltf|glb)$/i, "").concat(".glb"), bytes: glb },
  title,
  demoId: null,
});
