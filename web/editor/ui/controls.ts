/** The controls of panels and dialogs, where the system forces its colours, too. */
import { css } from "lit";
import { plainControls } from "./theme.ts";

// Apart from the others: a product can be shown before anything in it can be chosen.
const forcedColors = css`
  /* There the system's colours take the place of the page's: what is chosen says so by them. What shows a colour of the
     design keeps it, where it stands. */
  @media (forced-colors: active) {
    button:is([aria-pressed="true"], [aria-selected="true"], [aria-checked="true"]),
    :is(nav button, button.opens)[aria-expanded="true"],
    .segments input:checked + span {
      forced-color-adjust: none;
      background: Highlight !important;
      color: HighlightText !important;
      transition: none;
    }
    /* Its arrow is a picture, which the system takes away. */
    select {
      appearance: auto;
    }
    :not(button)[aria-selected="true"],
    [aria-current="true"] {
      outline: 2px solid Highlight;
      outline-offset: -2px;
    }
    button:disabled,
    button[aria-disabled="true"] {
      opacity: 1;
      color: GrayText !important;
    }
  }
`;

/** A button that has laid something open: that is its state, and none of being pressed beside it, which would be said as another. */
const openers = css`
  button.opens[aria-expanded="true"] {
    background: var(--accent-soft);
    color: var(--accent);
  }
`;

export const controls = [plainControls, openers, forcedColors];
