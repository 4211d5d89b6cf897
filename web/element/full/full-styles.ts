/** The whole editor's box in the element, and the line under it. */
import { css } from "lit";

export const fullStyles = css`
  .full {
    position: absolute;
    inset: 0;
    display: grid;
    grid-template: minmax(0, 1fr) auto / minmax(0, 1fr);
  }
  .full .view {
    position: relative;
    inset: auto;
  }
  .full .foot {
    display: flex;
    align-items: center;
    justify-content: end;
    gap: 0.5rem;
    padding: 0.5rem 0.75rem max(0.5rem, env(safe-area-inset-bottom));
    border-block-start: 1px solid var(--_line);
    background: var(--_surface);
    /* As the editor above it. */
    direction: ltr;
  }
  .full .quality,
  .full .legend,
  .full .quality .line {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 0.25rem 0.75rem;
    color: var(--_text-quiet);
    font-size: var(--text-small);
    font-variant-numeric: tabular-nums;
  }
  .full .quality {
    margin-inline-end: auto;
  }
`;
