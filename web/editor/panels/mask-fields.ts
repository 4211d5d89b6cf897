/** What the mask that is painted on begins with: the fill or the gradient below its strokes. */
import { html, nothing, type TemplateResult } from "lit";
import { Link2, Unlink2 } from "lucide";
import type { DesignLayer, Gradient, Mask } from "../document/index.ts";
import { fadingGradient, roundGradient } from "../state/aligned-gradient.ts";
import { picturesIn, staysOf } from "../state/left-masks.ts";
import { canGoAlong, type MaskStart, maskFade, maskStartOf, stopsAsGreys, stopsOfGreys } from "../state/mask-edits.ts";
import { icon } from "../ui/icon.ts";
import { gradientFields } from "./fill-fields.ts";
import type { PropertyContext } from "./property-controls.ts";
import { choiceField } from "./property-fields.ts";

type StartKind = "all" | "nothing" | Gradient["kind"];

function linkButton({ editor }: PropertyContext, { linked }: Mask): TemplateResult {
  const words = editor.strings.mask;
  return html`<button
    class="icon small"
    id="mask-linked"
    aria-pressed=${linked}
    aria-label=${words.linked}
    title=${words.linkedHint}
    @click=${() => editor.layers.linkMask(!linked)}
  >
    ${icon(linked ? Link2 : Unlink2)}
  </button>`;
}

/** Nothing where the layer itself is painted on. */
export function maskFields(context: PropertyContext, layer: DesignLayer): TemplateResult | typeof nothing {
  const { editor, state } = context;
  const { mask } = layer;
  if (mask === null || state.editingMask !== layer.id) return nothing;
  const words = editor.strings.mask;
  const start = maskStartOf(mask);
  const fade = maskFade(layer);
  const startOf = (kind: StartKind): MaskStart => {
    if (kind === "all" || kind === "nothing") return kind;
    const made = fadingGradient(state.model, layer);
    const stops = fade?.gradient.stops ?? made.stops;
    return kind === "radial" ? roundGradient(state.model, stops) : { ...made, stops };
  };
  const greys = {
    words: { ...editor.strings.gradient, stops: words.stops },
    shown: (stops: Gradient["stops"]) => stopsAsGreys(stops, mask),
    meant: (stops: Gradient["stops"]) => stopsOfGreys(stops, mask),
  };
  return html`
    <section aria-label=${words.title} title=${words.startHint} class="mask">
      <div class="titled">
        <h3>${words.title}</h3>
        ${canGoAlong(layer) ? linkButton(context, mask) : nothing}
      </div>
      ${canGoAlong(layer) && staysOf(layer, picturesIn(layer)).length > 0 ? html`<p class="quiet">${words.stays}</p>` : nothing}
      ${choiceField<StartKind>("mask-start", words.start, words.starts, typeof start === "string" ? start : start.kind, (kind) => editor.layers.startMask(startOf(kind)))}
      ${fade ? gradientFields({ ...context, ids: [fade.id] }, fade.gradient, greys) : nothing}
    </section>
  `;
}
