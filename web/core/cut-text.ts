/** The first `most` characters of a text. They are counted as Unicode counts them, so none is cut in two. */
export function cutText(text: string, most: number): string {
  return text.length <= most ? text : [...text.slice(0, 2 * most)].slice(0, most).join("");
}
