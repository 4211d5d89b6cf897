/** In which colour new letters can be read where they lie. */
import type { Engine, Projector, Vec3 } from "../../engine/engine-api.ts";
import { plus, turned } from "../document/rigid-motion.ts";
import type { DesignState } from "./design-state.ts";
import type { MaskSurface } from "./remembered-surface.ts";

/** Places along the words. */
const PLACES = 5;
/** The relative luminance (WCAG 2.2) from which on near-black letters have more contrast than white ones. */
const LIGHT = 0.2;
const WHITE = "#ffffff";
const WEIGHTS = [0.2126, 0.7152, 0.0722];

/** What is painted, and how large its textures are. */
interface Painted {
  readonly engine: Pick<Engine, "readTexels">;
  readonly store: { readonly state: Pick<DesignState, "targets"> };
}

/** White where the product is dark under most of the words. Null where it is not, or nothing is known of it. */
export async function legibleColor(
  { engine, store }: Painted,
  surface: Pick<MaskSurface, "near">,
  projector: Projector,
): Promise<string | null> {
  if (projector.kind !== "planar") return null;
  const { position, rotation, size } = projector;
  const isDark = async (place: Vec3): Promise<boolean | null> => {
    const hit = surface.near(place);
    const target = store.state.targets.get(hit?.material ?? -1);
    if (!hit || !target) return null;
    const [x, y] = [hit.uv[0] * target.width, hit.uv[1] * target.height].map(Math.floor) as [number, number];
    return luminance(await engine.readTexels(hit.material, x, y, 1, 1)) < LIGHT;
  };
  const places = Array.from({ length: PLACES }, (_, index) => (index / (PLACES - 1) - 0.5) * size[0]);
  const found = await Promise.all(
    places.map((along) => isDark(plus(position, turned(rotation, [along, 0, 0]))).catch(() => null)),
  );
  const count = (which: boolean): number => found.filter((each) => each === which).length;
  return count(true) > count(false) ? WHITE : null;
}

/** Of an sRGB colour, each channel 0 to 255. */
function luminance(rgba: Uint8Array): number {
  return WEIGHTS.reduce((sum, weight, channel) => {
    const share = (rgba[channel] ?? 0) / 255;
    return sum + weight * (share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4);
  }, 0);
}
