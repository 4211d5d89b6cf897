/** Projects that the browser keeps: the one the page begins with, and what the list of them offers. */

import { PROJECT_EXTENSION, type ProjectFile, type TextLayer } from "../document/index.ts";
import { fetchBytes } from "../files/demo-catalogue.ts";
import { download, fileNameOf } from "../files/download.ts";
import { packInWorker, unpackInWorker } from "../files/project-client.ts";
import type { ProjectToPack } from "../files/project-packing.ts";
import type { Autosave } from "../storage/autosave.ts";
import { randomId } from "../storage/content-hash.ts";
import type { LastWordsMemory, Unmeasured } from "../storage/last-words.ts";
import type { LoadedProject, ProjectContent, ProjectSummary } from "../storage/project.ts";
import type { ProjectLock } from "../storage/project-lock.ts";
import type { ProjectStore } from "../storage/project-store.ts";
import { StorageSilence } from "../storage/storage-error.ts";
import type { TabMemory } from "../storage/tab-memory.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";
import type { AssetLibrary } from "./asset-library.ts";
import { patchLayer } from "./design-edits.ts";
import type { DesignSession } from "./design-session.ts";
import type { ModelRef } from "./design-state.ts";
import type { EditorState, ListedProject } from "./editor-state.ts";
import type { FileCommands } from "./file-commands.ts";
import type { NoticeBoard } from "./notice-board.ts";
import type { Store } from "./store.ts";
import type { TaskHandle, Tasks } from "./tasks.ts";
import type { TextCommands } from "./text-commands.ts";

export interface ProjectCommandsParts {
  readonly store: Store<EditorState>;
  readonly session: DesignSession;
  readonly projects: ProjectStore;
  readonly lock: ProjectLock;
  readonly tab: TabMemory;
  readonly lastWords: LastWordsMemory;
  readonly autosave: Autosave;
  readonly library: AssetLibrary;
  readonly files: FileCommands;
  readonly board: NoticeBoard;
  readonly tasks: Tasks;
  readonly texts: () => TextCommands;
}

export class ProjectCommands {
  readonly #parts: ProjectCommandsParts;
  /** Deleted since the list was opened: they stay in it, to be brought back. */
  readonly #deleted = new Set<string>();

  constructor(parts: ProjectCommandsParts) {
    this.#parts = parts;
  }

  get #words(): Strings["projects"] {
    return this.#parts.board.strings.projects;
  }

  /**
   * Goes on where this tab was before it was loaded again, else with the project that was open last; false where there is
   * none, or none that can be opened.
   */
  async openLast(): Promise<boolean> {
    const { projects, tab, store, files } = this.#parts;
    const place = tab.recall();
    const demo = store.state.demos?.models.find(({ id }) => id === place.demo);
    if (demo) {
      await files.openDemo(demo);
      return store.state.model !== null;
    }
    const find = async (): Promise<ProjectSummary | null> =>
      (await projects.list()).find(({ id }) => id === place.project) ?? (await projects.newest());
    let last: ProjectSummary | null;
    try {
      await projects.sweep();
      last = await find();
    } catch (thrown) {
      // A browser that keeps nothing says so when there is something to keep. One that is only slow has somebody's work, which
      // seems lost unless it is told.
      if (thrown instanceof StorageSilence)
        void thrown.answered
          .then(find)
          .then((late) => this.#offer(late))
          .catch(() => undefined);
      return false;
    }
    return last !== null && this.open(last.id, this.#words.back(last.name));
  }

  /** Opens a project in place of what is open, which is kept first. False where it could not be opened. */
  open(id: string, title?: string): Promise<boolean> {
    const { session, tasks } = this.#parts;
    const work = this.#open(id, title);
    // What is undone or saved meanwhile waits for it: it was asked for before.
    session.recordsLater(work);
    return tasks.quietly(work);
  }

  /** The name of the project that a model was opened with before. */
  nameOf(model: ModelRef): string | undefined {
    return this.#parts.autosave.nameOf(model);
  }

  /**
   * Opens a project from a file, as a project of its own. Without a model inside, it goes on `model`, else on the demo that it
   * names, else on the model that is open. Rejects with a TexelcastError, and what is open stays.
   */
  async openFile(fileName: string, bytes: Uint8Array, model?: ModelRef): Promise<void> {
    const { library, autosave, files, store, tasks } = this.#parts;
    const open = async ({ signal, checkCancelled }: TaskHandle): Promise<ProjectContent> => {
      const file = await unpackInWorker(bytes, fileName, signal, this.#parts.board.strings);
      const { name, targets } = file;
      const ref = await this.#modelOf(file, model ?? store.state.model?.ref, model !== undefined);
      const design = await library.adopt(file.design, { path: fileName, read: (uri) => file.assets.get(uri) });
      if (signal.aborted) library.release(Object.values(design.assets));
      checkCancelled();
      const settings = targets.map(({ material, size, gutter }) => [material, { size, gutter }] as const);
      return { name, design, model: ref, targets: new Map(settings) };
    };
    const content = await tasks.run(this.#parts.board.strings.tasks.opening(fileName), open);
    try {
      await autosave.flush();
      autosave.begin(content.model);
      await files.openProject(content);
    } finally {
      library.release(Object.values(content.design.assets));
    }
  }

  /** Hands the project to the browser's downloads, as one file. */
  async saveFile(withModel: boolean): Promise<void> {
    const { store, session } = this.#parts;
    await session.settled();
    const { model, designName, targetSettings } = store.state;
    if (!model) return;
    const design = session.recordedDesign;
    const content = { name: designName, design, model: model.ref, targets: targetSettings };
    if (await this.#download(content, withModel)) session.markSaved(design);
  }

  /** As `saveFile`, a project that was left before the browser kept it. */
  async saveLeft(content: ProjectContent): Promise<void> {
    if (await this.#download(content, true)) this.#parts.autosave.inFile(content.model);
  }

  /** False where it could not be packed, which is told. */
  async #download(content: ProjectContent, withModel: boolean): Promise<boolean> {
    const { board, tasks } = this.#parts;
    const stem = fileNameOf(content.name);
    const name = `${withModel ? stem : this.#words.nameWithoutModel(stem)}${PROJECT_EXTENSION}`;
    const { source, title, demoId } = content.model;
    const project: ProjectToPack = {
      name: content.name,
      design: content.design,
      targets: [...content.targets].map(([material, settings]) => ({ material, ...settings })),
      model: { title, demo: demoId, source: withModel ? source : null },
    };
    try {
      const bytes = await tasks.run(board.strings.tasks.packing(name), ({ signal }) =>
        packInWorker(project, signal, board.strings),
      );
      download(name, "application/zip", bytes);
      board.announce(board.strings.announce.saved(name));
      return true;
    } catch (thrown) {
      board.error(this.#words.couldNotSave(name), thrown);
      return false;
    }
  }

  /** Reads the list again. */
  async refresh(): Promise<void> {
    await this.#attempt(this.#words.couldNotList, async () => {
      await this.#parts.autosave.flush();
      await this.#list();
    });
  }

  /** Makes the open project's picture, which the list shows. */
  async refreshThumbnail(): Promise<void> {
    await this.#parts.autosave.refreshThumbnail();
    await this.#list().catch(() => undefined);
  }

  /** An empty name is no name: nothing happens. */
  async rename(id: string, name: string): Promise<void> {
    const { store, projects, autosave, board } = this.#parts;
    const trimmed = name.trim();
    if (trimmed === "") return;
    await this.#attempt(this.#words.couldNotSave(trimmed), async () => {
      const free = await projects.freeName(trimmed, id);
      await projects.rename(id, free);
      if (id === autosave.projectId) store.set({ designName: free });
      if (free !== trimmed) board.announce(this.#words.namedInstead(free));
      await autosave.flush();
      await this.#list();
    });
  }

  async duplicate({ id, name }: ProjectSummary): Promise<void> {
    const { projects, autosave, board } = this.#parts;
    await this.#attempt(this.#words.couldNotSave(name), async () => {
      await autosave.flush();
      await projects.duplicate(id, await projects.freeName(this.#words.copyOf(name), null));
      await this.#list();
      board.announce(this.#parts.board.strings.announce.duplicated(name));
    });
  }

  async remove({ id, name }: ProjectSummary): Promise<void> {
    const { projects, autosave, board } = this.#parts;
    await this.#attempt(this.#words.couldNotDelete(name), async () => {
      await autosave.flush();
      const canReturn = await projects.remove(id);
      if (canReturn) this.#deleted.add(id);
      autosave.forget(id);
      // What had no room before may have it now.
      if (!canReturn) await autosave.flush();
      await this.#list();
      board.announce(this.#parts.board.strings.announce.removed(name));
    });
  }

  async restore({ id, name }: ProjectSummary): Promise<void> {
    await this.#attempt(this.#words.couldNotOpen(name), async () => {
      const { projects } = this.#parts;
      await projects.rename(id, await projects.freeName(name, id));
      await projects.restore(id);
      this.#deleted.delete(id);
      await this.#list();
      this.#parts.board.announce(this.#words.restored(name));
    });
  }

  /** The list was closed: what was deleted in it is gone for good; what another tab's list may bring back is not. */
  async sweep(): Promise<void> {
    if (this.#deleted.size === 0) return;
    const gone = new Set(this.#deleted);
    this.#deleted.clear();
    await this.#parts.projects.sweepThese(gone).catch(() => undefined);
    await this.#parts.autosave.flush();
  }

  async #open(id: string, title: string | undefined): Promise<boolean> {
    const { projects, lock, autosave, files, board, store } = this.#parts;
    const before = autosave.projectId;
    let name = store.state.projects?.find((project) => project.id === id)?.name ?? "";
    try {
      await autosave.flush();
      const free = await lock.take(id);
      const unmeasured = free ? await this.#amend(id) : null;
      const loaded = await projects.load(id);
      name = loaded.summary.name;
      const content = await this.#contentOf(loaded, free ? name : this.#words.copyOf(name), unmeasured);
      if (free) autosave.adopt(content, id, loaded.summary.revision);
      else autosave.adopt(content, randomId(), 0, id);
      try {
        await files.openProject(content);
      } finally {
        this.#parts.library.release(Object.values(content.design.assets));
      }
      this.#tell(loaded, content, free, title);
      if (unmeasured) await this.#parts.texts().finish(unmeasured);
      return true;
    } catch (thrown) {
      if (before !== null) void lock.take(before);
      board.error(this.#words.couldNotOpen(name), thrown);
      return false;
    }
  }

  /** What was left unsaved when the project was open last is saved first. Gives the change in it that is to be measured. */
  async #amend(id: string): Promise<Unmeasured | null> {
    const { lastWords, projects } = this.#parts;
    const words = lastWords.recall(id);
    if (!words) return null;
    try {
      const amended = await projects.amend(id, words);
      lastWords.forget(id);
      return (amended && words.unmeasured) || null;
    } catch {
      // Without room for it, it stays noted.
      return null;
    }
  }

  /** @param unmeasured is taken out again: done anew, it is a step that its undo takes back. What is kept has it all the while. */
  async #contentOf(loaded: LoadedProject, name: string, unmeasured: Unmeasured | null): Promise<ProjectContent> {
    const { library } = this.#parts;
    const model = "kind" in loaded.model ? await this.#demo(loaded.model) : loaded.model;
    const adopted = await library.adopt(loaded.design, { path: name });
    const design = unmeasured ? patchLayer<TextLayer>(adopted, unmeasured.id, unmeasured.before) : adopted;
    return { name, design, model, targets: loaded.targets };
  }

  async #modelOf(
    { model }: Pick<ProjectFile, "model">,
    other: ModelRef | undefined,
    given: boolean,
  ): Promise<ModelRef> {
    const { source, title, demo } = model;
    if (source) return { source, title, demoId: null };
    const known = !given && demo !== null && this.#parts.store.state.demos?.models.some(({ id }) => id === demo);
    if (known) return this.#demo({ id: demo, title });
    if (other) return { ...other };
    throw new ToldError("missing-file", this.#words.noModel, { subject: title, hint: this.#words.noModelHint });
  }

  async #demo({ id, title }: { id: string; title: string }): Promise<ModelRef> {
    const { demos } = this.#parts.store.state;
    const demo = demos?.models.find((candidate) => candidate.id === id);
    if (!demos || !demo) {
      throw new ToldError("missing-file", this.#words.demoGone(title), {
        subject: title,
        hint: this.#words.demoGoneHint,
      });
    }
    const bytes = await fetchBytes(demo.model, demos.page);
    return { source: { name: demo.model.slice(demo.model.lastIndexOf("/") + 1), bytes }, title, demoId: id };
  }

  /** What the page would have opened, had the browser answered in time. */
  #offer(late: ProjectSummary | null): void {
    const { autosave, board } = this.#parts;
    if (late === null || late.id === autosave.projectId) return;
    const { id, name } = late;
    const action = { label: this.#words.open(name), run: () => void this.open(id, this.#words.back(name)) };
    board.info({ title: this.#words.couldNotOpen(name), message: board.strings.storage.late, action, stays: true });
  }

  #tell({ summary, fromBackup }: LoadedProject, content: ProjectContent, free: boolean, title?: string): void {
    const { board } = this.#parts;
    if (fromBackup) board.info({ title: this.#words.backupTitle(summary.name), message: this.#words.backup });
    else if (!free)
      board.info({ title: this.#words.elsewhereTitle(summary.name), message: this.#words.elsewhere(content.name) });
    else if (title !== undefined) board.info({ title, message: this.#words.backMessage(summary.modified) });
  }

  async #list(): Promise<void> {
    const { store, projects, lock, autosave } = this.#parts;
    const shown = store.state.projects ?? [];
    const [kept, elsewhere] = await Promise.all([projects.list(), lock.elsewhere()]);
    const listed = kept.map((project): ListedProject => {
      const open = project.id === autosave.projectId ? "here" : elsewhere.has(project.id) ? "elsewhere" : null;
      return { ...project, open, deleted: false };
    });
    const deleted = shown
      .filter(({ id }) => this.#deleted.has(id))
      .map((project): ListedProject => ({ ...project, open: null, deleted: true }));
    store.set({ projects: [...listed, ...deleted].sort((a, b) => b.modified - a.modified) });
  }

  async #attempt(title: string, work: () => Promise<void>): Promise<void> {
    try {
      await this.#parts.tasks.quietly(work());
    } catch (thrown) {
      this.#parts.board.error(title, thrown);
    }
  }
}
