/** Whether a layer is painted a second time across a plane of the model. */

import { html, nothing, type TemplateResult } from "lit";
import {
  isPlaced,
  liesOnTexture,
  MIRROR_AXES,
  type Mirror,
  type PaintLayer,
  type PlacedLayer,
  type StrokeLayer,
} from "../document/index.ts";
import type { LayerPatch } from "../state/layer-commands.ts";
import { mirrorPatch, scrubbedMirrorPatch } from "../state/mirror-reach.ts";
import { mirrorOf } from "../tools/mirror-setting.ts";
import { lengthStep, numberField, type PropertyContext, record, recordedOf, toggleField } from "./property-controls.ts";
import { choiceField } from "./property-fields.ts";

type MirroredLayer = PlacedLayer | StrokeLayer | PaintLayer;

/** Nothing for what lies on the texture: that has no side of the model. */
export function mirrorFields(context: PropertyContext, layer: MirroredLayer): TemplateResult | typeof nothing {
  const words = context.editor.strings.projection;
  if (liesOnTexture(layer)) return nothing;
  const { mirror } = layer;
  const patchOf = (made: Mirror | null): LayerPatch => mirrorPatch(context.editor.decals.reach, layer, made);
  const info = context.state.model?.info ?? null;
  const choose = (axis: Mirror["axis"] | "none"): void => {
    // Words that are mirrored with their place cannot be read.
    const first = { axis: "x", offset: 0, readable: layer.type === "text" } as const;
    const made: Mirror | null = axis === "none" ? null : { ...first, ...mirror, ...mirrorOf(axis, info), axis };
    record(context, words.mirror, patchOf(made && mirror ? { ...made, readable: mirror.readable } : made));
  };
  const names = Object.fromEntries(MIRROR_AXES.map((axis) => [axis, axis.toUpperCase()])) as Record<
    Mirror["axis"],
    string
  >;
  return html`
    <section role="group" aria-label=${words.mirror} title=${words.mirrorHint}>
      ${choiceField<Mirror["axis"] | "none">("mirror", words.mirror, { none: words.mirrorNone, ...names }, mirror?.axis ?? "none", choose)}
      ${mirror === null ? nothing : planeFields(context, layer, mirror)}
    </section>
  `;
}

function planeFields(context: PropertyContext, layer: MirroredLayer, mirror: Mirror): TemplateResult {
  const words = context.editor.strings.projection;
  const { reach } = context.editor.decals;
  return html`
    <div class="field">
      <span>${words.mirrorOffset}</span>
      ${numberField(context, words.mirror, {
        label: mirror.axis.toUpperCase(),
        name: words.mirrorOffset,
        hint: words.mirrorOffsetHint,
        value: mirror.offset,
        step: lengthStep(context.state),
        isLength: true,
        patch: (offset) => mirrorPatch(reach, recordedOf(context, layer), { ...mirror, offset }),
        scrubbed: (offset) => scrubbedMirrorPatch(reach, recordedOf(context, layer), { ...mirror, offset }),
      })}
    </div>
    ${
      isPlaced(layer)
        ? toggleField(context, "readable", words.readable, mirror.readable, (readable) => ({
            mirror: { ...mirror, readable },
          }))
        : nothing
    }
  `;
}
