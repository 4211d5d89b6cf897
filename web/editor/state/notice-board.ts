/** Shows notices and announcements. */
import { type Strings, stringsIn } from "../strings.ts";
import type { EditorState } from "./editor-state.ts";
import { isCancelled, type Notice, type NoticeAction, noticeOf } from "./notices.ts";
import type { Store } from "./store.ts";

/** More would hide the page that they are about. */
export const MAX_NOTICES = 3;

export class NoticeBoard {
  readonly #store: Store<EditorState>;
  #count = 0;

  constructor(store: Store<EditorState>) {
    this.#store = store;
  }

  /** What the editor says, in its language. */
  get strings(): Strings {
    return stringsIn(this.#store.state.language);
  }

  /** A cancelled task is what the user asked for and needs no notice: null then. */
  error(title: string, thrown: unknown, action?: NoticeAction): number | null {
    if (isCancelled(thrown)) return null;
    this.#count += 1;
    this.#add({ ...noticeOf(this.#count, title, thrown, this.strings), ...(action && { action }) });
    return this.#count;
  }

  info(notice: Pick<Notice, "title" | "message" | "action" | "stays"> & { readonly hint?: string }): number {
    this.#count += 1;
    this.#add({ hint: "", exact: "", ...notice, id: this.#count, tone: "info", code: "", where: "" });
    return this.#count;
  }

  dismiss(id: number): void {
    this.#store.set({ notices: this.#store.state.notices.filter((notice) => notice.id !== id) });
  }

  /** What was only worth a glance goes once the user works on: of `seen`, as what a change has brought about is told with it. */
  dismissInfos(seen: readonly Notice[]): void {
    const glanced = new Set(seen.filter(({ tone, stays }) => tone === "info" && !stays));
    const notices = this.#store.state.notices.filter((notice) => !glanced.has(notice));
    if (notices.length < this.#store.state.notices.length) this.#store.set({ notices });
  }

  dismissAll(): void {
    this.#store.set({ notices: [] });
  }

  /** For screen readers; the same words twice are two announcements. */
  announce(text: string): void {
    const again = this.#store.state.announcement === text;
    // A live region speaks only when its text changes, which a space at the end does without being heard.
    this.#store.set({ announcement: again ? `${text}\u00a0` : text });
  }

  #add(notice: Notice): void {
    const others = this.#store.state.notices.filter(
      ({ title, message }) => title !== notice.title || message !== notice.message,
    );
    this.#store.set({ notices: [...others, notice].slice(-MAX_NOTICES) });
  }
}
