/** The shop mode's layout: the product, and beside it (under it where the element is narrow) what is on it. */
import { css } from "lit";

export const shopStyles = css`
  .shop {
    display: grid;
    grid-template: minmax(0, 1fr) / minmax(0, 1fr) minmax(17rem, 21rem);
    position: absolute;
    inset: 0;
  }
  /* Only looked at: there is no panel. */
  .shop[data-alone] {
    grid-template: minmax(0, 1fr) / minmax(0, 1fr);
  }
  .stage {
    position: relative;
    min-width: 0;
    min-height: 0;
    background: radial-gradient(
      120% 90% at 50% 30%,
      color-mix(in oklab, var(--_stage), light-dark(white 45%, white 5%)),
      var(--_stage)
    );
  }
  .view {
    position: absolute;
    inset: 0;
  }
  .bar {
    position: absolute;
    inset-block-start: 0.75rem;
    inset-inline: 0.75rem;
    display: flex;
    flex-wrap: wrap;
    gap: 0.5rem;
    align-items: start;
    justify-content: space-between;
    pointer-events: none;
  }
  .bar > * {
    pointer-events: auto;
  }
  .tools {
    display: flex;
    padding: 3px;
    border-radius: var(--radius-large);
    background: color-mix(in oklab, var(--surface), transparent 8%);
    box-shadow: 0 0 0 1px var(--line);
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
  .panel {
    display: flex;
    flex-direction: column;
    min-height: 0;
    background: var(--_surface);
    border-inline-start: 1px solid var(--_line);
  }
  .add {
    display: grid;
    grid-template-columns: 1fr 1fr;
    gap: var(--space-2);
    padding: var(--space-4);
    padding-block-end: var(--space-2);
  }
  .add button {
    min-height: max(2.75rem, var(--target));
    font-weight: 550;
  }
  .scroll {
    flex: 1;
    min-height: 0;
    overflow: auto;
    overscroll-behavior: contain;
    padding: var(--space-2) var(--space-4) var(--space-4);
  }
  .empty {
    display: grid;
    justify-items: center;
    gap: var(--space-2);
    padding: var(--space-5) var(--space-3);
    color: var(--text-quiet);
    text-align: center;
    text-wrap: balance;
  }
  .empty h2 {
    color: var(--text);
    font-size: var(--text-large);
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
    background: var(--surface);
    color: var(--text);
    font: var(--text-normal) / 1.35 var(--_font);
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
  .foot {
    display: grid;
    gap: var(--space-2);
    padding: var(--space-3) var(--space-4) max(var(--space-4), env(safe-area-inset-bottom));
    border-block-start: 1px solid var(--line);
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
  .foot button {
    min-height: max(2.75rem, var(--target));
    font-size: var(--text-large);
  }
  .drop {
    position: absolute;
    inset: 0;
    display: grid;
    place-content: center;
    border: 2px solid var(--accent);
    background: color-mix(in oklab, var(--surface), transparent 35%);
    font-size: var(--text-large);
    font-weight: 550;
    pointer-events: none;
  }
  @container texelcast (max-width: 44rem) {
    .shop:not([data-alone]) {
      grid-template: minmax(0, 1fr) minmax(0, auto) / minmax(0, 1fr);
    }
    .panel {
      max-height: 52cqb;
      border-inline-start: 0;
      border-block-start: 1px solid var(--_line);
    }
    .add {
      padding: var(--space-3) var(--space-3) var(--space-1);
    }
    .scroll {
      padding: var(--space-1) var(--space-3) var(--space-2);
    }
    .empty {
      padding: var(--space-2);
    }
    .foot {
      padding: var(--space-2) var(--space-3) max(var(--space-3), env(safe-area-inset-bottom));
    }
  }
`;
