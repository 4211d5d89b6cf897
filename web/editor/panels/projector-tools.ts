/** How a decal is thrown, above its numbers: the kind of projector, commands that align it. */
import { html, nothing, type TemplateResult } from "lit";
import {
  AlignCenterHorizontal,
  AlignCenterVertical,
  AlignHorizontalDistributeCenter,
  AlignVerticalDistributeCenter,
  ArrowUpFromDot,
  Box,
  Cylinder,
  Eye,
  type IconNode,
  Layers2,
  ScanEye,
  Square,
} from "lucide";
import type { DecalLayer, Projector, TextLayer } from "../document/index.ts";
import { ALIGNMENT_LINES, canAlign, type LineOfLayers } from "../state/aligned-together.ts";
import type { Editor } from "../state/editor.ts";
import type { EditorState } from "../state/editor-state.ts";
import { canSpread, SPREADS, type SpreadOfLayers } from "../state/spread-together.ts";
import { isSplit } from "../state/view-state.ts";
import { icon } from "../ui/icon.ts";
import { segments } from "./property-fields.ts";

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
  ["middle", AlignCenterVertical],
] as const;
/** What has no meaning for a kind. */
const WITHOUT: Readonly<Record<Kind, readonly string[]>> = {
  planar: [],
  perspective: ["middle"],
  cylindrical: ["middle"],
  uv: ["surface", "middle"],
};

const LINE_ICONS: Readonly<Record<LineOfLayers, IconNode>> = {
  column: AlignCenterVertical,
  row: AlignCenterHorizontal,
};

const SPREAD_ICONS: Readonly<Record<SpreadOfLayers, IconNode>> = {
  across: AlignHorizontalDistributeCenter,
  down: AlignVerticalDistributeCenter,
};

/** Of several: what brings them into line with one another, and of three and more what spreads them. */
export function togetherTools(editor: Editor): TemplateResult | typeof nothing {
  const { align, lines, spread, spreads } = editor.strings.projection;
  const { movable } = editor.decals;
  if (!canAlign(movable)) return nothing;
  return html`
    <section role="group" aria-label=${align}>
      ${alignField(
        align,
        ALIGNMENT_LINES.map((line) => ({
          ...{ id: `align-${line}`, label: lines[line], drawing: LINE_ICONS[line] },
          run: () => editor.decals.alignTogether(line),
        })),
      )}
      ${
        canSpread(movable)
          ? alignField(
              spread,
              SPREADS.map((way) => ({
                ...{ id: `spread-${way}`, label: spreads[way], drawing: SPREAD_ICONS[way] },
                run: () => editor.decals.spreadTogether(way),
              })),
            )
          : nothing
      }
    </section>
  `;
}

/** Whether the texture, in which what lies flat has its handles, is out of sight. */
function isTextureAway({ sheet, view: { layout } }: EditorState): boolean {
  return layout !== "texture" && !isSplit(layout, sheet !== null);
}

export function projectionTools(editor: Editor, { projector }: Thrown): TemplateResult {
  const words = editor.strings.projection;
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
    <section role="group" aria-label=${words.title} id="projection">
      <h3>${words.title}</h3>
      <div role="radiogroup" aria-label=${words.title}>
        ${segments(
          kinds.map(
            (kind) => html`<label title=${words.kindHints[kind]}>
              <input type="radio" name="kind" value=${kind} .checked=${kind === projector.kind} @change=${choose(kind)} />
              <span>${icon(KIND_ICONS[kind])}${words.kinds[kind]}</span>
            </label>`,
          ),
          "kinds",
        )}
      </div>
      ${
        projector.kind === "perspective"
          ? html`<button id="view-again" @click=${() => editor.decals.convert("perspective")}>
              ${icon(ScanEye)}${words.again}
            </button>`
          : nothing
      }
      ${projector.kind === "uv" && isTextureAway(editor.store.state) ? html`<p class="quiet">${words.flatHandles}</p>` : nothing}
      ${alignField(
        words.align,
        ALIGNMENTS.map(([how, drawing]) => ({
          ...{
            id: `align-${how}`,
            label: words.alignments[how],
            drawing,
            disabled: WITHOUT[projector.kind].includes(how),
          },
          run: () => editor.decals.align(how),
        })),
      )}
    </section>
  `;
}

interface AlignAct {
  readonly id: string;
  readonly label: string;
  readonly drawing: IconNode;
  readonly disabled?: boolean;
  readonly run: () => void;
}

function alignField(label: string, acts: readonly AlignAct[]): TemplateResult {
  return html`<div class="field">
    <span>${label}</span>
    <div class="buttons">
      ${acts.map(
        (act) => html`<button
          class="icon"
          id=${act.id}
          aria-label=${act.label}
          title=${act.label}
          ?disabled=${act.disabled ?? false}
          @click=${act.run}
        >
          ${icon(act.drawing)}
        </button>`,
      )}
    </div>
  </div>`;
}
