/** What the views' style sheet has for tools, gradients and the flat view: the editor's, which a shop's page does not load. */
export const TOOL_STYLE = /* css */ `
/*
 * Where tools stand beside the model's view, its picture goes on under them, so far as a page says: --viewer-start, --viewer-end,
 * --viewer-above and --viewer-below (lengths). What is drawn over it ends with the view: --viewer-fade (a mask).
 */
.tcv-model { overflow: visible; }
.tcv-model > .tcv-canvas {
  inset-block-start: calc(0px - var(--viewer-above, 0px)); inset-inline-start: calc(0px - var(--viewer-start, 0px));
  width: calc(100% + var(--viewer-start, 0px) + var(--viewer-end, 0px)); height: calc(100% + var(--viewer-above, 0px) + var(--viewer-below, 0px));
}
.tcv-model > .tcv-overlay { mask-image: var(--viewer-fade, none); mask-composite: intersect; }
.tcv-ring-casing { stroke: rgb(10 14 24 / 0.55); stroke-width: 3; }
.tcv-ring-line { stroke: #ffffff; stroke-width: 1.25; }
.tcv-ring-inner { stroke: rgb(255 255 255 / 0.8); stroke-width: 1; stroke-dasharray: 3 3; }

.tcv-gradient { position: absolute; inset: 0; overflow: hidden; pointer-events: none; }
.tcv-gradient[hidden], .tcv-gradient-handle[hidden] { display: none; }
.tcv-gradient-handle {
  position: absolute; left: 0; top: 0; width: 28px; height: 28px; margin: -14px 0 0 -14px; padding: 0; border: 0;
  background: none; cursor: grab; pointer-events: auto; touch-action: none;
}
.tcv-gradient-handle::after {
  content: ""; position: absolute; inset: 6px; border-radius: 50%; box-sizing: border-box;
  background: var(--tcv-handle); border: 2px solid var(--tcv-accent); box-shadow: 0 1px 5px rgb(10 14 24 / 0.35);
}
.tcv-gradient-handle[data-gradient-handle="second"]::after { border-radius: 3px; }
.tcv-gradient-handle:hover::after, .tcv-gradient-handle[data-active]::after { background: var(--tcv-accent); border-color: var(--tcv-handle); }
.tcv-gradient-handle:focus { outline: none; }
.tcv-gradient-handle:focus-visible { outline: 2px solid var(--tcv-accent); outline-offset: -1px; border-radius: 50%; }
.tcv-gradient-handle[data-active] { cursor: grabbing; }
@media (pointer: coarse) {
  .tcv-gradient-handle { width: 44px; height: 44px; margin: -22px 0 0 -22px; }
  .tcv-gradient-handle::after { inset: 13px; }
}

.tcv-texture { cursor: grab; }
.tcv-texture[data-panning] { cursor: grabbing; }
.tcv-marker {
  position: absolute; left: 0; top: 0; width: 18px; height: 18px; margin: -9px 0 0 -9px; border-radius: 50%;
  pointer-events: none; border: 2px solid var(--tcv-handle); outline: 2px solid var(--tcv-accent);
  box-shadow: 0 1px 5px rgb(10 14 24 / 0.5);
}
.tcv-marker::after {
  content: ""; position: absolute; inset: 5px; border-radius: 50%; background: var(--tcv-accent);
  box-shadow: 0 0 0 1px var(--tcv-handle);
}
.tcv-marker[hidden] { display: none; }
.tcv-marker[data-behind] { opacity: 0.4; }

.tcv-guide-names rect { fill: none; stroke: var(--tcv-accent); stroke-width: 1; stroke-dasharray: 3 3; opacity: 0.8; }
.tcv-guide-names text {
  fill: var(--viewer-guide-text, #1a1d22); font: 500 11px/1 system-ui, sans-serif; text-anchor: middle; dominant-baseline: central;
  paint-order: stroke; stroke: var(--viewer-guide-halo, rgb(255 255 255 / 0.85)); stroke-width: 3px; stroke-linejoin: round;
}
.tcv-guide-names .tcv-part { font-weight: 700; fill: var(--tcv-accent); }`;
