/** The element before and around its mode: its box, the poster, what is told. */
import { css } from "lit";

export const elementStyles = css`
  :host {
    display: block;
    container: texelcast / size;
    overflow: clip;
    /* A phone of Apple's on its side would enlarge some words, and not others. */
    -webkit-text-size-adjust: 100%;
    block-size: var(--texelcast-height, min(44rem, 85svh));
    min-block-size: 20rem;
    /* Its size goes by nothing that is in it, so beside other things it would be nothing wide. */
    contain-intrinsic-inline-size: min(44rem, 85vw);
    min-inline-size: 0;
    background: var(--_stage);
    color: var(--_text);
    border-radius: var(--_radius);
    /* What is absolute inside has its place here by that, too. */
    contain: layout paint style;
  }
  :host([hidden]) {
    display: none;
  }
  .cover {
    position: absolute;
    inset: 0;
    display: grid;
    grid-template: 100% / 100%;
    place-items: center;
    background: var(--_stage);
  }
  .cover[data-over] {
    z-index: 5;
    transition: opacity 250ms;
  }
  .poster {
    grid-area: 1 / 1;
    width: 100%;
    height: 100%;
    object-fit: contain;
  }
  slot[name="poster"] {
    display: contents;
  }
  ::slotted([slot="poster"]) {
    grid-area: 1 / 1;
    max-width: 100%;
    max-height: 100%;
  }
  .cover .center {
    grid-area: 1 / 1;
    z-index: 1;
    display: grid;
    justify-items: center;
    gap: 0.75rem;
    align-self: end;
    padding: 1.5rem;
    text-align: center;
  }
  /* Below a poster, and in the middle of nothing. */
  .cover[data-bare] .center,
  .cover[data-phase="failed"] .center {
    align-self: center;
  }
  .cover .start {
    min-height: 2.75rem;
    padding-inline: 1.25rem;
    box-shadow: var(--shadow);
  }
  .card {
    display: grid;
    gap: var(--space-2);
    justify-items: center;
    max-width: 24rem;
    padding: var(--space-4);
    border-radius: var(--radius-large);
    background: var(--surface);
    box-shadow: 0 0 0 1px var(--line);
  }
  progress {
    appearance: none;
    width: 10rem;
    height: 4px;
    border: 0;
    border-radius: 99px;
    background: var(--line);
    overflow: hidden;
    /* The bar is nothing but colours. */
    forced-color-adjust: none;
  }
  progress::-webkit-progress-bar {
    background: var(--line);
  }
  progress::-webkit-progress-value {
    background: var(--accent);
    transition: inline-size 200ms;
  }
  progress::-moz-progress-bar {
    background: var(--accent);
  }
  .notice {
    position: absolute;
    z-index: 20;
    inset-block-start: 4rem;
    inset-inline: 0.75rem;
    display: flex;
    align-items: start;
    gap: var(--space-2);
    max-width: 26rem;
    padding: var(--space-3);
    border-radius: var(--radius-large);
    background: var(--surface);
    box-shadow:
      inset 3px 0 0 var(--danger),
      0 0 0 1px var(--line),
      var(--shadow);
  }
  .notice > div {
    flex: 1;
    overflow-wrap: anywhere;
  }
`;
