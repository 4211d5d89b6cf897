/** What is left to say when the page cannot start at all. */
import type { TexelcastError } from "../core/texelcast-error.ts";
import { noticeOf } from "../editor/state/notices.ts";
import { pageLanguage } from "../editor/strings/language.ts";
import { stringsIn } from "../editor/strings.ts";

export function showStartFailure(error: TexelcastError): void {
  const strings = stringsIn(pageLanguage);
  const { title: begin, message, hint } = noticeOf(0, strings.errors.couldNotStart, error, strings);
  const box = document.createElement("main");
  box.role = "alert";
  box.style.cssText =
    "max-width:32rem;margin:20vh auto;padding:0 1.5rem;font:1rem/1.5 system-ui,sans-serif;color-scheme:light dark";
  const title = document.createElement("h1");
  title.style.fontSize = "1.25rem";
  title.textContent = begin;
  const text = document.createElement("p");
  text.textContent = hint ? `${message} ${hint}` : message;
  box.append(title, text);
  document.body.append(box);
}
