/** "Mug", else "Mug 2", "Mug 3" and so on: the first that is not taken. */
export const countedName = (name: string, taken: ReadonlySet<string>): string => countedNames(taken)(name);

/** Gives such names one after the other, each of which is taken then, too. */
export function countedNames(taken: ReadonlySet<string>): (name: string) => string {
  const given = new Set(taken);
  /** By stem, the number that came last: what is below it is taken, and stays so. */
  const numbers = new Map<string, number>();
  return (name) => {
    const stem = withoutCount(name);
    let free = name;
    let number = numbers.get(stem) ?? 1;
    while (given.has(free)) free = `${stem} ${++number}`;
    numbers.set(stem, number);
    given.add(free);
    return free;
  };
}

/** A name as it was before it was counted on: the 07 of "Number 07" is part of it. */
export const withoutCount = (name: string): string => name.replace(/ (?:[2-9]|[1-9]\d+)$/, "");
