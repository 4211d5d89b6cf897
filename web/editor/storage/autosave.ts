/**
 * Keeps the open project in the browser: after each recorded step, soon; at once when the page may be closed. A demo that
 * nothing was changed on is not kept, the user's own model is from the start. Models and projects belong together:
 * opening another model begins another project, and an undo that brings the model back brings its project back. The
 * project that is open is the one that the next visit begins with, even where nothing of it was left to save.
 */
import type { TexelcastError } from "../../core/texelcast-error.ts";
import type { TextLayer } from "../document/index.ts";
import { patchLayer } from "../state/design-edits.ts";
import type { ModelRef, Snapshot } from "../state/design-state.ts";
import type { EditorState, TargetSettings } from "../state/editor-state.ts";
import type { Store } from "../state/store.ts";
import type { Strings } from "../strings.ts";
import { randomId } from "./content-hash.ts";
import type { LastWordsMemory, Unmeasured } from "./last-words.ts";
import { LeftProjects, type Withdraw } from "./left-projects.ts";
import { ProjectPacker } from "./packed-project.ts";
import type { ProjectContent } from "./project.ts";
import type { ProjectLock } from "./project-lock.ts";
import type { ProjectStore, ProjectTouch } from "./project-store.ts";
import { storageError } from "./storage-error.ts";
import type { TabMemory, TabPlace } from "./tab-memory.ts";

export interface AutosaveParts {
  readonly store: Store<EditorState>;
  readonly recorded: () => Snapshot;
  readonly projects: Pick<ProjectStore, "save" | "setThumbnail" | "freeName" | "nameOf" | "touch">;
  readonly lock: Pick<ProjectLock, "take">;
  /** A small picture of the model as it is seen; null where there is none. */
  readonly thumbnail: () => Promise<string | null>;
  readonly notices: AutosaveNotices;
  readonly tab: Pick<TabMemory, "remember">;
  readonly lastWords: Pick<LastWordsMemory, "note" | "forget">;
  /** The change of a text that is a step as soon as its words are measured. */
  readonly unmeasured: () => Unmeasured | null;
  readonly strings: Strings;
}

export interface AutosaveNotices {
  /** `left` is another project than the open one (null). What is returned takes the notice back. */
  refused(error: TexelcastError, left: ProjectContent | null): Withdraw;
  /** It is kept again. */
  restored(left: ProjectContent | null): void;
  /** Another tab has saved the project: from here on this tab has a copy. */
  copied(name: string): void;
  /** Another tab has deleted the project: what is on the page is kept nowhere, until it is changed or `keep` is called. */
  deleted(keep: () => void): void;
}

/** Milliseconds between the starts of two saves. */
const PACE = 400;
const RETRY = 15_000;
const THUMBNAIL_AFTER = 1200;
/** The browser is asked to keep the data for good once that many saves show that somebody works here. */
const SAVES_BEFORE_PERSIST = 5;

interface OpenProject {
  id: string;
  revision: number;
  /** What is kept; null for nothing yet. */
  kept: ProjectContent | null;
  /** Of a copy that nothing was changed on: what it is a copy of. */
  origin: string | null;
}

export class Autosave {
  readonly #parts: AutosaveParts;
  readonly #packer: ProjectPacker;
  readonly #projects = new WeakMap<ModelRef, OpenProject>();
  /** By id: a project that is opened again has another model reference, and is still one project with one count of saves. */
  readonly #byId = new Map<string, WeakRef<OpenProject>>();
  #current: OpenProject | null = null;
  /** The newest of the current project that was seen, which a switch to another model must not lose. */
  #newest: ProjectContent | null = null;
  readonly #left = new LeftProjects<OpenProject>(RETRY);
  #timer: ReturnType<typeof setTimeout> | undefined;
  #thumbnailTimer: ReturnType<typeof setTimeout> | undefined;
  /** When the timer rings, as `performance.now()`. */
  #rings = Number.POSITIVE_INFINITY;
  #lastStart = Number.NEGATIVE_INFINITY;
  #running: Promise<void> | null = null;
  /** The browser would not keep the open project: takes the notice of it back. */
  #refused: Withdraw | null = null;
  #persistAsked = false;

  constructor(parts: AutosaveParts) {
    this.#parts = parts;
    this.#packer = new ProjectPacker(parts.strings);
    parts.store.subscribe(() => this.#observe());
  }

  /**
   * Ties a model that is about to be opened to a project that is kept already.
   *
   * @param origin of a copy, which is kept once it is changed: the project that it is one of
   */
  adopt(content: ProjectContent, id: string, revision: number, origin: string | null = null): void {
    const known = this.#byId.get(id)?.deref();
    const project = Object.assign(known ?? {}, { id, revision, kept: content, origin });
    this.#projects.set(content.model, project);
    this.#byId.set(id, new WeakRef(project));
  }

  /** Ties a model that is about to be opened to a new project, which is kept from the start. */
  begin(model: ModelRef): void {
    this.#projects.set(model, { id: randomId(), revision: 0, kept: null, origin: null });
  }

  /** What is about to take a model's place in its own project: the same model, unwrapped or in another variant. */
  succeed(before: ModelRef, after: ModelRef): void {
    const project = this.#projects.get(before);
    if (project) this.#projects.set(after, project);
  }

  /** The open project was deleted: it stays on the page, and comes back as another one when it is changed. */
  forget(id: string): void {
    const current = this.#current;
    if (current?.id !== id) return;
    Object.assign(current, { id: randomId(), revision: 0, kept: this.#content(), origin: null });
    this.#tell();
  }

  /** The page is seen again: meanwhile another tab may have renamed what is open here, or deleted it. */
  async seenAgain(): Promise<void> {
    const project = this.#current;
    if (!project || project.revision === 0) return;
    const { id, revision } = project;
    let name: string | null;
    try {
      name = await this.#parts.projects.nameOf(id);
    } catch {
      // A browser that keeps nothing says so when there is something to keep.
      return;
    }
    const { kept } = project;
    // A save, done or due, finds out by itself, and brings a deleted one back.
    if (project !== this.#current || project.revision !== revision || this.#running || this.pending || !kept) return;
    if (name !== null) {
      if (name !== kept.name) this.#rename(project, kept, name);
      return;
    }
    this.forget(id);
    this.#parts.notices.deleted(() => {
      project.kept = null;
      this.#observe();
    });
  }

  get projectId(): string | null {
    return this.#current?.id ?? null;
  }

  /** The name under which a model's project is known. */
  nameOf(model: ModelRef): string | undefined {
    return this.#projects.get(model)?.kept?.name;
  }

  /** Whether the newest recorded step is nowhere but on this page. */
  get pending(): boolean {
    const content = this.#content();
    return content !== null && this.#current !== null && !same(this.#current.kept, content);
  }

  /** Whether a project that was left before is kept nowhere but on this page. */
  get leaves(): boolean {
    return !this.#left.isEmpty;
  }

  /** What was left of a model is in a file, and need not be kept. */
  inFile(model: ModelRef): void {
    this.#left.dropModel(model);
  }

  /** Saves at once what is not kept yet; resolves when that was done or refused. */
  flush(): Promise<void> {
    return this.#flush(true);
  }

  /** @param all also what was refused and left, whose turn has not come */
  async #flush(all: boolean): Promise<void> {
    clearTimeout(this.#timer);
    this.#rings = Number.POSITIVE_INFINITY;
    // Of several that waited, one has begun the next save: a second from the same revision would look like another tab's.
    while (this.#running) await this.#running;
    if (this.pending || this.leaves) await this.#start(all);
  }

  /**
   * Notes what is not kept yet, without waiting: the page is being left. False where that cannot be done, so that leaving
   * would lose it.
   */
  leave(): boolean {
    const recorded = this.#content();
    const project = this.#current;
    const unmeasured = this.#parts.unmeasured();
    if (!recorded || !project || !(this.pending || unmeasured)) return true;
    const { design } = recorded;
    const content = unmeasured
      ? { ...recorded, design: patchLayer<TextLayer>(design, unmeasured.id, unmeasured.after) }
      : recorded;
    // The note goes on from what is kept of the same model. Where saving was refused, so would the note be when it is read.
    if (this.#refused || project.kept?.model !== content.model || project.revision === 0) return false;
    try {
      const text = this.#packer.packText(content, project.kept.design);
      return (
        text !== null && this.#parts.lastWords.note(project.id, { ...text, revision: project.revision, unmeasured })
      );
    } catch {
      return false;
    }
  }

  /** Makes the open project's picture anew. */
  async refreshThumbnail(): Promise<void> {
    clearTimeout(this.#thumbnailTimer);
    const current = this.#current;
    if (!current || current.revision === 0) return;
    try {
      const picture = await this.#parts.thumbnail();
      if (picture !== null && current === this.#current) await this.#parts.projects.setThumbnail(current.id, picture);
    } catch {
      // A list without this picture is no loss worth a word.
    }
  }

  /** Not in the midst of a gesture: drawing and packing the picture takes the time of several frames. */
  #refreshThumbnailLater(): void {
    clearTimeout(this.#thumbnailTimer);
    this.#thumbnailTimer = setTimeout(() => {
      if (this.#parts.store.state.design === this.#parts.recorded().design) void this.refreshThumbnail();
      else this.#refreshThumbnailLater();
    }, THUMBNAIL_AFTER);
  }

  #observe(): void {
    const content = this.#content();
    if (!content) return;
    this.#enter(content);
    this.#newest = content;
    if (!this.#running) this.#wake();
    this.#tell();
  }

  #wake(): void {
    const soon = this.#lastStart + PACE;
    const open = this.#refused ? this.#lastStart + RETRY : soon;
    const at = Math.min(this.pending ? open : Number.POSITIVE_INFINITY, this.#left.nextAt(soon));
    if (at >= this.#rings) return;
    clearTimeout(this.#timer);
    this.#rings = at;
    this.#timer = setTimeout(() => void this.#flush(false), Math.max(0, at - performance.now()));
  }

  /** What is to be kept now; null while one model takes the place of another. */
  #content(): ProjectContent | null {
    const { model, switching, designName, targetSettings } = this.#parts.store.state;
    const recorded = this.#parts.recorded();
    if (switching || !model || recorded.model !== model.ref) return null;
    return { name: designName, design: recorded.design, model: model.ref, targets: targetSettings };
  }

  #enter(content: ProjectContent): void {
    const { model } = content;
    const known = this.#projects.get(model);
    // As it came: a demo is kept once it differs from that.
    const kept = model.demoId === null ? null : content;
    const project = known ?? { id: randomId(), revision: 0, kept, origin: null };
    if (project === this.#current) return;
    this.#projects.set(model, project);
    this.#byId.set(project.id, new WeakRef(project));
    if (this.#current && this.#newest && !same(this.#current.kept, this.#newest)) {
      this.#left.put(this.#current, this.#newest);
    }
    this.#left.drop(project);
    // What it told was of the one before, which is told by its name if it is refused again.
    this.#refused?.();
    this.#refused = null;
    this.#current = project;
    void this.#parts.lock.take(project.id);
    void this.#touch(project);
  }

  /** Makes the current project the one that was open last, and learns what became of it while another was. */
  async #touch(project: OpenProject): Promise<void> {
    const { id, revision, kept } = project;
    if (revision === 0) return;
    let row: ProjectTouch | null;
    try {
      row = await this.#parts.projects.touch(id);
    } catch {
      // A browser that keeps nothing says so when there is something to keep.
      return;
    }
    // A save under way finds out by itself, and knows better.
    if (project !== this.#current || project.revision !== revision || this.#running) return;
    if (row === null) this.forget(id);
    else if (row.revision !== revision) project.kept = null;
    else if (kept && row.name !== kept.name) this.#rename(project, kept, row.name);
    this.#observe();
  }

  #rename(project: OpenProject, kept: ProjectContent, name: string): void {
    const { store } = this.#parts;
    project.kept = { ...kept, name };
    if (store.state.designName === kept.name) store.set({ designName: name });
  }

  #start(all: boolean): Promise<void> {
    const run = this.#save(all).finally(() => {
      this.#running = null;
      this.#observe();
    });
    this.#running = run;
    return run;
  }

  /** What was left behind first: it is older. */
  async #save(all: boolean): Promise<void> {
    this.#lastStart = performance.now();
    let brought = false;
    for (const [project, content] of all ? this.#left.all() : this.#left.due(this.#lastStart)) {
      if (await this.#saveOne(project, content)) {
        brought = true;
        if (this.#left.drop(project)) this.#parts.notices.restored(content);
      }
    }
    const content = this.#content();
    const project = this.#current;
    if (content && project && this.pending) await this.#saveOne(project, content);
    // The one that was saved last is not the one that is open.
    else if (project && brought) void this.#touch(project);
  }

  /** False where the browser refused it. */
  async #saveOne(project: OpenProject, content: ProjectContent): Promise<boolean> {
    this.#tell();
    try {
      const isNew = project.revision === 0;
      const named = isNew ? await this.#named(content, project.id) : await this.#renamed(content, project);
      const packed = await this.#packer.pack(named);
      project.revision = await this.#parts.projects.save(project.id, packed, project.revision);
      project.kept = named;
      // What was noted and is not measured yet is not in what was saved.
      if (!this.#parts.unmeasured()) this.#parts.lastWords.forget(project.id);
      this.#saved(project);
      return true;
    } catch (thrown) {
      this.#failed(project, content, storageError(thrown, this.#parts.strings));
      return false;
    }
  }

  /** A new project's name is one that no other has: in a list, two of a name could not be told apart. */
  async #named(content: ProjectContent, id: string): Promise<ProjectContent> {
    const name = await this.#parts.projects.freeName(content.name, id);
    const { store } = this.#parts;
    // Meanwhile the user may have chosen another, or opened another project.
    if (name !== content.name && this.#current?.id === id && store.state.designName === content.name) {
      store.set({ designName: name });
    }
    return { ...content, name };
  }

  /** A name that the project was given elsewhere, in another tab's list, stays, unless it was given one here too. */
  async #renamed(content: ProjectContent, project: OpenProject): Promise<ProjectContent> {
    const { kept } = project;
    const name = await this.#parts.projects.nameOf(project.id);
    if (!kept || name === null || name === kept.name || content.name !== kept.name) return content;
    // Only of what is open the page shows the name.
    if (project === this.#current) this.#rename(project, kept, name);
    return { ...content, name };
  }

  #saved(project: OpenProject): void {
    if (project === this.#current && this.#refused) {
      this.#refused();
      this.#refused = null;
      this.#parts.notices.restored(null);
    }
    // The picture shows what is open.
    if (project === this.#current) this.#refreshThumbnailLater();
    if (project.revision >= SAVES_BEFORE_PERSIST) void this.#persist();
  }

  #failed(project: OpenProject, content: ProjectContent, error: TexelcastError): void {
    if (error.code === "storage-conflict") {
      const { store, strings, lock, notices } = this.#parts;
      Object.assign(project, { id: randomId(), revision: 0, kept: null });
      const name = strings.projects.copyOf(content.name);
      if (project === this.#current) {
        store.set({ designName: name });
        void lock.take(project.id);
      } else {
        this.#left.put(project, { ...content, name });
      }
      notices.copied(name);
      // At once, not after the pause that a refusal asks for.
      this.#lastStart = Number.NEGATIVE_INFINITY;
      return;
    }
    const { notices } = this.#parts;
    if (project === this.#current) this.#refused ??= notices.refused(error, null);
    else this.#left.refused(project, performance.now(), () => notices.refused(error, content));
  }

  /** Browsers without a question of their own decide by use; Firefox asks its user, once. */
  async #persist(): Promise<void> {
    if (this.#persistAsked) return;
    this.#persistAsked = true;
    try {
      if (!(await navigator.storage?.persisted())) await navigator.storage?.persist();
    } catch {
      // The data is kept as long as the browser likes.
    }
  }

  #tell(): void {
    const kept = !this.pending ? "kept" : this.#refused ? "refused" : "pending";
    const project = this.#current;
    this.#parts.store.set({ keeping: project?.kept && project.revision > 0 ? kept : unkept(kept) });
    if (project) this.#parts.tab.remember(this.#placeOf(project));
  }

  /** Where a reload finds what is shown. */
  #placeOf({ id, revision, origin }: OpenProject): TabPlace {
    const demo = this.#newest?.model.demoId ?? null;
    if (revision === 0 && origin !== null) return { project: origin };
    return revision === 0 && demo !== null ? { demo } : { project: id };
  }
}

/** A demo as it came is not kept, nor need it be. */
const unkept = (state: EditorState["keeping"]): EditorState["keeping"] => (state === "kept" ? "untouched" : state);

function same(a: ProjectContent | null, b: ProjectContent): boolean {
  if (a === null || a.model !== b.model) return false;
  return a.name === b.name && a.design === b.design && sameTargets(a.targets, b.targets);
}

type Targets = ReadonlyMap<number, TargetSettings>;

function sameTargets(a: Targets, b: Targets): boolean {
  if (a === b) return true;
  const text = (targets: Targets): string => JSON.stringify([...targets].sort(([left], [right]) => left - right));
  return text(a) === text(b);
}
