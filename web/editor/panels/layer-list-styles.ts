/** Looks of the layer list. */
import { css } from "lit";

export const layerListStyles = css`
  :host {
    --row: 32px;
    --thumbnail: 24px;
    display: grid;
    grid-template-rows: auto minmax(0, 1fr) auto;
    min-height: 0;
  }
  @media (pointer: coarse) {
    :host {
      --row: 44px;
      --thumbnail: 32px;
    }
  }
  .looks {
    display: grid;
    grid-template-columns: minmax(0, 1fr) minmax(8rem, 1fr) auto;
    gap: var(--space-1);
    padding: var(--space-1) var(--space-3) var(--space-2);
  }
  /* Letters twice as large as usual, on a phone. */
  @media (max-width: 15rem) {
    .looks {
      grid-template-columns: minmax(0, 1fr) auto;
    }
    .looks select {
      grid-column: 1 / -1;
    }
  }
  /* Each in its own row, whether the ones before it are there or not. */
  .rows,
  .empty {
    grid-row: 2;
  }
  .bar {
    grid-row: 3;
  }
  .rows {
    min-height: 0;
    overflow: hidden auto;
    overscroll-behavior: contain;
    padding: 2px var(--space-2);
    scrollbar-width: thin;
    scrollbar-color: var(--line-strong) transparent;
    user-select: none;
    -webkit-user-select: none;
  }
  /* Firefox stops there by Tab where it scrolls; round it the ring is cut by the panel. */
  .rows:focus-visible {
    outline-offset: -2px;
  }
  .empty {
    padding: var(--space-2) var(--space-4) var(--space-3);
    line-height: 1.45;
  }
  .content {
    position: relative;
    height: calc(var(--row) * var(--rows));
  }
  .row,
  .line {
    position: absolute;
    inset-block-start: calc(var(--row) * var(--at));
  }
  .row {
    inset-inline: 0;
    display: flex;
    align-items: center;
    height: var(--row);
    padding-inline: 2px;
    border-radius: var(--radius);
    cursor: default;
  }
  .row:focus-visible {
    outline-offset: -2px;
  }
  @media (hover: hover) {
    .row:hover {
      background: var(--hover);
    }
  }
  .row.chosen {
    background: color-mix(in oklab, var(--accent-soft), transparent 35%);
  }
  .row.primary {
    background: var(--accent-soft);
  }
  .row.dragged {
    opacity: 0.45;
  }
  .row.into {
    outline: 2px solid var(--accent);
    outline-offset: -2px;
  }
  .line {
    z-index: 2;
    inset-inline-end: 0;
    height: 2px;
    margin-block-start: -1px;
    border-radius: 1px;
    background: var(--accent);
    pointer-events: none;
  }
  .line::before {
    content: "";
    position: absolute;
    inset-block-start: -2px;
    inset-inline-start: -3px;
    width: 6px;
    height: 6px;
    border-radius: 50%;
    background: var(--accent);
  }
  .name-cell {
    flex: 1;
    display: flex;
    align-items: center;
    min-width: 0;
    height: 100%;
  }
  .twist {
    flex: none;
    width: 24px;
    min-width: 24px;
    margin-inline: -3px;
    min-height: 24px;
    padding: 0;
    color: var(--text-quiet);
  }
  .twist tc-icon {
    transform: scale(0.85);
  }
  .chip {
    flex: none;
    min-width: 0;
    min-height: 0;
    width: var(--thumbnail);
    height: var(--thumbnail);
    margin-inline-start: 6px;
    padding: 1px;
    overflow: hidden;
    border-radius: 5px;
    box-shadow: inset 0 0 0 1px var(--line-strong);
  }
  .target {
    flex: none;
    display: block;
    border-radius: 6px;
  }
  /* What the brush paints on, of a layer that has a mask too. */
  .painted-on {
    box-shadow:
      0 0 0 1px var(--surface),
      0 0 0 3px var(--accent);
  }
  .name {
    flex: 1;
    min-width: 0;
    margin-inline-start: var(--space-2);
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  input.name {
    min-height: 24px;
    height: calc(var(--row) - 6px);
    padding-inline: var(--space-1);
    background: var(--surface);
    user-select: text;
  }
  .primary .name {
    font-weight: 550;
  }
  .off .target {
    opacity: 0.6;
  }
  /* Its name is read as any other, and so are the words in the picture of a text. */
  .off .name {
    color: var(--text-quiet);
  }
  .cell {
    flex: none;
    display: flex;
  }
  .cell button {
    min-width: 26px;
    width: 26px;
    min-height: calc(var(--row) - 4px);
  }
  .quiet-until-near button[aria-pressed="false"] {
    opacity: 0;
  }
  .row:hover .quiet-until-near button,
  .row:focus-within .quiet-until-near button,
  .primary .quiet-until-near button {
    opacity: 1;
  }
  .cell button[aria-pressed="true"] {
    background: none;
    color: var(--text);
  }
  .grip {
    display: none;
  }
  @media (pointer: coarse) {
    .cell button {
      min-width: 44px;
      width: 44px;
      min-height: 44px;
    }
    /* Wider than it looks. */
    .twist {
      width: 44px;
      min-height: 44px;
      margin-inline: -8px;
    }
    .chip {
      width: 44px;
      height: 44px;
      margin-inline-start: 0;
      padding: 6px;
    }
    .chip,
    .chip.painted-on {
      box-shadow: none;
    }
    .chip .mask-picture {
      border-radius: 5px;
      box-shadow: 0 0 0 1px var(--line-strong);
    }
    .chip.painted-on .mask-picture {
      box-shadow:
        0 0 0 1px var(--surface),
        0 0 0 3px var(--accent);
    }
    /* Its place is kept: the second tap of two on a name would meet what came there with the first. */
    .quiet-until-near button[aria-pressed="false"] {
      visibility: hidden;
    }
    .primary .quiet-until-near button[aria-pressed="false"] {
      visibility: visible;
    }
    .grip {
      flex: none;
      display: grid;
      place-items: center;
      width: 32px;
      height: 100%;
      color: var(--line-strong);
      touch-action: none;
    }
  }
  .bar {
    container-type: inline-size;
    display: flex;
    align-items: center;
    padding: 2px var(--space-2);
    border-block-start: 1px solid var(--line);
  }
  .bar .gap {
    flex: 1;
  }
  @media (pointer: coarse) {
    .bar button.icon {
      flex: 1;
      min-width: 0;
    }
    .bar .gap {
      display: none;
    }
    /* Where all eight would be too small for fingers; the last one's menu has these as well. */
    @container (max-width: 25em) {
      [data-action="add-mask"],
      [data-action="group"] {
        display: none;
      }
    }
  }
`;
