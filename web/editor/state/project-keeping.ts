/** Puts together what keeps projects: the store, this tab's lock, the autosave, and the page's events that matter to them. */
import type { TexelcastError } from "../../core/texelcast-error.ts";
import { Autosave } from "../storage/autosave.ts";
import { LastWordsMemory } from "../storage/last-words.ts";
import { ProjectLock } from "../storage/project-lock.ts";
import { ProjectStore } from "../storage/project-store.ts";
import { TabMemory } from "../storage/tab-memory.ts";
import { endOpenField, takeTyped } from "../ui/open-field.ts";
import type { AssetLibrary } from "./asset-library.ts";
import type { DesignSession } from "./design-session.ts";
import { type EditorState, INITIAL_STATE } from "./editor-state.ts";
import type { FileCommands } from "./file-commands.ts";
import type { NoticeBoard } from "./notice-board.ts";
import { noticeOf } from "./notices.ts";
import { ProjectCommands } from "./project-commands.ts";
import { Store } from "./store.ts";
import type { Tasks } from "./tasks.ts";
import type { TextCommands } from "./text-commands.ts";

export interface ProjectKeepingParts {
  readonly store: Store<EditorState>;
  readonly session: DesignSession;
  /** A small picture of the model as a `data:` URI; null where there is none. */
  readonly thumbnail: () => Promise<string | null>;
  readonly library: AssetLibrary;
  readonly files: FileCommands;
  readonly board: NoticeBoard;
  readonly tasks: Tasks;
  readonly texts: () => TextCommands;
  /** Whether the browser keeps what is worked on; else the projects' commands are there, and nothing is kept by itself. */
  readonly keeps: boolean;
}

export interface ProjectKeeping {
  readonly commands: ProjectCommands;
  readonly autosave: Autosave;
}

export function keepProjects({ thumbnail, keeps, ...parts }: ProjectKeepingParts): ProjectKeeping {
  const { store, board, session } = parts;
  const { strings } = board;
  const projects = new ProjectStore(strings);
  const lock = new ProjectLock();
  const tab = new TabMemory();
  const lastWords = new LastWordsMemory();
  const autosave = new Autosave({
    // One in which nothing ever happens.
    strings,
    store: keeps ? store : new Store(INITIAL_STATE),
    recorded: () => session.recorded,
    projects,
    lock,
    tab,
    lastWords,
    unmeasured: () => parts.texts().unmeasured,
    thumbnail,
    notices: {
      refused: (error: TexelcastError, left) => {
        const { message, hint } = noticeOf(0, "", error, strings);
        const { refusedTitle, leftTitle } = strings.storage;
        const title = left ? leftTitle(left.name) : refusedTitle;
        const run = () => void (left ? commands.saveLeft(left) : commands.saveFile(true));
        const action = { label: strings.projects.saveFile, run };
        const notice = board.info({ title, message, hint, action, stays: true });
        return () => board.dismiss(notice);
      },
      restored: (left) => {
        const { restoredTitle, leftKept } = strings.storage;
        board.announce(left ? leftKept(left.name) : restoredTitle);
      },
      copied: (name) => {
        board.info({ title: strings.projects.copiedTitle, message: strings.projects.copied(name), stays: true });
      },
      deleted: (keep) => {
        const action = { label: strings.projects.keep, run: keep };
        board.info({
          title: strings.projects.deletedTitle,
          message: strings.projects.deletedElsewhere,
          action,
          stays: true,
        });
      },
    },
  });
  const commands = new ProjectCommands({ ...parts, projects, lock, tab, lastWords, autosave });
  if (!keeps) return { autosave, commands };
  const leave = (): void => {
    autosave.leave();
    void autosave.flush();
  };
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState !== "hidden") {
      void autosave.seenAgain();
      return;
    }
    // A phone may end a page that is not seen, and says no more to it. Who comes back goes on typing.
    takeTyped();
    leave();
  });
  // Windows side by side are both visible.
  addEventListener("focus", () => void autosave.seenAgain());
  addEventListener("pagehide", () => {
    endOpenField();
    leave();
  });
  return { autosave, commands };
}
