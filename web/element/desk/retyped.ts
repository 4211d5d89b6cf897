/** What was typed into a text, done once more where something that was typed before is left out. */

/** What a deed made of a text (`before` to `after`), done to one (`text`) that lacks what other deeds had put in. */
export function retyped(before: string, after: string, text: string): string {
  // By whole characters: two emoji may have their first half in common.
  const [old, now, onto] = [[...before], [...after], [...text]];
  const start = common(old, now);
  const end = Math.min(common([...old].reverse(), [...now].reverse()), old.length - start, now.length - start);
  const cut = old.slice(start, old.length - end).join("");
  const put = now.slice(start, now.length - end);
  // What follows the place is as good a sign as what precedes it, and stands also where that has lost letters.
  const rest = old.slice(start);
  const isBefore = onto.slice(-rest.length || onto.length).join("") === rest.join("");
  const place = isBefore ? onto.length - rest.length : Math.min(start, onto.length);
  const length = onto.slice(place).join("").startsWith(cut) ? old.length - start - end : 0;
  return [...onto.slice(0, place), ...put, ...onto.slice(place + length)].join("");
}

/** How many characters both begin with. */
function common(some: readonly string[], others: readonly string[]): number {
  const differs = some.findIndex((character, index) => character !== others[index]);
  return differs < 0 ? some.length : differs;
}
