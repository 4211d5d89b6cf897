/** Where a decal is, which way it looks, and how large it is. */
import { html, nothing, type TemplateResult } from "lit";
import { Link2, Ratio, Unlink2 } from "lucide";
import type { PlanarProjector, Projector, Vec3 } from "../../engine/engine-api.ts";
import { boundedLength } from "../document/bounded-length.ts";
import { DESIGN_LIMITS } from "../document/design-limits.ts";
import type { DecalLayer, TextLayer } from "../document/index.ts";
import type { LayerPatch } from "../state/layer-commands.ts";
import { type Orientation, orientationOf } from "../state/rotation.ts";
import { icon } from "../ui/icon.ts";
import {
  type PosedProjector,
  type ProjectorFieldGroup,
  poseFields,
  projectorFields,
  withAxis,
} from "./projector-fields.ts";
import { lengthStep, numberField, type PropertyContext, record, recordedOf, sharedTitle } from "./property-controls.ts";

/** What the fields remember from one render to the next. */
export interface PlacementMemory {
  /** Width and height change together. */
  proportional: boolean;
  /** The direction last shown: straight up and down it keeps the heading that the rotation alone has lost. */
  orientation: Orientation | undefined;
}

/**
 * @param aspect Width by height of the layer's picture; null where it has none of its own.
 * @param changed Called when the memory was changed, so that the fields are shown anew.
 */
export function placementFields(
  context: PropertyContext,
  layer: DecalLayer | TextLayer,
  aspect: number | null,
  memory: PlacementMemory,
  changed: () => void,
): TemplateResult {
  const words = context.editor.strings.properties;
  const step = lengthStep(context.state);
  const { projector } = layer;
  const recorded = recordedOf(context, layer).projector;
  return html`
    <section role="group" aria-label=${words.placement}>
      ${projector.kind === "uv" ? nothing : pose(context, projector, step, memory)}
      ${
        projector.kind === "planar"
          ? size(context, projector, recorded, step, aspect, memory, changed)
          : projectorFields(projector, step, words, recorded).map((group) => fieldGroup(context, group))
      }
    </section>
  `;
}

/** What is moved by numbers paints what it comes to lie on, as what is dragged there does. */
const placed = ({ editor, ids }: PropertyContext, projector: Projector): LayerPatch =>
  editor.decals.placed(ids[0] as string, projector);

function pose(
  context: PropertyContext,
  projector: PosedProjector,
  step: number,
  memory: PlacementMemory,
): TemplateResult[] {
  memory.orientation = orientationOf(projector.rotation, memory.orientation);
  const keep = (orientation: PlacementMemory["orientation"]): void => {
    memory.orientation = orientation;
  };
  const groups = poseFields(projector, step, memory.orientation, keep, context.editor.strings.properties);
  return groups.map((group) => fieldGroup(context, group));
}

function fieldGroup(context: PropertyContext, { title, fields }: ProjectorFieldGroup): TemplateResult {
  return html`
    ${fields.length === 3 ? sharedTitle(context, title, fields[0]?.unit) : html`<h3>${title}</h3>`}
    <div class=${fields.length === 3 ? "three" : "two"}>
      ${fields.map(({ set, ...field }) =>
        numberField(context, title, { ...field, patch: (value) => placed(context, set(value) as Projector) }),
      )}
    </div>
  `;
}

function size(
  context: PropertyContext,
  projector: PlanarProjector,
  recorded: Projector,
  step: number,
  aspect: number | null,
  memory: PlacementMemory,
  changed: () => void,
): TemplateResult {
  const words = context.editor.strings.properties;
  const { size: before } = recorded.kind === "planar" ? recorded : projector;
  const resized = (axis: 0 | 1 | 2, value: number): LayerPatch => {
    const resizedAxis = withAxis(before, axis, value);
    const other = axis === 0 ? 1 : 0;
    const linked = memory.proportional && axis !== 2;
    const bounded = boundedLength((before[other] * value) / before[axis]);
    return placed(context, { ...projector, size: linked ? withAxis(resizedAxis, other, bounded) : resizedAxis });
  };
  const field = (axis: 0 | 1 | 2, side: "width" | "height" | "depth", hint = "") =>
    numberField(context, words.size, {
      label: words.sizeLetters[side],
      name: words.axis(words.size, words[side]),
      hint,
      value: projector.size[axis],
      step,
      isLength: true,
      // The least that the field shows as something.
      min: Math.max(step / 10, DESIGN_LIMITS.lengthMin),
      patch: (value) => resized(axis, value),
    });
  const own = aspect ?? projector.size[0] / projector.size[1];
  const reset = (): void => {
    const [width, , depth] = projector.size;
    const natural: Vec3 = [width, width / own, depth];
    record(context, words.size, placed(context, { ...projector, size: natural }));
  };
  const distorted = Math.abs(projector.size[0] / projector.size[1] / own - 1) > 1e-3;
  return html`
    <div class="titled">
      ${sharedTitle(context, words.size)}
      ${
        distorted
          ? html`<button class="icon small" id="reset-proportions" aria-label=${words.resetProportions} title=${words.resetProportions} @click=${reset}>
              ${icon(Ratio)}
            </button>`
          : nothing
      }
      <button
        class="icon small"
        id="proportional"
        aria-pressed=${memory.proportional}
        aria-label=${words.keepProportions}
        title=${words.keepProportions}
        @click=${() => {
          memory.proportional = !memory.proportional;
          changed();
        }}
      >
        ${icon(memory.proportional ? Link2 : Unlink2)}
      </button>
    </div>
    <div class="three">${field(0, "width")}${field(1, "height")}${field(2, "depth", words.depthHint)}</div>
  `;
}
