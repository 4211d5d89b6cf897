/** What a list and a typed array have in common. */
interface Items<Item> {
  readonly length: number;
  readonly [index: number]: Item;
  every(test: (item: Item, index: number) => boolean): boolean;
}

/** Whether two lists hold the very same objects, or the same numbers: NaN is the same as NaN, and −0 is not 0. */
export const sameItems = <Item>(a: Items<Item>, b: Items<Item>): boolean =>
  a.length === b.length && a.every((item, index) => Object.is(item, b[index]));
