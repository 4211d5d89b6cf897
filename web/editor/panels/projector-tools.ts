/** How a decal is thrown, above its numbers: the kind of projector, commands that align it, its mirror. */
import { html, nothing, type TemplateResult } from "lit";
import { ArrowUpFromDot, Box, Cylinder, Eye, type IconNode, Layers2, ScanEye, Square } from "lucide";
import type { DecalLayer, Mirror, Projector, TextLayer } from "../document/index.ts";
import type { Editor } from "../state/editor.ts";
import { strings } from "../strings.ts";
import { icon } from "../ui/icon.ts";
import { checkField, choiceField } from "./property-fields.ts";

const words = strings.projection;

type Kind = Projector["kind"];
type Thrown = DecalLayer | TextLayer;

const KIND_ICONS: Readonly<Record<Kind, IconNode>> = {
  planar: Box,
  perspective: ScanEye,
  cylindrical: Cylinder,
  uv: Square,
};
const ALIGNMENTS = [
  ["surface", Layers2],
  ["upright", ArrowUpFromDot],
  ["view", Eye],
] as const;

/** A mirror nearer to the model's own origin than this share of the model's extent stands there. */
const OFF_ORIGIN = 0.1;

export function projectionTools(editor: Editor, { projector }: Thrown): TemplateResult {
  const kinds = Object.keys(KIND_ICONS) as Kind[];
  const choose = (kind: Kind) => (event: Event) => {
    if (editor.decals.selected?.projector.kind === kind) return;
    editor.decals.convert(kind);
    // Where it was refused, the list must not stay on this word.
    const input = event.target as HTMLInputElement;
    input.checked = editor.decals.selected?.projector.kind === kind;
    const own = editor.decals.selected?.projector.kind;
    for (const other of input.closest(".kinds")?.querySelectorAll("input") ?? []) other.checked = other.value === own;
  };
  return html`
    <section aria-label=${words.title} id="projection">
      <h3>${words.title}</h3>
      <div class="segments kinds" role="radiogroup" aria-label=${words.title}>
        ${kinds.map(
          (kind) => html`<label title=${words.kindHints[kind]}>
            <input type="radio" name="kind" value=${kind} .checked=${kind === projector.kind} @change=${choose(kind)} />
            <span>${icon(KIND_ICONS[kind])}${words.kinds[kind]}</span>
          </label>`,
        )}
      </div>
      ${
        projector.kind === "perspective"
          ? html`<button id="view-again" @click=${() => editor.decals.convert("perspective")}>
              ${icon(ScanEye)}${words.again}
            </button>`
          : nothing
      }
      <div class="field">
        <span>${words.align}</span>
        <div class="buttons">
          ${ALIGNMENTS.map(
            ([how, drawing]) => html`<button
              class="icon"
              id=${`align-${how}`}
              aria-label=${words.alignments[how]}
              title=${words.alignments[how]}
              ?disabled=${how === "surface" && projector.kind === "uv"}
              @click=${() => editor.decals.align(how)}
            >
              ${icon(drawing)}
            </button>`,
          )}
        </div>
      </div>
    </section>
  `;
}

/** @param place the number field of the mirror's place, for a mirror that is on */
export function mirrorFields(
  editor: Editor,
  layer: Thrown,
  place: (mirror: Mirror) => TemplateResult,
): TemplateResult | typeof nothing {
  if (layer.projector.kind === "uv") return nothing;
  const { mirror } = layer;
  const change = (next: Mirror | null): void =>
    editor.layers.change(layer.id, { mirror: next }, strings.steps.change(words.mirror));
  const axes = { none: words.mirrorNone, x: "X", y: "Y", z: "Z" } as const;
  return html`
    <section aria-label=${words.mirror} title=${words.mirrorHint}>
      ${choiceField<keyof typeof axes>("mirror", words.mirror, axes, mirror?.axis ?? "none", (axis) =>
        change(
          axis === "none"
            ? null
            : { axis, offset: mirrorPlace(editor, axis), readable: mirror?.readable ?? layer.type === "text" },
        ),
      )}
      ${
        mirror
          ? html`${checkField("readable", words.readable, mirror.readable, (readable) => change({ ...mirror, readable }))}
              <div class="field"><span>${words.mirrorOffset}</span>${place(mirror)}</div>`
          : nothing
      }
    </section>
  `;
}

/** The model's middle on an axis, metres; its origin where that is near enough to be meant. */
function mirrorPlace(editor: Editor, axis: Mirror["axis"]): number {
  const info = editor.store.state.model?.info;
  if (!info) return 0;
  const at = { x: 0, y: 1, z: 2 }[axis] as 0 | 1 | 2;
  const [low, high] = [info.boundsMin[at], info.boundsMax[at]];
  const middle = (low + high) / 2;
  return Math.abs(middle) < OFF_ORIGIN * (high - low) ? 0 : middle;
}
