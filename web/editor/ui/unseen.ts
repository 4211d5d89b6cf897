/** Of what screen readers say, and nobody sees, by what is around it; what nobody ever sees has the class of the same look. */
import { css } from "lit";

export const unseen = css`
  position: absolute;
  width: 1px;
  height: 1px;
  margin: -1px;
  overflow: hidden;
  clip-path: inset(50%);
  white-space: nowrap;
`;
