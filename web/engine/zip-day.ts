/** The oldest day that zip can write. What is packed says it everywhere: with dates of their own, two packings of the same would differ. */
export const zipDay = (): Date => new Date(1980, 0, 1);
