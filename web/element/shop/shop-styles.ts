/** The shop mode's layout: the product, and beside it (under it where the element is narrow) what is on it. */
import { css } from "lit";

export const shopStyles = css`
  .shop {
    display: grid;
    grid-template: minmax(0, 1fr) / minmax(0, 1fr) minmax(17rem, 22rem);
    position: absolute;
    inset: 0;
  }
  /* Only looked at: there is no panel. */
  .shop[data-alone] {
    grid-template: minmax(0, 1fr) / minmax(0, 1fr);
  }
  .stage {
    position: relative;
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
    padding: var(--space-4) var(--space-4) var(--space-2);
  }
  .add button {
    min-height: max(2.75rem, var(--target));
    padding: 0 var(--space-2);
    gap: var(--space-1);
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
  .foot {
    display: grid;
    gap: var(--space-2);
    padding: var(--space-3) var(--space-4) max(var(--space-4), env(safe-area-inset-bottom));
    border-block-start: 1px solid var(--line);
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
  /* 44 rem, in what no page's own size of type changes. */
  @container texelcast (max-width: 704px) {
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
