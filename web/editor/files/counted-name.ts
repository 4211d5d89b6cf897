/** "Mug", else "Mug 2", "Mug 3" and so on: the first that is not taken. */
export function countedName(name: string, taken: ReadonlySet<string>): string {
  // Only what was counted on before: the 07 of "Number 07" is part of the name.
  const stem = name.replace(/ (?:[2-9]|[1-9]\d+)$/, "");
  let free = name;
  for (let number = 2; taken.has(free); number += 1) free = `${stem} ${number}`;
  return free;
}
