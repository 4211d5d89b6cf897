/**
 * Keeps the open project in the browser: after each recorded step, soon; at once when the page may be closed. A demo that
 * nothing was changed on is not kept, the user's own model is from the start. Models and projects belong together:
 * opening another model begins another project, and an undo that brings the model back brings its project back.
 */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { EditorState, ModelRef, Snapshot, TargetSettings } from "../state/editor-state.ts";
import type { Store } from "../state/store.ts";
import type { Strings } from "../strings.ts";
import { randomId } from "./content-hash.ts";
import { ProjectPacker } from "./packed-project.ts";
import type { ProjectContent } from "./project.ts";
import type { ProjectLock } from "./project-lock.ts";
import type { ProjectStore } from "./project-store.ts";

export interface AutosaveParts {
  readonly store: Store<EditorState>;
  readonly recorded: () => Snapshot;
  readonly projects: Pick<ProjectStore, "save" | "setThumbnail" | "freeName">;
  readonly lock: Pick<ProjectLock, "take">;
  /** A small picture of the model as it is seen; null where there is none. */
  readonly thumbnail: () => Promise<string | null>;
  readonly notices: AutosaveNotices;
  readonly strings: Strings;
}

export interface AutosaveNotices {
  refused(error: TexelcastError): void;
  restored(): void;
  /** Another tab has saved the project: from here on this tab has a copy. */
  copied(name: string): void;
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
}

export class Autosave {
  readonly #parts: AutosaveParts;
  readonly #packer: ProjectPacker;
  readonly #projects = new WeakMap<ModelRef, OpenProject>();
  #current: OpenProject | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #thumbnailTimer: ReturnType<typeof setTimeout> | undefined;
  #lastStart = Number.NEGATIVE_INFINITY;
  #running: Promise<void> | null = null;
  #refused = false;
  #persistAsked = false;

  constructor(parts: AutosaveParts) {
    this.#parts = parts;
    this.#packer = new ProjectPacker(parts.strings);
    parts.store.subscribe(() => this.#observe());
  }

  /** Ties a model that is about to be opened to a project that is kept already. */
  adopt(content: ProjectContent, id: string, revision: number): void {
    this.#projects.set(content.model, { id, revision, kept: content });
  }

  /** Ties a model that is about to be opened to a new project, which is kept from the start. */
  begin(model: ModelRef): void {
    this.#projects.set(model, { id: randomId(), revision: 0, kept: null });
  }

  /** The open project was deleted: it stays on the page, and comes back as another one when it is changed. */
  forget(id: string): void {
    const current = this.#current;
    if (current?.id !== id) return;
    Object.assign(current, { id: randomId(), revision: 0, kept: this.#content() });
    this.#tell();
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

  /** Saves at once what is not kept yet; resolves when that was done or refused. */
  async flush(): Promise<void> {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    // Of several that waited, one has begun the next save: a second from the same revision would look like another tab's.
    while (this.#running) await this.#running;
    if (this.pending) await this.#start();
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
    if (this.pending && this.#timer === undefined && !this.#running) {
      const wait = Math.max(0, this.#lastStart + (this.#refused ? RETRY : PACE) - performance.now());
      this.#timer = setTimeout(() => void this.flush(), wait);
    }
    this.#tell();
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
    const project = known ?? { id: randomId(), revision: 0, kept: model.demoId === null ? null : content };
    if (project === this.#current) return;
    this.#projects.set(model, project);
    this.#current = project;
    void this.#parts.lock.take(project.id);
  }

  #start(): Promise<void> {
    const run = this.#save().finally(() => {
      this.#running = null;
      this.#observe();
    });
    this.#running = run;
    return run;
  }

  async #save(): Promise<void> {
    const content = this.#content();
    const project = this.#current;
    if (!content || !project) return;
    this.#lastStart = performance.now();
    this.#tell();
    try {
      const named = project.revision > 0 ? content : await this.#named(content, project.id);
      const packed = await this.#packer.pack(named);
      project.revision = await this.#parts.projects.save(project.id, packed, project.revision);
      project.kept = named;
      this.#saved(project);
    } catch (thrown) {
      this.#failed(project, TexelcastError.wrap(thrown, "storage-refused", String(thrown)));
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

  #saved(project: OpenProject): void {
    if (this.#refused) this.#parts.notices.restored();
    this.#refused = false;
    this.#refreshThumbnailLater();
    if (project.revision >= SAVES_BEFORE_PERSIST) void this.#persist();
  }

  #failed(project: OpenProject, error: TexelcastError): void {
    if (error.code === "storage-conflict") {
      Object.assign(project, { id: randomId(), revision: 0, kept: null });
      const name = this.#parts.strings.projects.copyOf(this.#parts.store.state.designName);
      this.#parts.store.set({ designName: name });
      void this.#parts.lock.take(project.id);
      this.#parts.notices.copied(name);
      // At once, not after the pause that a refusal asks for.
      this.#lastStart = Number.NEGATIVE_INFINITY;
      return;
    }
    if (!this.#refused) this.#parts.notices.refused(error);
    this.#refused = true;
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
    this.#parts.store.set({ keeping: this.#current?.kept && this.#current.revision > 0 ? kept : unkept(kept) });
  }
}

/** A demo as it came is not kept, nor need it be. */
const unkept = (state: EditorState["keeping"]): EditorState["keeping"] => (state === "kept" ? "untouched" : state);

function same(a: ProjectContent | null, b: ProjectContent): boolean {
  return a !== null && a.name === b.name && a.design === b.design && sameTargets(a.targets, b.targets);
}

type Targets = ReadonlyMap<number, TargetSettings>;

function sameTargets(a: Targets, b: Targets): boolean {
  if (a === b) return true;
  const text = (targets: Targets): string => JSON.stringify([...targets].sort(([left], [right]) => left - right));
  return text(a) === text(b);
}
