/**
 * What a page that is left has not saved yet, where it can be written at once: the browser's database takes longer than a
 * page that is being left has. It is kept until the project is saved, or opened again.
 */
import type { TextFieldsPatch } from "../state/text-commands.ts";
import type { PackedText } from "./packed-project.ts";

const PREFIX = "texelcast-left/";

/** A change of a text that was asked for and waits for the room that its words take up: `design` has it, in the old box. */
export interface Unmeasured {
  readonly id: string;
  readonly before: TextFieldsPatch;
  readonly after: TextFieldsPatch;
}

/** A project's newest text, without the bytes of its pictures. */
export interface LastWords extends PackedText {
  /** Counts saves, as `ProjectSummary` does: what the page had seen. */
  readonly revision: number;
  /** Names of the pictures that the design needs. */
  readonly pictures: readonly string[];
  readonly unmeasured?: Unmeasured | null;
}

export class LastWordsMemory {
  /** False where the browser will not, or has no room. */
  note(project: string, words: LastWords): boolean {
    try {
      localStorage.setItem(PREFIX + project, JSON.stringify(words));
      return true;
    } catch {
      return false;
    }
  }

  recall(project: string): LastWords | null {
    try {
      return JSON.parse(localStorage.getItem(PREFIX + project) ?? "null");
    } catch {
      return null;
    }
  }

  forget(project: string): void {
    try {
      localStorage.removeItem(PREFIX + project);
    } catch {
      // Nothing was noted there.
    }
  }
}
