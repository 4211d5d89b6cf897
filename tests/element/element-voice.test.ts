import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { ToldError } from "../../web/editor/strings/told-error.ts";
import { Voice } from "../../web/element/element-voice.ts";
import { english } from "../../web/element/words/english.ts";

/** A voice whose element notes the fields of the errors that it tells. */
function voiceOf(wording: unknown) {
  const told: unknown[] = [];
  const around = { closest: () => null, getRootNode: () => null, requestUpdate: () => undefined };
  const element = Object.assign(new EventTarget(), around, { locale: "en", wording });
  element.addEventListener("error", (event) => told.push((event as CustomEvent).detail.error.field));
  return { voice: new Voice(element as unknown as ConstructorParameters<typeof Voice>[0]), element, told };
}

describe("a shop's own words that cannot be taken", () => {
  beforeEach(() => {
    vi.stubGlobal("ShadowRoot", class {});
    vi.stubGlobal("navigator", { languages: ["en"] });
  });
  afterEach(() => vi.unstubAllGlobals());

  it("are told once, however often the element takes up its words", async () => {
    const { voice, told } = voiceOf({ sumbit: "x", undo: 3, redo: "Again" });
    // As an element does that is to start at once, and one that starts anew.
    await Promise.all([voice.speak(), voice.speak()]);
    await voice.speak();
    expect(told).toEqual(["wording.sumbit", "wording.undo"]);
    expect(voice.words.redo).toBe("Again");
  });

  it("are told again when they are other ones", async () => {
    const { voice, element, told } = voiceOf({ sumbit: "x" });
    await voice.speak();
    element.wording = { sumbit: "x" };
    await voice.speak();
    expect(told).toEqual(["wording.sumbit", "wording.sumbit"]);
  });
});

describe("what a customer sees of an error", () => {
  it("is no address of a page's, which is told of it", () => {
    const { voice, element } = voiceOf(null);
    const told: string[] = [];
    element.addEventListener("error", (event) => told.push((event as CustomEvent).detail.message));
    const message = "http://shop.example/mug.glb could not be fetched.";
    voice.tell(new ToldError("missing-file", message, { hint: "Check the address. (HTTP 404)" }));
    expect(voice.shownError).toMatchObject({ message: english.errors.unexpected });
    expect(voice.shownError?.hint).toBeUndefined();
    expect(told).toEqual([message]);
  });

  it("is nothing of a product's file that is no model", () => {
    for (const message of [
      "“mug.glb” is not a glTF model: it seems to be a page.",
      "“mug.glb” ist kein lesbares glTF-Modell.",
    ]) {
      const { voice } = voiceOf(null);
      voice.tell(new ToldError("bad-container", message, { hint: "Choose a .glb file." }));
      expect(voice.shownError).toMatchObject({ message: english.errors.unexpected });
      expect(voice.shownError?.hint).toBeUndefined();
    }
  });

  it("is what can be done about it where that is theirs to do", () => {
    const { voice } = voiceOf(null);
    voice.tell(new ToldError("bad-picture", "“cat.png” is damaged.", { hint: "Choose another picture." }));
    expect(voice.shownError).toMatchObject({ message: "“cat.png” is damaged.", hint: "Choose another picture." });
  });
});
