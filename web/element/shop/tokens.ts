/**
 * The element's looks. A shop sets `--texelcast-*`; the house's own tokens stand only on what is the element's (`.own`), so that
 * what a page puts into the slots keeps the page's properties of the same names. Light and dark follow the page's `color-scheme`.
 */
import { css } from "lit";

export const tokens = css`
  :host {
    --_accent: var(--texelcast-accent, light-dark(#4650d0, #99a1ff));
    --_accent-text: var(--texelcast-accent-text, light-dark(#ffffff, #15172b));
    --_surface: var(--texelcast-surface, light-dark(#ffffff, #242629));
    --_surface-low: var(--texelcast-surface-low, light-dark(#f5f6f7, #1e2023));
    --_stage: var(--texelcast-stage, light-dark(#eceef0, #1b1d20));
    --_text: var(--texelcast-text, light-dark(#1a1d22, #eceef1));
    --_text-quiet: var(--texelcast-text-quiet, light-dark(#5a616c, #a4abb6));
    --_line: var(--texelcast-line, light-dark(#e1e3e7, #35383d));
    --_radius: var(--texelcast-radius, 8px);
    --_font: var(
      --texelcast-font,
      system-ui,
      -apple-system,
      "Segoe UI",
      Roboto,
      "Helvetica Neue",
      "Noto Sans",
      sans-serif
    );
  }
  :is([lang^="ar"], [lang^="fa"], [lang^="he"], [lang^="ur"]) {
    --_run: rtl;
  }
  /* Not on the host, from which what a page puts into the slots inherits. */
  .own {
    --text-small: 0.75rem;
    --text-normal: 0.875rem;
    --text-large: 1rem;
    --space-1: 0.25rem;
    --space-2: 0.5rem;
    --space-3: 0.75rem;
    --space-4: 1rem;
    --space-5: 1.5rem;
    --radius: var(--_radius);
    --radius-large: calc(var(--_radius) * 1.5);
    --target: 36px;
    --surface: var(--_surface);
    --surface-low: var(--_surface-low);
    --hover: light-dark(rgb(20 24 32 / 6%), rgb(255 255 255 / 7%));
    --pressed: light-dark(rgb(20 24 32 / 11%), rgb(255 255 255 / 12%));
    --line: var(--_line);
    --text: var(--_text);
    --text-quiet: var(--_text-quiet);
    --accent: var(--_accent);
    --accent-text: var(--_accent-text);
    --accent-soft: color-mix(in oklab, var(--_accent), var(--_surface) 86%);
    --danger: light-dark(#b3261e, #ff9d92);
    --shadow: 0 1px 2px light-dark(rgb(20 24 32 / 8%), rgb(0 0 0 / 40%)),
      0 8px 28px light-dark(rgb(20 24 32 / 14%), rgb(0 0 0 / 50%));
    --viewer-accent: var(--_accent);
    --viewer-on-accent: var(--_accent-text);
    color: var(--_text);
    font: var(--text-normal) / 1.35 var(--_font);
    /* What a page says of all its elements ("*") it says of this one too, and all inside would inherit it. */
    letter-spacing: normal;
    word-spacing: normal;
    /* Its words run as their language does, whatever the page's is. */
    direction: var(--_run, ltr);
    text-align: start;
    text-indent: 0;
    text-shadow: none;
    text-transform: none;
    white-space: normal;
    word-break: normal;
    -webkit-font-smoothing: antialiased;
  }
  @media (pointer: coarse) {
    .own {
      --target: 44px;
      --text-normal: 0.9375rem;
    }
  }
`;
