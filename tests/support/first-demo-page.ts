/** For the driver's `page.evaluate`, on the page that shows its first demo: they run there and use nothing from outside themselves. */

/** Where the demo's decal stands on the page, in client pixels, and on the model. */
export function decalPlaceInPage() {
  const [layer] = window.texelcast.design().layers;
  if (layer?.type !== "decal" || layer.projector.kind !== "planar") throw new Error("The mug has no decal.");
  const point = window.texelcast.project(...layer.projector.position);
  if (!point) throw new Error("The decal is not in view.");
  return { ...point, position: layer.projector.position };
}

export async function settledHashInPage(): Promise<string> {
  await window.texelcast.idle();
  return window.texelcast.hash();
}

export function lowestLayerInPage(): string {
  const [layer] = window.texelcast.design().layers;
  if (!layer) throw new Error("The page's design has no layer.");
  return layer.id;
}
