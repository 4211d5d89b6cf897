/** Design tokens. Set on the workbench; custom properties reach into every shadow root below it. */
import { css } from "lit";

export const theme = css`
  :host {
    color-scheme: light dark;
    /* A phone of Apple's on its side would enlarge some words, and not others. */
    -webkit-text-size-adjust: 100%;
    --font: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", sans-serif;
    --text-small: 0.6875rem;
    --text-normal: 0.8125rem;
    --text-large: 0.9375rem;

    --space-1: 0.25rem;
    --space-2: 0.5rem;
    --space-3: 0.75rem;
    --space-4: 1rem;
    --space-5: 1.5rem;
    --radius: 6px;
    --radius-large: 10px;
    --target: 28px;

    --stage: #e9eaec;
    --surface: #ffffff;
    --surface-low: #f5f6f7;
    --surface-high: #ffffff;
    --hover: rgb(20 24 32 / 6%);
    --pressed: rgb(20 24 32 / 11%);
    --line: #e1e3e7;
    --line-strong: #8a909b;
    --text: #1a1d22;
    --text-quiet: #5a616c;
    --accent: #4650d0;
    --accent-text: #ffffff;
    --accent-soft: #ecedfb;
    --danger: #b3261e;
    --danger-soft: #fdf0ee;
    --shadow: 0 1px 2px rgb(20 24 32 / 8%), 0 8px 28px rgb(20 24 32 / 14%);
    --checker: #dfe1e5;
    --tile: #f5f6f7;
    --tile-checker: #dfe1e5;

    --viewer-accent: var(--accent);
    --viewer-on-accent: var(--accent-text);
    --viewer-guide-text: var(--text);
    --viewer-guide-halo: color-mix(in srgb, var(--surface), transparent 15%);
    --viewer-wire: light-dark(rgb(20 24 32 / 0.4), rgb(235 238 245 / 0.4));
    --viewer-checker-a: var(--surface);
    --viewer-checker-b: var(--checker);
  }

  @media (prefers-color-scheme: dark) {
    :host {
      --stage: #1b1d20;
      --surface: #242629;
      --surface-low: #1e2023;
      --surface-high: #2e3135;
      --hover: rgb(255 255 255 / 7%);
      --pressed: rgb(255 255 255 / 12%);
      --line: #35383d;
      --line-strong: #868c96;
      --text: #eceef1;
      --text-quiet: #a4abb6;
      --accent: #99a1ff;
      --accent-text: #15172b;
      --accent-soft: #31345a;
      --danger: #ff9d92;
      --danger-soft: #43292a;
      --shadow: 0 1px 2px rgb(0 0 0 / 40%), 0 10px 32px rgb(0 0 0 / 50%);
      --checker: #3a3d42;
      --tile: #c9ccd1;
      --tile-checker: #b3b7be;
    }
  }

  /* Who asks for more of it sees where a field ends, and reads all words alike. */
  @media (prefers-contrast: more) {
    :host {
      --line: light-dark(#5a616c, #a4abb6);
      --line-strong: var(--text);
      --field-line: var(--line);
      --text-quiet: var(--text);
    }
  }

  @media (pointer: coarse) {
    :host {
      --target: 44px;
      --text-small: 0.75rem;
      --text-normal: 0.875rem;
    }
  }
`;

/** What every element of the page shares: box sizes, focus rings, buttons, fields. */
export const plainControls = css`
  *,
  *::before,
  *::after {
    box-sizing: border-box;
  }
  [hidden] {
    display: none !important;
  }
  :focus-visible {
    outline: 2px solid var(--accent);
    outline-offset: 1px;
  }
  button,
  input,
  select {
    font: inherit;
    color: inherit;
    letter-spacing: inherit;
  }
  button {
    display: inline-flex;
    align-items: center;
    justify-content: center;
    gap: var(--space-2);
    min-width: var(--target);
    min-height: var(--target);
    padding: 0 var(--space-2);
    border: 0;
    border-radius: var(--radius);
    background: transparent;
    cursor: pointer;
    /* Pressed twice in haste, one would have the page zoomed in; pressed for long, WebKit would choose its words. */
    touch-action: manipulation;
    -webkit-user-select: none;
    user-select: none;
    -webkit-tap-highlight-color: transparent;
    transition: background-color 120ms;
  }
  /* A finger leaves its hover behind. */
  @media (hover: hover) {
    button:hover {
      background: var(--hover);
    }
    button.icon:hover:not(:disabled) {
      color: var(--text);
    }
    button.filled:hover {
      background: color-mix(in oklab, var(--accent), black 8%);
    }
    button.outlined:hover {
      background: linear-gradient(var(--hover), var(--hover)), var(--surface);
    }
  }
  button:active {
    background: var(--pressed);
  }
  /* Of what can only be looked at: a box would not be one of the panel's own. */
  fieldset {
    display: contents;
  }
  /* aria-disabled keeps the focus, which the keyboard would lose at the end of a list. */
  button:disabled,
  button[aria-disabled="true"] {
    color: var(--text-quiet);
    opacity: 0.45;
    background: transparent;
    cursor: default;
  }
  /* Its ring is as plain as any. */
  button[aria-disabled="true"]:focus-visible {
    opacity: 1;
    background: var(--surface-low);
    color: color-mix(in srgb, var(--text-quiet), transparent 45%);
  }
  button.icon {
    padding: 0;
    color: var(--text-quiet);
  }
  button[aria-pressed="true"] {
    background: var(--accent-soft);
    color: var(--accent);
  }
  button.filled {
    padding: 0 var(--space-3);
    /* Its edge where the system forces its colours. */
    border: 1px solid transparent;
    background: var(--accent);
    color: var(--accent-text);
    font-weight: 550;
  }
  button.outlined {
    border: 1px solid var(--line);
    background: var(--surface);
  }
  input[type="text"],
  select {
    width: 100%;
    min-width: 0;
    min-height: var(--target);
    padding: 0 var(--space-2);
    border: 1px solid var(--field-line, transparent);
    border-radius: var(--radius);
    background-color: var(--surface-low);
    font-variant-numeric: tabular-nums;
  }
  /* WebKit's own arrow comes with a raised button. Where a list sets a background, it is its colour alone. */
  select {
    appearance: none;
    padding-inline-end: 24px;
    background-image:
      linear-gradient(45deg, transparent 43%, currentColor 43% 57%, transparent 57%),
      linear-gradient(-45deg, transparent 43%, currentColor 43% 57%, transparent 57%);
    background-position:
      right 12px center,
      right 8px center;
    background-size: 5px 5px;
    background-repeat: no-repeat;
    text-overflow: ellipsis;
  }
  input[type="text"]:hover,
  select:hover {
    border-color: var(--line);
  }
  input[type="text"]:focus-visible,
  select:focus-visible {
    outline-offset: -1px;
    background-color: var(--surface);
  }
  /* Apple's phones zoom the page in on a field of smaller type, and leave it so. Whatever else sets its type. */
  @media (pointer: coarse) {
    input,
    select,
    textarea {
      font-size: max(16px, 1em) !important;
    }
  }
  input[type="range"],
  input[type="checkbox"],
  input[type="radio"] {
    accent-color: var(--accent);
  }
  input[type="range"] {
    width: 100%;
    min-width: 0;
    min-height: var(--target);
    margin: 0;
    background: transparent;
    cursor: pointer;
  }
  h2 {
    margin: 0;
    font-size: var(--text-normal);
    font-weight: 600;
  }
  h3 {
    margin: 0;
    font-size: var(--text-small);
    font-weight: 550;
    color: var(--text-quiet);
  }
  p {
    margin: 0;
  }
  .quiet {
    color: var(--text-quiet);
  }
  .visually-hidden {
    position: absolute;
    width: 1px;
    height: 1px;
    margin: -1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }
  @media (prefers-reduced-motion: reduce) {
    *,
    *::before,
    *::after {
      animation-duration: 0.01ms !important;
      animation-iteration-count: 1 !important;
      transition: none !important;
    }
  }
`;
