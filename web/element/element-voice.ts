/** What an element says, and in which language: errors to its page and its user, announcements to screen readers. */
import type { LitElement } from "lit";
import type { TexelcastEditorProperties } from "./element-api.ts";
import { errorDetail, isCancelled, type ShownError, typedError } from "./element-errors.ts";
import { sendEvent } from "./element-events.ts";
import { english, languageOf, type Words, wordsIn } from "./words/words.ts";

export class Voice {
  readonly #element: LitElement & Pick<TexelcastEditorProperties, "locale" | "wording">;
  #words: Words = english;
  /** The newest. */
  #wish: { readonly wording?: unknown } = {};
  #announcement = "";
  #shownError: ShownError | null = null;

  constructor(element: LitElement & Pick<TexelcastEditorProperties, "locale" | "wording">) {
    this.#element = element;
  }

  get words(): Words {
    return this.#words;
  }
  get announcement(): string {
    return this.#announcement;
  }

  /** What the user sees of the newest error, until it is sent away. */
  get shownError(): ShownError | null {
    return this.#shownError;
  }

  /** Takes up the element's language and the shop's own words, which may have to be loaded. */
  async speak(): Promise<void> {
    const { locale, wording } = this.#element;
    const language = languageOf([locale, languageAround(this.#element), ...navigator.languages]);
    const wish = { wording };
    // Their faults were told then.
    const again = wording === this.#wish.wording;
    this.#wish = wish;
    const words = await wordsIn(language, wording, (error) => again || this.report(error));
    // Others may have been asked for meanwhile, and have come first.
    if (this.#wish !== wish) return;
    this.#words = words;
    this.#element.requestUpdate();
  }

  /** Tells the page of a call that fails; whoever made the call is told by its promise, and need not listen. */
  told<T>(work: Promise<T>): Promise<T> {
    const told = work.catch((thrown: unknown) => {
      const error = isCancelled(thrown) ? thrown : typedError(thrown, this.#words);
      this.report(error);
      throw error;
    });
    told.catch(() => undefined);
    return told;
  }

  tried(act: () => boolean | undefined): boolean {
    try {
      return act() ?? false;
    } catch (thrown) {
      this.report(thrown);
      return false;
    }
  }

  report(thrown: unknown): void {
    if (!isCancelled(thrown)) sendEvent(this.#element, "error", errorDetail(typedError(thrown, this.#words)));
  }

  /** Tells the user, too. */
  tell(thrown: unknown): void {
    if (isCancelled(thrown)) return;
    this.show(thrown);
    this.report(thrown);
  }

  show(thrown: unknown): void {
    const error = typedError(thrown, this.#words);
    // Customers have no say in addresses, in the page's policy or in the product's file: the page is told of them.
    const isForThePage = /:\/\/|worker-src|glTF/.test(error.message);
    this.#shownError = typedError(isForThePage ? null : error, this.#words);
    this.#element.requestUpdate();
  }

  dismiss(): void {
    this.#shownError = null;
    this.#element.requestUpdate();
  }

  announce(text: string): void {
    // A live region speaks only when its text changes, which a space at the end does without being heard.
    this.#announcement = this.#announcement === text ? `${text}\u00a0` : text;
    this.#element.requestUpdate();
  }
}

/** The nearest language that is said around an element, out of the shadow trees that it stands in. */
function languageAround(element: Element): string | false | null {
  const root = element.getRootNode();
  return element.closest("[lang]")?.getAttribute("lang") ?? (root instanceof ShadowRoot && languageAround(root.host));
}
