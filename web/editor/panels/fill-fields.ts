/** What a fill layer paints, and of what. */
import { html, nothing, type TemplateResult } from "lit";
import { ArrowRightLeft, MousePointerClick } from "lucide";
import type { Vec3 } from "../../engine/engine-api.ts";
import { DESIGN_LIMITS } from "../document/design-limits.ts";
import { type FillLayer, type Gradient, type GradientStop, materialsOf } from "../document/index.ts";
import { alignedGradient, type ModelAxis, roundGradient } from "../state/aligned-gradient.ts";
import type { LayerPatch } from "../state/layer-commands.ts";
import type { Strings } from "../strings.ts";
import "../ui/gradient-stops.ts";
import { icon } from "../ui/icon.ts";
import { withAxis } from "./projector-fields.ts";
import { colorField, lengthStep, numberField, type PropertyContext, record, sharedTitle } from "./property-controls.ts";
import { choiceField } from "./property-fields.ts";

const MODEL_AXES = ["x", "y", "z"] as const satisfies readonly ModelAxis[];

type FillKind = "color" | Gradient["kind"];

export function fillFields(context: PropertyContext, layer: FillLayer): TemplateResult {
  const words = context.editor.strings.gradient;
  const { strings } = context.editor;
  const { gradient } = layer;
  const kind: FillKind = gradient?.kind ?? "color";
  const choose = (chosen: FillKind): void =>
    record(context, words.kind, { gradient: gradientOfKind(context, chosen, gradient) });
  return html`
    ${choiceField<FillKind>("fill-kind", words.kind, words.kinds, kind, choose)}
    ${
      gradient === null
        ? colorField(context, "color", strings.properties.color, layer.color, (color) => ({ color }))
        : gradientFields(context, gradient)
    }
  `;
}

/** The colours stay when the kind changes. */
function gradientOfKind({ state }: PropertyContext, kind: FillKind, before: Gradient | null): Gradient | null {
  if (kind === "color") return null;
  if (kind === "radial") return roundGradient(state.model, before?.stops);
  return alignedGradient(state.model, "y", before?.stops);
}

/** How a gradient's colours are looked at and chosen where they mean something else: in a mask. */
export interface StopGreys {
  readonly words: Strings["gradient"];
  readonly shown: (stops: readonly GradientStop[]) => readonly GradientStop[];
  readonly meant: (shown: readonly GradientStop[]) => readonly GradientStop[];
}

export function gradientFields(context: PropertyContext, gradient: Gradient, greys?: StopGreys): TemplateResult {
  const words = context.editor.strings.gradient;
  const { layers } = context.editor;
  const withStopsOf = (event: Event): LayerPatch => {
    const { detail } = event as CustomEvent<readonly GradientStop[]>;
    return { gradient: { ...gradient, stops: greys ? greys.meant(detail) : detail } };
  };
  const turn = (): void => {
    const stops = gradient.stops.map(({ offset, color }) => ({ offset: 1 - offset, color })).reverse();
    record(context, words.name, { gradient: { ...gradient, stops } });
  };
  return html`
    <tc-gradient-stops
      ?inert=${context.state.readonly}
      .words=${greys?.words ?? words}
      .stops=${greys ? greys.shown(gradient.stops) : gradient.stops}
      .recent=${greys ? [] : context.state.toolSettings.recent}
      ?greys=${greys !== undefined}
      @stops-preview=${(event: Event) => layers.preview(context.ids, withStopsOf(event))}
      @stops-change=${(event: Event) => record(context, words.name, withStopsOf(event))}
      @stops-step=${(event: Event) => record(context, words.name, withStopsOf(event), "stops")}
      @stops-cancel=${() => layers.cancelPreview()}
    ></tc-gradient-stops>
    <div class="field">
      <span>${words.align}</span>
      <div class="buttons">
        ${
          gradient.kind === "linear"
            ? MODEL_AXES.map((axis) => alignButton(context, gradient, axis))
            : html`<button @click=${() => record(context, words.align, { gradient: roundGradient(context.state.model, gradient.stops) })}>
                ${words.wholeModel}
              </button>`
        }
        <button class="icon" aria-label=${words.reverse} title=${words.reverse} @click=${turn}>${icon(ArrowRightLeft)}</button>
      </div>
    </div>
    ${gradient.kind === "linear" ? linearFields(context, gradient) : radialFields(context, gradient)}
  `;
}

function alignButton(context: PropertyContext, { stops }: Gradient, axis: ModelAxis): TemplateResult {
  const words = context.editor.strings.gradient;
  const align = (): void =>
    record(context, words.align, { gradient: alignedGradient(context.state.model, axis, stops) });
  return html`<button aria-label=${words.alignTo[axis]} title=${words.alignTo[axis]} data-action=${`align-${axis}`} @click=${align}>
    ${axis.toUpperCase()}
  </button>`;
}

type Linear = Extract<Gradient, { kind: "linear" }>;
type Radial = Extract<Gradient, { kind: "radial" }>;

function linearFields(context: PropertyContext, gradient: Linear): TemplateResult {
  const words = context.editor.strings.gradient;
  return html`
    ${pointFields(context, words.from, gradient.from, (from) => ({ ...gradient, from }), gradient.to)}
    ${pointFields(context, words.to, gradient.to, (to) => ({ ...gradient, to }), gradient.from)}
  `;
}

function radialFields(context: PropertyContext, gradient: Radial): TemplateResult {
  const words = context.editor.strings.gradient;
  const step = lengthStep(context.state);
  return html`
    ${pointFields(context, words.center, gradient.center, (center) => ({ ...gradient, center }))}
    ${numberField(context, words.radius, {
      label: words.radius,
      name: words.radius,
      value: gradient.radius,
      step,
      isLength: true,
      min: Math.max(step / 10, DESIGN_LIMITS.lengthMin),
      patch: (radius) => ({ gradient: { ...gradient, radius } }),
    })}
  `;
}

/** @param other The gradient's other end, on which a design cannot have this one: it stops a step short of it. */
function pointFields(
  context: PropertyContext,
  title: string,
  point: Vec3,
  made: (point: Vec3) => Gradient,
  other?: Vec3,
): TemplateResult {
  const { strings } = context.editor;
  const step = lengthStep(context.state);
  const moved = (axis: 0 | 1 | 2, value: number): Vec3 => {
    const wished = withAxis(point, axis, value);
    const meets = wished.every((part, each) => Math.fround(part) === Math.fround(other?.[each] ?? Number.NaN));
    return meets
      ? withAxis(point, axis, value - Math.max(step, Math.abs(value) * 1e-6) * (value > 0 ? 1 : -1))
      : wished;
  };
  return html`
    ${sharedTitle(context, title)}
    <div class="three">
      ${([0, 1, 2] as const).map((axis) =>
        numberField(context, title, {
          label: "XYZ"[axis] as string,
          name: strings.properties.axis(title, "XYZ"[axis] as string),
          value: point[axis],
          step,
          isLength: true,
          patch: (value) => ({ gradient: made(moved(axis, value)) }),
        }),
      )}
    </div>
  `;
}

type PartsKind = "all" | "charts" | "faces";

/** Charts and faces are those of one material. */
export function partsFields(context: PropertyContext, layer: FillLayer): TemplateResult {
  const parts = context.editor.strings.fillParts;
  const { editor, state } = context;
  const single = materialsOf(layer).length === 1;
  const kind: PartsKind = layer.parts?.kind ?? "all";
  const picking = state.tool === "parts";
  const choose = (chosen: PartsKind): void => {
    const made = { all: null, charts: { kind: "charts", charts: [] }, faces: { kind: "faces", faces: [] } } as const;
    record(context, parts.title, { parts: made[chosen] });
    editor.tools.choose(chosen === "all" ? "move" : "parts");
  };
  const count =
    layer.parts === null ? 0 : layer.parts.kind === "charts" ? layer.parts.charts.length : layer.parts.faces.length;
  return html`
    <section role="group" aria-label=${parts.title}>
      ${choiceField<PartsKind>("parts", parts.title, parts.kinds, kind, choose)}
      ${
        layer.parts === null
          ? nothing
          : html`<div class="picked">
              <span class="quiet">${single ? parts.picked(layer.parts.kind, count) : parts.oneMaterial}</span>
              <button
                class="outlined"
                id="pick-parts"
                aria-pressed=${picking}
                ?disabled=${!single}
                @click=${() => editor.tools.choose(picking ? "move" : "parts")}
              >
                ${icon(MousePointerClick)}${picking ? parts.done : parts.pick}
              </button>
            </div>`
      }
    </section>
  `;
}
