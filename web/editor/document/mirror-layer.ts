/**
 * Layers painted a second time, as a mirror across a plane of the model shows them. Mirroring a quaternion only changes
 * signs and places of its parts, so that it costs no digit.
 */

import type { EngineDab, EngineDecalLayer, EngineStrokeLayer } from "../../engine/engine-api.ts";
import { type DesignLayer, isPlaced, type Mirror, type Projector, type Quaternion, type Vec3 } from "./design.ts";
import { carriedPose, product } from "./rigid-motion.ts";

/**
 * The projector as the mirror shows it. A projector cannot be left-handed: its picture, left and right exchanged, is what
 * the mirror shows. Null for "uv" projectors, which lie on no side of the model.
 */
export function mirroredProjector<P extends Projector>(projector: P, mirror: Mirror): P | null {
  if (projector.kind === "uv") return null;
  return {
    ...projector,
    position: mirroredPoint(projector.position, mirror),
    rotation: mirroredRotation(projector.rotation, mirror),
  };
}

/** Whether a layer, or a dab of it, lies on the texture and so on no side of the model: such a one has no mirror. */
export function liesOnTexture(layer: DesignLayer): boolean {
  if (isPlaced(layer)) return layer.projector.kind === "uv";
  if (layer.type === "paint") return layer.strokes.some(liesOnTexture);
  return layer.type === "stroke" && layer.dabs.some(({ kind }) => kind === "uv");
}

function mirroredPoint([x, y, z]: Vec3, { axis, offset }: Mirror): Vec3 {
  if (axis === "x") return [2 * offset - x, y, z];
  return axis === "y" ? [x, 2 * offset - y, z] : [x, y, 2 * offset - z];
}

/**
 * M R F: M the mirror, F the exchange of the picture's left and right. With M across x the two meet as a change of
 * signs; across y a half turn about the picture's Z is left over, across z one about its Y.
 */
function mirroredRotation([x, y, z, w]: Quaternion, { axis, readable }: Mirror): Quaternion {
  if (axis === "x") return [x, -y, -z, w];
  if (axis === "z") return product([-x, -y, z, w], [0, 1, 0, 0]);
  // A picture that stays as it is would stand on its head here: another half turn about Z takes the first one back.
  const turned: Quaternion = [-x, y, -z, w];
  return readable ? turned : product(turned, [0, 0, 1, 0]);
}

/** A mirror for what is in the mask of a layer that it shows a second time: the twin is masked as the layer is. */
export interface MaskMirror extends Mirror {
  /** That layer's projector. A picture that stays readable is carried to its twin's place, and so is what masks it. */
  readonly of: Projector;
}

/** A decal and its twins as one layer: where they overlap its opacity does not build up. */
export function mirroredDecal(layer: EngineDecalLayer, mirrors: readonly (Mirror | MaskMirror)[]): EngineStrokeLayer {
  const { type: _type, asset, projector, ...fields } = layer;
  const dabs = mirroredDabs([{ ...projector, flow: 1 }], mirrors);
  return { ...fields, type: "stroke", brush: { tip: "picture", asset, color: null, flow: 1 }, dabs };
}

/** By dab and mirror: the engine knows dabs that it has by their being the same objects (`EngineStrokeLayer.dabs`). */
const TWINS = new WeakMap<EngineDab, { readonly mirror: Mirror | MaskMirror; readonly twin: EngineDab }>();

/** Each dab with its twin after it; by several mirrors, with twins of twins. */
export function mirroredDabs(
  dabs: readonly EngineDab[],
  mirrors: readonly (Mirror | MaskMirror)[],
): readonly EngineDab[] {
  return mirrors.reduce<readonly EngineDab[]>(
    (all, mirror) =>
      all.flatMap((dab) => {
        const twin = twinOf(dab, mirror);
        return twin === null ? [dab] : [dab, twin];
      }),
    dabs,
  );
}

function twinOf(dab: EngineDab, mirror: Mirror | MaskMirror): EngineDab | null {
  const known = TWINS.get(dab);
  if (known !== undefined && sameMirror(known.mirror, mirror)) return known.twin;
  const projector = mirror.readable && "of" in mirror ? carriedToTwin(dab, mirror) : mirroredProjector(dab, mirror);
  if (projector === null) return null;
  const twin = mirror.readable ? projector : { ...projector, flipX: !dab.flipX };
  TWINS.set(dab, { mirror, twin });
  return twin;
}

function carriedToTwin(dab: EngineDab, mirror: MaskMirror): EngineDab | null {
  const { of } = mirror;
  const twin = mirroredProjector(of, mirror);
  if (dab.kind === "uv" || of.kind === "uv" || twin === null || twin.kind === "uv") return null;
  return { ...dab, ...carriedPose(of, twin, dab) };
}

export const sameMirror = (a: Mirror | MaskMirror, b: Mirror | MaskMirror): boolean =>
  a.axis === b.axis && a.offset === b.offset && a.readable === b.readable && ofOf(a) === ofOf(b);

/** Of what is not to be readable, it makes no difference what it masks. */
const ofOf = (mirror: Mirror | MaskMirror): Projector | null => (mirror.readable && "of" in mirror ? mirror.of : null);
