/** Looks of the options bar. */
import { css } from "lit";

export const toolOptionsStyles = css`
  :host {
    display: block;
    min-width: 0;
    pointer-events: none;
  }
  .bar {
    pointer-events: auto;
    position: relative;
    display: flex;
    align-items: center;
    gap: var(--space-1);
    width: fit-content;
    max-width: 100%;
    padding: 3px;
    border: 1px solid var(--line);
    border-radius: var(--radius-large);
    background: var(--surface);
    box-shadow: 0 1px 3px rgb(20 24 32 / 8%);
  }
  .often {
    display: flex;
    align-items: center;
    gap: var(--space-1);
    min-width: 0;
    overflow-x: auto;
    scrollbar-width: none;
  }
  .often > * {
    flex: none;
  }
  .often tc-number {
    width: 6.5rem;
  }
  .often tc-number.long {
    width: 7.5rem;
  }
  /* A finger's letters are larger: the number has room beside its label and its unit. */
  @media (pointer: coarse) and (min-width: 721px) {
    .often tc-number {
      width: 7.5rem;
    }
    .often tc-number.long {
      width: 8.5rem;
    }
  }
  /* On a phone too, as far as the bar has room. */
  @media (pointer: coarse) and (max-width: 720px) {
    .often tc-number {
      flex: 0 1 auto;
      width: 7.5rem;
      min-width: 6.5rem;
    }
  }
  /* A small one has no room to spare, and its largest word ("Größe") takes none from the number. */
  @media (pointer: coarse) and (max-width: 400px) {
    .often tc-number {
      --space-2: 4px;
      --text-small: 0.6875rem;
    }
    .often .tip {
      gap: 0;
      padding: 0;
    }
  }
  .often p {
    display: grid;
    align-content: center;
    min-height: var(--target);
    padding-inline: var(--space-2);
    color: var(--text-quiet);
    white-space: nowrap;
  }
  /* Nothing beside it can give way. */
  .often p:only-child {
    flex: 0 1 auto;
    white-space: normal;
    text-wrap: balance;
  }
  .often .check {
    padding-inline: var(--space-2);
  }
  .tip {
    display: inline-flex;
    align-items: center;
    gap: 2px;
    padding-inline: 6px 4px;
  }
  .tip img {
    width: 22px;
    height: 22px;
    object-fit: contain;
  }
  .tip .disc {
    width: 16px;
    height: 16px;
    margin: 3px;
    border-radius: 50%;
    background: currentColor;
    forced-color-adjust: none;
  }
  .often .mirror {
    width: auto;
  }
  .colors {
    display: inline-flex;
    align-items: center;
  }
  .colors input[type="color"] {
    width: max(2.5rem, var(--target));
    border: 0;
    cursor: pointer;
  }
  .second {
    position: relative;
  }
  .second::after {
    content: "";
    position: absolute;
    inset-block-end: 4px;
    inset-inline: 7px;
    height: 3px;
    border-radius: 2px;
    background: var(--second);
    box-shadow: 0 0 0 1px var(--line);
    forced-color-adjust: none;
  }
  /* On a phone there is no room for both; the palette's recent colours bring the other one back. */
  @media (max-width: 430px) {
    .second {
      display: none;
    }
  }
  @container (max-width: 25em) {
    .second {
      display: none;
    }
  }
  .drop {
    position: absolute;
    z-index: 5;
    inset-block-start: calc(100% + var(--space-1));
    inset-inline-start: 0;
    display: grid;
    gap: var(--space-2);
    width: 17rem;
    max-width: calc(100cqw - 1rem);
    padding: var(--space-3);
    border: 1px solid var(--line);
    border-radius: var(--radius-large);
    background: var(--surface-high);
    box-shadow: var(--shadow);
  }
  .drop.end {
    /* At the bar's end, where it is not wider than the bar. */
    inset-inline-start: max(0px, 100% - 17rem);
  }
  :host([sheet]) {
    overflow: hidden auto;
    overscroll-behavior: contain;
    pointer-events: auto;
  }
  :host([sheet]) .drop {
    position: static;
    width: auto;
    max-width: none;
    padding: 0 var(--space-4) var(--space-4);
    border: 0;
    background: none;
    box-shadow: none;
  }
`;
