/** What the views' style sheet has for a decal's lines and handles. */
export const GIZMO_STYLE = /* css */ `
/* A layer of its own: its lines change in each frame of a drag, and what stands beside it in a layer is painted anew with it (svg-overlay.ts). */
.tcv-overlay { position: absolute; inset: 0; width: 100%; height: 100%; overflow: hidden; pointer-events: none; will-change: transform; contain: strict; }
/* What it lies on has another place on paper. */
@media print { .tcv-overlay { display: none; } }
.tcv-overlay path, .tcv-overlay polyline { fill: none; stroke-linejoin: round; stroke-linecap: round; }
.tcv-casing { stroke: var(--tcv-casing); stroke-width: 3.5; }
.tcv-outline { stroke: var(--tcv-accent); stroke-width: 1.75; }
.tcv-outline-hidden { stroke: var(--tcv-accent); stroke-width: 1.5; stroke-dasharray: 1 5; stroke-opacity: 0.75; }
.tcv-box { stroke: var(--tcv-accent); stroke-width: 1; stroke-opacity: 0.5; }
.tcv-box-hidden { stroke: var(--tcv-accent); stroke-width: 1; stroke-opacity: 0.18; }
.tcv-hover { stroke: var(--tcv-accent); stroke-width: 1.75; stroke-opacity: 0.85; }
.tcv-beside { stroke: var(--tcv-accent); stroke-width: 1.5; stroke-dasharray: 5 4; stroke-opacity: 0.6; }
.tcv-arrow { stroke: var(--tcv-accent); stroke-width: 2; }
.tcv-overlay .tcv-arrow-head { fill: var(--tcv-accent); stroke: none; }
.tcv-guide { stroke: var(--tcv-accent); stroke-width: 1.25; }

.tcv-handle { transition: opacity 120ms, visibility 0s; }
.tcv-handle[data-hidden] { opacity: 0.4; }
.tcv-overlay .tcv-mark { fill: var(--tcv-handle); stroke: var(--tcv-accent); stroke-width: 1.75; transition: transform 120ms ease-out; }
.tcv-mark-shadow { fill: rgb(10 14 24 / 0.22); }
.tcv-overlay .tcv-handle[data-lit] .tcv-mark, .tcv-overlay .tcv-handle[data-active] .tcv-mark { fill: var(--tcv-accent); stroke: var(--tcv-handle); transform: scale(1.2); }
.tcv-overlay .tcv-glyph { stroke: var(--tcv-accent); stroke-width: 1.5; }
.tcv-overlay .tcv-handle[data-lit] .tcv-glyph, .tcv-overlay .tcv-handle[data-active] .tcv-glyph { stroke: var(--tcv-handle); }

.tcv-root[data-cursor="move"] { cursor: move; }
.tcv-root[data-cursor="handle"] { cursor: var(--tcv-handle-cursor); }
.tcv-root[data-cursor="orbit"] { cursor: grab; }
/* Hidden once they have faded, so that no frame of a drag paints them. */
.tcv-root[data-gesture] .tcv-handle:not([data-active]) { opacity: 0; visibility: hidden; transition: opacity 120ms, visibility 0s 120ms; }
.tcv-root[data-gesture="slide"] { cursor: grabbing; }
.tcv-root[data-gesture="slide"] .tcv-guide, .tcv-root[data-gesture="scale"] .tcv-guide { opacity: 0; }

.tcv-readout {
  position: absolute; left: 0; top: 0; padding: 3px 8px; border-radius: 6px; pointer-events: none; white-space: nowrap;
  font: 500 12px/1.4 system-ui, sans-serif; font-variant-numeric: tabular-nums;
  color: var(--tcv-on-accent); background: var(--tcv-accent); box-shadow: 0 2px 8px rgb(10 14 24 / 0.25);
}
.tcv-readout[hidden] { display: none; }

@media (prefers-reduced-motion: reduce) {
  .tcv-mark, .tcv-handle { transition: none; }
}`;
