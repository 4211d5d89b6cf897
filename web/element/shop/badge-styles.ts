/** What the print's report says in a word, and the colours of its map. */
import { css } from "lit";

export const badgeStyles = css`
  .own {
    --danger-soft: light-dark(#fdf0ee, #43292a);
    --caution: light-dark(#8a5300, #f0c26a);
    --caution-soft: light-dark(#fdf4e3, #42371f);
    --good: light-dark(#1b6b3a, #8fd6a8);
    --good-soft: light-dark(#e9f6ee, #223a2b);
  }
  .badge {
    flex: none;
    padding: 0.1rem 0.45rem;
    border-radius: 99px;
    font-size: var(--text-small);
    font-variant-numeric: tabular-nums;
    white-space: nowrap;
  }
  .badge.good {
    color: var(--good);
    background: var(--good-soft);
  }
  .badge.caution {
    color: var(--caution);
    background: var(--caution-soft);
  }
  .badge.bad {
    color: var(--danger);
    background: var(--danger-soft);
  }
  .legend span::before {
    content: "";
    display: inline-block;
    width: 0.7em;
    height: 0.7em;
    margin-inline-end: 0.4em;
    border-radius: 50%;
    background: currentcolor;
  }
  .legend .good {
    color: var(--good);
  }
  .legend .bad {
    color: var(--danger);
  }
`;
