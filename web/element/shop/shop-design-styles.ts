/** Of the shop mode's panel what shows a design: its list, its fields, what the printer says. */
import { css } from "lit";

export const designStyles = css`
  .own {
    --tile: light-dark(#f0f1f3, #c9ccd1);
    --tile-checker: light-dark(#dfe1e5, #b3b7be);
  }
  @media (prefers-contrast: more) {
    .own {
      --line: light-dark(#5a616c, #a4abb6);
      --field-line: var(--line);
      --text-quiet: var(--text);
    }
  }
  .scroll > .quiet {
    margin-block-end: var(--space-2);
  }
  .legend {
    position: absolute;
    inset-block-end: 0.75rem;
    inset-inline-start: 0.75rem;
    display: flex;
    gap: var(--space-3);
    padding: var(--space-1) var(--space-3);
    border-radius: var(--radius-large);
    background: color-mix(in oklab, var(--surface), transparent 8%);
    box-shadow: 0 0 0 1px var(--line);
    font-size: var(--text-small);
  }
  .list {
    display: grid;
    gap: 2px;
    margin: 0;
    padding: 0;
    list-style: none;
  }
  .row {
    display: flex;
    align-items: center;
    border-radius: var(--radius);
  }
  .row[data-chosen] {
    background: var(--accent-soft);
  }
  .row .choose {
    flex: 1;
    min-width: 0;
    min-height: max(3rem, var(--target));
    justify-content: start;
    gap: var(--space-3);
    text-align: start;
    background: none;
    color: inherit;
  }
  .row .name {
    display: grid;
    min-width: 0;
  }
  .row .name > span:first-child {
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .row .name .quiet {
    font-size: var(--text-small);
  }
  .tile {
    flex: none;
    display: grid;
    place-items: center;
    width: 2.25rem;
    height: 2.25rem;
    border-radius: calc(var(--radius) * 0.75);
    color: light-dark(#3a3f47, #24272c);
    background: repeating-conic-gradient(var(--tile-checker) 0 25%, var(--tile) 0 50%) 0 0 / 0.75rem 0.75rem;
  }
  .tile.plain {
    background: var(--tile);
  }
  .tile img {
    width: 100%;
    height: 100%;
    object-fit: contain;
  }
  .fields {
    display: grid;
    grid-template-columns: repeat(auto-fit, minmax(7.5rem, 1fr));
    gap: var(--space-3) var(--space-2);
    margin-block-start: var(--space-3);
    padding-block-start: var(--space-3);
    border-block-start: 1px solid var(--line);
  }
  .fields .wide {
    grid-column: 1 / -1;
  }
  .field {
    display: grid;
    gap: var(--space-1);
    font-size: var(--text-small);
    color: var(--text-quiet);
  }
  textarea,
  .fields select {
    width: 100%;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background-color: var(--surface);
    color: var(--text);
    font: var(--text-normal) / 1.35 var(--_font);
  }
  /* The names of fonts, and the arrow behind them. */
  select {
    direction: ltr;
  }
  textarea {
    min-height: max(2.75rem, var(--target));
    padding: var(--space-2);
    resize: vertical;
    field-sizing: content;
    max-height: 8rem;
  }
  input[type="color"] {
    width: 100%;
    height: var(--target);
    padding: 3px;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--surface);
    cursor: pointer;
  }
  .findings {
    display: grid;
    gap: var(--space-2);
    margin: var(--space-3) 0 0;
    padding: 0;
    list-style: none;
    font-size: var(--text-small);
  }
  .findings li {
    padding: var(--space-2) var(--space-3);
    border-radius: var(--radius);
    background: var(--caution-soft);
  }
  .findings li.bad {
    background: var(--danger-soft);
  }
  .findings p + p {
    color: var(--text-quiet);
  }
  .foot .line {
    display: flex;
    justify-content: space-between;
    gap: var(--space-2);
    align-items: center;
    font-size: var(--text-small);
    color: var(--text-quiet);
    font-variant-numeric: tabular-nums;
  }
  /* Too low for a list between what stays: the panel goes by as a whole. */
  @container texelcast (max-width: 704px) and (max-height: 416px) {
    .panel {
      overflow: auto;
    }
    .scroll {
      flex: none;
      overflow: visible;
    }
  }
  @media (forced-colors: active) {
    .row[data-chosen] {
      outline: 2px solid Highlight;
      outline-offset: -2px;
    }
    button[aria-disabled="true"] {
      opacity: 1;
      color: GrayText !important;
    }
  }
`;
