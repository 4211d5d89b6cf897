/** What Safari calls the key that ends a composition, of which it tells after the composition's end. */
const OF_COMPOSITION = 229;

/** Whether a key is for words that are being composed, as Enter and Escape are while one chooses what the letters typed mean. */
export const isComposed = ({ isComposing, keyCode }: KeyboardEvent): boolean =>
  isComposing || keyCode === OF_COMPOSITION;
