/** How long a drawing's words take to be set, told beforehand. In the time of one comparison, as of svg-growth.ts; measured. */
import type { XmlTag } from "./xml-tags.ts";

/** Letters that stand together are looked at as often as there are runs of style among them. */
const RUN_LETTER = 1000;
/** Each letter on a path is put in its place, and looked up among all that stand together there. */
const PATH_LETTER = 30_000;
const PATH_PAIR = 1;

/** Words as the tags of a document come. */
export class SetWords {
  #letters = 0;
  #runs = 0;
  #isOnPath = false;

  /** @param text within an element of words */
  add(text: string): void {
    if (text === "") return;
    this.#letters += text.replace(/\s+/g, " ").length;
    this.#runs += 1;
  }

  /** What the words before a tag come to, where it parts them from those that follow; else 0. */
  part({ name, kind, attributes }: XmlTag): number {
    const isPath = name === "textPath";
    const begins = kind !== "end" && (attributes.has("x") || attributes.has("y"));
    if (!isPath && name !== "text" && !begins) return 0;
    let weight = RUN_LETTER * this.#runs * this.#letters;
    if (this.#isOnPath) weight += (PATH_LETTER + PATH_PAIR * this.#letters) * this.#letters;
    this.#letters = 0;
    this.#runs = 0;
    if (isPath) this.#isOnPath = kind === "start";
    return weight;
  }
}
