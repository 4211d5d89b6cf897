/** Looks of the property panel. */
import { css } from "lit";
import { namedFields } from "./named-fields.ts";

export const propertyStyles = css`
  :host {
    display: grid;
    gap: var(--space-4);
  }
  .header {
    display: flex;
    align-items: center;
    gap: var(--space-2);
  }
  .header input {
    font-weight: 550;
  }
  .fields {
    display: grid;
    gap: var(--space-4);
  }
  .fields[inert] {
    opacity: 0.5;
  }
  .locked {
    display: flex;
    align-items: center;
    gap: var(--space-2);
    padding: var(--space-1) var(--space-1) var(--space-1) var(--space-3);
    border-radius: var(--radius);
    background: var(--surface-low);
    color: var(--text-quiet);
  }
  .locked p {
    flex: 1;
  }
  section {
    display: grid;
    gap: var(--space-2);
  }
  section + section {
    padding-top: var(--space-4);
    border-top: 1px solid var(--line);
  }
  .titled {
    display: flex;
    align-items: center;
  }
  .titled h3 {
    flex: 1;
  }
  @media (pointer: fine) {
    button.small {
      min-height: 24px;
      min-width: 24px;
    }
  }
  .three {
    display: grid;
    grid-template-columns: repeat(3, minmax(0, 1fr));
    gap: var(--space-1);
  }
  /* Their heading says the unit. */
  .shared + .three,
  .titled:has(.shared) + .three {
    --unit: none;
  }
  .shared span {
    font-weight: 400;
  }
  .two {
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr));
    gap: var(--space-1);
  }
  ${namedFields}
  .mask [role="radiogroup"] {
    grid-template-columns: auto minmax(0, 1fr);
  }
  .slider {
    display: grid;
    grid-template-columns: minmax(0, 1fr) 4.25rem;
    align-items: center;
    gap: var(--space-2);
  }
  .buttons {
    display: flex;
    gap: var(--space-1);
  }
  .buttons button {
    flex: 1;
    background: var(--surface-low);
  }
  .buttons button[aria-pressed="true"] {
    background: var(--accent-soft);
    color: var(--accent);
  }
  .segments {
    display: grid;
    grid-auto-flow: column;
    grid-auto-columns: 1fr;
    gap: 2px;
    padding: 2px;
    border-radius: var(--radius);
    background: var(--surface-low);
  }
  /* Their grounds go where the system forces its colours: lines say then what belongs together, and what is a button. */
  @media (forced-colors: active) {
    .segments,
    .buttons button {
      border: 1px solid ButtonBorder;
    }
  }
  .segments label {
    position: relative;
    cursor: pointer;
  }
  .segments input {
    position: absolute;
    inset: 0;
    opacity: 0;
    cursor: pointer;
  }
  .segments span {
    display: grid;
    place-items: center;
    min-height: calc(var(--target) - 4px);
    border-radius: 4px;
    color: var(--text-quiet);
  }
  .segments input:checked + span {
    background: var(--surface-high);
    color: var(--text);
    font-weight: 550;
    box-shadow: 0 1px 2px rgb(20 24 32 / 14%);
  }
  .segments input:focus-visible + span {
    outline: 2px solid var(--accent);
    outline-offset: 1px;
  }
  @media (pointer: coarse) {
    .segments span {
      min-height: var(--target);
    }
  }
  .kinds span {
    grid-auto-flow: row;
    gap: 2px;
    padding-block: var(--space-1);
    font-size: var(--text-small);
  }
  .color {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr);
    gap: var(--space-2);
  }
  .picked {
    display: flex;
    align-items: center;
    justify-content: space-between;
    gap: var(--space-2);
  }
  .check {
    display: flex;
    align-items: center;
    gap: var(--space-2);
    min-height: var(--target);
    cursor: pointer;
  }
  .check input {
    width: 16px;
    height: 16px;
    margin: 0;
  }
  input[type="color"] {
    width: 3rem;
    height: var(--target);
    padding: 2px;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--surface);
  }
  .none {
    display: grid;
    gap: var(--space-1);
    line-height: 1.45;
  }
`;
