/** The arrow of a list that unfolds. */
import { css } from "lit";

/** WebKit's own comes with a raised button. It begins 8 px before the right edge; where a list sets a background, it is its colour alone. */
export const selectArrow = css`
  select {
    appearance: none;
    min-height: var(--target);
    padding: 0 24px 0 8px;
    background-image:
      linear-gradient(45deg, transparent 43%, currentColor 43% 57%, transparent 57%),
      linear-gradient(-45deg, transparent 43%, currentColor 43% 57%, transparent 57%);
    background-position:
      right 12px center,
      right 8px center;
    background-size: 5px 5px;
    background-repeat: no-repeat;
  }
`;
