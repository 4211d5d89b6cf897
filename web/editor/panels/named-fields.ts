/** Looks of a row with a word and what it names. */
import { css } from "lit";

export const namedFields = css`
  .field {
    display: grid;
    grid-template-columns: 5.5rem minmax(0, 1fr);
    align-items: center;
    gap: var(--space-2);
    min-height: var(--target);
  }
  /* Letters twice as large as usual: on a phone a word takes the width of what it names. */
  @media (max-width: 15rem) {
    .field {
      grid-template-columns: minmax(0, 1fr);
      /* As high as what it holds, also where not all of them have room. */
      min-height: auto;
    }
  }
  .field > label,
  .field > span {
    color: var(--text-quiet);
  }
`;
