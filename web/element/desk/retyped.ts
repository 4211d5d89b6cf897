/** What was typed into a text, done once more where something that was typed before is left out. */

/** What a deed made of a text (`before` to `after`), done to one (`text`) that lacks what other deeds had put in. */
function retyped(before: string, after: string, text: string): string {
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

/** More that was typed while nothing could be shown is not gone through letter by letter. */
const MOST_TYPED = 100;

/**
 * What stands in a field, of whose texts since `shown` some cannot be drawn, without their letters.
 * @param draws rejects where a text cannot be drawn
 * @returns null where `goesOn` says no more, or where too much was typed
 */
export async function withoutUndrawable(
  shown: string,
  texts: readonly string[],
  draws: (text: string) => Promise<unknown>,
  goesOn: () => boolean,
): Promise<string | null> {
  if (texts.length > MOST_TYPED) return null;
  let before = shown;
  let kept = shown;
  for (const after of texts) {
    const text = retyped(before, after, kept);
    before = after;
    if (text === kept || text.trim() === "") continue;
    if (await draws(text).catch(() => null)) kept = text;
    if (!goesOn()) return null;
  }
  return kept;
}
