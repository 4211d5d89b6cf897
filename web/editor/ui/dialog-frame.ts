/** How a dialog lies over the page: its frame, and a head that stays while its body scrolls. Its width is its own. */
import { css } from "lit";

export const dialogFrame = css`
  dialog {
    max-height: calc(100dvh - 4rem);
    padding: 0;
    border: 1px solid var(--line);
    border-radius: var(--radius-large);
    background: var(--surface-high);
    color: var(--text);
    box-shadow: var(--shadow);
  }
  dialog::backdrop {
    background: rgb(0 0 0 / 35%);
  }
  header {
    position: sticky;
    z-index: 1;
    inset-block-start: 0;
    display: flex;
    align-items: center;
    justify-content: space-between;
    gap: var(--space-2);
    padding: var(--space-3) var(--space-3) var(--space-2) var(--space-4);
    background: inherit;
  }
`;
