/** How far textures are sampled along what slopes away from the eye. */
import type { WebGLRenderer } from "three";

/** More is not seen on painted colours, and costs fill rate. Three asks for no more than there is. */
const ENOUGH = 8;

const known = new WeakMap<WebGLRenderer, number>();

/**
 * The anisotropy of painted textures. 1, which is none, with Mesa's llvmpipe, which draws where there is no graphics card: over a triangle that is
 * seen from nearly its edge it sums texels without end. One picture of a mug from below took it 4 to 7 s instead of 0.3, and 3 s with an anisotropy of 2.
 *
 * Kept for the renderer: asked for once a model is being drawn, the page's thread would wait for the GPU until it is.
 */
export function anisotropyFor(renderer: WebGLRenderer): number {
  const anisotropy = known.get(renderer) ?? (/llvmpipe/.test(graphicsName(renderer.getContext())) ? 1 : ENOUGH);
  known.set(renderer, anisotropy);
  return anisotropy;
}

/** Firefox says it at once, and warns of the extension behind which others keep it. */
function graphicsName(gl: WebGLRenderingContext | WebGL2RenderingContext): string {
  // Nothing, where the graphics are lost.
  const name = String(gl.getParameter(gl.RENDERER));
  const info = name.startsWith("WebKit") && gl.getExtension("WEBGL_debug_renderer_info");
  return info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : name;
}
