/**
 * The views' style sheet.
 *
 * Custom properties that a page may set: --viewer-accent (the gizmo), --viewer-on-accent (text on it), --viewer-handle
 * (the handles' fill; it lies on the model, so it stays white on a dark page, too),
 * --viewer-casing (the thin contrast around its lines), --viewer-shadow (0 to 1, strength of the contact shadow),
 * --viewer-ground (0 to 1, strength of a pool of light on the ground, for dark pages),
 * --viewer-checker-a and --viewer-checker-b (under transparency), --viewer-outline (UV lines).
 */
export const VIEW_STYLE = /* css */ `
.tcv-root {
  position: relative; width: 100%; height: 100%; overflow: hidden; outline: none;
  touch-action: none; user-select: none; -webkit-user-select: none; cursor: default;
  --tcv-accent: var(--viewer-accent, #3d7eff);
  --tcv-on-accent: var(--viewer-on-accent, #ffffff);
  --tcv-handle: var(--viewer-handle, #ffffff);
  --tcv-casing: var(--viewer-casing, rgb(255 255 255 / 0.75));
}
.tcv-root:focus-visible:not([data-pointed])::after {
  content: ""; position: absolute; inset: 2px; border-radius: 6px; pointer-events: none;
  border: 2px solid var(--tcv-accent);
}
/* On paper the page is laid out anew and nothing is drawn for that: the picture of the screen keeps its proportions there. */
.tcv-canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; object-fit: contain; }
`;
