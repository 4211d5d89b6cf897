/** What browsers do to fields of their own accord, and shall not. */
import { css } from "lit";

/** On a phone of Apple's a field of smaller type has the page zoomed in when it is focused, and left so. Whatever else sets its type. */
export const typeForFingers = css`
  @media (pointer: coarse) {
    input,
    select,
    textarea {
      font-size: max(16px, 1em) !important;
    }
  }
`;

/** WebKit's own arrow comes with a raised button. This one begins 8 px before the right edge; a list's background is its colour alone. */
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
