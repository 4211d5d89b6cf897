/** Files in and out: models, designs and pictures opened or dropped; designs saved, textures and models exported. */

import type { TexelcastError } from "../../core/texelcast-error.ts";
import { nameOf } from "../../engine/companion-files.ts";
import type { Engine, ModelInfo } from "../../engine/engine-api.ts";
import { ARCHIVE } from "../../engine/zipped-files.ts";
import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import { type Design, emptyDesign, materialsIn, parseDesign, serialiseDesign } from "../document/index.ts";
import {
  type DemoCatalogue,
  type DemoDecal,
  type DemoModel,
  type DemoTemplate,
  fetchBytes,
} from "../files/demo-catalogue.ts";
import { download, fileNameOf, fileStem } from "../files/download.ts";
import { bytesOf } from "../files/file-bytes.ts";
import type { CollectedFile } from "../files/file-collection.ts";
import { type Intake, sortFiles } from "../files/file-intake.ts";
import { unzipInWorker } from "../files/project-client.ts";
import { noteRead } from "../storage/packed-project.ts";
import type { ProjectContent } from "../storage/project.ts";
import { ToldError } from "../strings/told-error.ts";
import type { PaletteCommands } from "../tools/palette-commands.ts";
import type { Admission } from "./admission.ts";
import type { AssetLibrary, DesignPlace, LibraryPicture } from "./asset-library.ts";
import { BareModelError } from "./bare-model-error.ts";
import type { DecalCommands } from "./decal-commands.ts";
import { layerById, paintedMaterials } from "./design-edits.ts";
import type { DesignSession } from "./design-session.ts";
import type { ModelRef } from "./design-state.ts";
import type { EditorState } from "./editor-state.ts";
import type { ModelSession } from "./model-session.ts";
import { MAX_NOTICES, type NoticeBoard } from "./notice-board.ts";
import type { NoticeAction } from "./notices.ts";
import type { ProjectCommands } from "./project-commands.ts";
import { returnedLayers } from "./returned-layers.ts";
import type { Store } from "./store.ts";
import type { Tasks } from "./tasks.ts";
import type { TextCommands } from "./text-commands.ts";
import type { UnwrapCommand } from "./unwrap-command.ts";

export interface FileCommandsParts {
  readonly engine: Engine;
  readonly store: Store<EditorState>;
  readonly session: DesignSession;
  readonly models: ModelSession;
  readonly decals: DecalCommands;
  readonly library: AssetLibrary;
  readonly board: NoticeBoard;
  readonly tasks: Tasks;
  /** Null: whatever can be opened may be. */
  readonly admission: Admission | null;
  /** Null where models are not unwrapped. */
  readonly unwrapping: UnwrapCommand | null;
  readonly texts: () => TextCommands;
  readonly palettes: () => Pick<PaletteCommands, "open">;
  /** Takes back what a tool has under way; false where nothing is. */
  readonly giveUp: () => boolean;
  /** Records what a tool has under way. */
  readonly finishWork: () => void;
  /** A function, because the two need each other. */
  readonly projects: () => ProjectCommands;
}

export class FileCommands {
  readonly #parts: FileCommandsParts;
  /** The notices of what could not be opened, since something was. */
  readonly #refusals: (number | null)[] = [];
  /** Steps through the history that were asked for. */
  #travels: Promise<void> = Promise.resolve();

  constructor(parts: FileCommandsParts) {
    this.#parts = parts;
  }

  /** Takes whatever the user chose or dropped; `hit` is the surface under the drop. */
  openFiles(
    files: Promise<readonly CollectedFile[]> | readonly CollectedFile[],
    hit: SurfaceHit | null = null,
  ): Promise<void> {
    return this.#unlessReadonly(() => this.#coming(this.#openFiles(files, hit)));
  }

  /** Gives a decal the chosen picture in place of its own. */
  replacePicture(id: string, chosen: readonly CollectedFile[]): Promise<void> {
    return this.#unlessReadonly(() => this.#coming(this.#replacePicture(id, chosen)));
  }

  openDemo(demo: DemoModel): Promise<void> {
    return this.#unlessReadonly(() => this.#coming(this.#openDemo(demo)));
  }

  /** Opens a template's model, without a design. */
  openTemplate(template: DemoTemplate): Promise<void> {
    return this.#unlessReadonly(() => this.#coming(this.#openTemplate(template)));
  }

  addDemoDecal(decal: DemoDecal, hit: SurfaceHit | null = null): Promise<void> {
    return this.#unlessReadonly(() => this.#coming(this.#addDemoDecal(decal, hit)));
  }

  /** What would change the design is not begun where it is only looked at, and the user is told. */
  async #unlessReadonly(work: () => Promise<void>): Promise<void> {
    const { store, board, tasks } = this.#parts;
    const { title, message } = board.strings.readonly;
    if (store.state.readonly) board.info({ title, message });
    else await tasks.quietly(work());
  }

  /** What is undone or saved while it is on its way waits until it is there: it was asked for before. */
  async #coming(work: Promise<void>): Promise<void> {
    this.#parts.session.recordsLater(work);
    await work;
  }

  async #openFiles(
    files: Promise<readonly CollectedFile[]> | readonly CollectedFile[],
    hit: SurfaceHit | null,
  ): Promise<void> {
    const { board } = this.#parts;
    let name = "";
    const before = this.#refusals.length;
    try {
      const collected = await files;
      if (collected.length === 0) return;
      const [first] = collected;
      name = collected.length === 1 ? (first?.file.name ?? "") : board.strings.files.several(collected.length);
      const sorted = await sortFiles(await this.#unzipped(collected), board.strings);
      if (this.#parts.admission && (sorted.model || sorted.design || sorted.project)) throw this.#notHere(collected);
      if (sorted.palette) await this.#parts.palettes().open(sorted.palette.file);
      await this.#useSorted(sorted, name, hit);
      for (const path of sorted.useless) {
        const { unknownFile, unknownFileHint: hint } = board.strings.errors;
        board.info({ title: board.strings.notices.notOpened(path), message: unknownFile(path), hint });
      }
    } catch (thrown) {
      this.#refuse(board.strings.errors.couldNotOpen(name), thrown);
    }
    // What was tried in vain before is of no interest once another one is open, and would stand before it.
    if (this.#refusals.length > before) return;
    for (const id of this.#refusals.splice(0)) if (id !== null) board.dismiss(id);
  }

  #refuse(title: string, thrown: unknown, action?: NoticeAction): void {
    this.#refusals.push(this.#parts.board.error(title, thrown, action));
  }

  /** Archives as the files that are in them. */
  async #unzipped(collected: readonly CollectedFile[]): Promise<readonly CollectedFile[]> {
    const { board, tasks } = this.#parts;
    const { errors, tasks: words } = board.strings;
    const files: CollectedFile[] = [];
    for (const each of collected) {
      if (!ARCHIVE.test(each.path)) {
        files.push(each);
        continue;
      }
      const { name } = each.file;
      const bytes = await bytesOf(each.file);
      const unzipped = await tasks.run(words.opening(name), ({ signal }) =>
        unzipInWorker(bytes, each.path, signal, board.strings),
      );
      if (unzipped.length === 0) {
        throw new ToldError("unsupported", errors.nothingZipped(name), { subject: name, hint: errors.unknownFileHint });
      }
      for (const { path, bytes: content } of unzipped) {
        files.push({ path, file: new File([content], nameOf(path)) });
      }
    }
    return files;
  }

  /** @param name what a refusal names where it is about no file alone */
  async #useSorted(sorted: Intake, name: string, hit: SurfaceHit | null): Promise<void> {
    const { model, design, project } = sorted;
    const named = project ? project.file.name : model && design ? model.name : name;
    try {
      if (project) {
        const own = model && { source: model, title: sorted.title ?? model.name, demoId: null };
        await this.#parts.projects().openFile(named, await bytesOf(project.file), own);
      } else {
        await this.#openSorted(sorted, hit);
      }
    } catch (thrown) {
      this.#tellRefusal(named, thrown, ({ source }) => this.#useSorted({ ...sorted, model: source }, name, hit));
    }
  }

  async #openSorted(
    { model, title, design, pictures, fonts, companions }: Intake,
    hit: SurfaceHit | null,
  ): Promise<void> {
    const { library } = this.#parts;
    const opened = design && (await this.#readDesign(design, companions));
    try {
      if (model) {
        const ref = { source: model, title: title ?? model.name, demoId: null };
        await this.#openModel(ref, opened ?? emptyDesign());
      } else if (opened && design) this.#takeDesign(opened, design.file.name);
    } finally {
      library.release(Object.values(opened?.assets ?? {}));
    }
    this.#checkModel(pictures, fonts);
    // A place on the surface is one of the model that was there before.
    const place = model ? null : hit;
    await this.#useEach(fonts, (font) => this.#useFont(font, place));
    await this.#useEach(pictures, (picture) => this.#addPicture(picture, place, pictures.length > 1));
  }

  /**
   * Says why something was not opened. Where it is a model that lacks texture coordinates of use, a press unwraps it, and `again`
   * opens it so.
   */
  #tellRefusal(name: string, thrown: unknown, again: (unwrapped: ModelRef) => Promise<void>): void {
    const { board, unwrapping } = this.#parts;
    const { couldNotOpen, bareModel, brokenUvs, bareModelHint: hint, unwrapAndOpen } = board.strings.errors;
    if (unwrapping === null || !(thrown instanceof BareModelError)) {
      this.#refuse(couldNotOpen(name), thrown);
      return;
    }
    const { code, model, subject = "" } = thrown;
    const message = (code === "no-uvs" ? bareModel : brokenUvs)(subject);
    const action = {
      label: unwrapAndOpen,
      run: (): void => void this.#unlessReadonly(() => unwrapping.openBare(model, again, offerAgain)),
    };
    // The file is still at hand, and who stopped the work may have second thoughts.
    const offerAgain = (): number =>
      board.info({ title: board.strings.notices.notOpened(name), message, hint, action, stays: true });
    this.#refuse(couldNotOpen(name), new ToldError(code, message, { subject, hint }), action);
  }

  /** @param unwrapped opened in place of the demo's own model */
  async #openDemo(demo: DemoModel, unwrapped?: ModelRef): Promise<void> {
    const { store, library } = this.#parts;
    const { demos } = store.state;
    if (!demos) return;
    try {
      const { bytes, design } = await this.#fetchDemo(demo, demos);
      const source = { name: nameOf(demo.model), bytes };
      try {
        await this.#openModel(unwrapped ?? { source, title: demo.name, demoId: demo.id }, design);
      } finally {
        library.release(Object.values(design.assets));
      }
    } catch (thrown) {
      this.#tellRefusal(demo.name, thrown, (model) => this.#openDemo(demo, model));
    }
  }

  /** A demo's model and its design, whose pictures are to be released: they come side by side. */
  #fetchDemo(demo: DemoModel, demos: DemoCatalogue): Promise<{ bytes: Uint8Array; design: Design }> {
    const { library, board } = this.#parts;
    return this.#opening(demo.name, async () => {
      const parsed = parseDesign(demo.design, demo.name);
      const { named } = board.strings;
      const layers = parsed.layers.map((layer) => ({ ...layer, name: named(layer.name) }));
      const [model, adopted] = await Promise.allSettled([
        fetchBytes(demo.model, demos.page),
        library.adopt({ ...parsed, layers }, { path: demo.name, baseUrl: demos.url }),
      ]);
      if (adopted.status === "rejected") throw adopted.reason;
      if (model.status === "fulfilled") return { bytes: model.value, design: adopted.value };
      library.release(Object.values(adopted.value.assets));
      throw model.reason;
    });
  }

  /** On a slow line it takes its time, which is said. */
  #opening<T>(name: string, work: () => Promise<T>): Promise<T> {
    return this.#parts.tasks.run(this.#parts.board.strings.tasks.opening(name), work, { cancellable: false });
  }

  async #openTemplate({ name, model }: DemoTemplate): Promise<void> {
    const { store } = this.#parts;
    if (!store.state.demos) return;
    try {
      const { page } = store.state.demos;
      const bytes = await this.#opening(name, () => fetchBytes(model, page));
      const source = { name: nameOf(model), bytes };
      await this.#openModel({ source, title: name, demoId: null }, emptyDesign());
    } catch (thrown) {
      this.#tellRefusal(name, thrown, (unwrapped) => this.#openModel(unwrapped, emptyDesign()));
    }
  }

  async #addDemoDecal(decal: DemoDecal, hit: SurfaceHit | null): Promise<void> {
    const { store, library, decals, board } = this.#parts;
    if (!store.state.demos || !store.state.model) return;
    try {
      const bytes = await fetchBytes(decal.picture, store.state.demos.page);
      const picture = await library.add(decal.picture, bytes);
      decals.add(decal.name, picture, hit);
      library.release([picture.asset]);
    } catch (thrown) {
      board.error(this.#parts.board.strings.errors.couldNotOpen(decal.name), thrown);
    }
  }

  async saveDesign(): Promise<void> {
    const { session, store, board } = this.#parts;
    await session.settled();
    const name = `${fileNameOf(store.state.designName)}.design.json`;
    download(name, "application/json", serialiseDesign(session.recordedDesign));
    session.markSaved();
    board.announce(this.#parts.board.strings.announce.saved(name));
  }

  async exportPng(): Promise<void> {
    const { engine, store } = this.#parts;
    const { material, model } = store.state;
    if (material === null || !model) return;
    const name = `${fileNameOf(store.state.designName)}-${this.#textureName(model.info, material)}.png`;
    await this.#export(name, "image/png", () => engine.exportPng(material));
  }

  /** Of one of several, by which its file does not take another's place. */
  #textureName({ materials }: ModelInfo, material: number): string {
    const paintable = materials.filter(({ refusal }) => refusal === null);
    if (paintable.length < 2) return "texture";
    const { materialName } = this.#parts.board.strings;
    const { name = "" } = materials[material] ?? {};
    const isOnly = paintable.filter((other) => other.name === name).length === 1;
    return fileNameOf(materialName(material, isOnly ? name : ""));
  }

  async exportGlb(): Promise<void> {
    await this.#exportModel("glb", "model/gltf-binary", (engine, materials) => engine.exportGlb(materials));
  }

  async exportUsdz(): Promise<void> {
    await this.#exportModel("usdz", "model/vnd.usdz+zip", (engine, materials) => engine.exportUsdz(materials));
  }

  async #exportModel(
    ending: string,
    type: string,
    write: (engine: Engine, materials: readonly number[]) => Promise<Uint8Array<ArrayBuffer>>,
  ): Promise<void> {
    const { engine, session, models, store } = this.#parts;
    if (!store.state.model) return;
    await this.#export(`${fileNameOf(store.state.designName)}-painted.${ending}`, type, async () => {
      const design = session.recordedDesign;
      // The preparation of one may have been cancelled: its paint must not be lacking without a word.
      await models.ensureTargets(design);
      return write(engine, paintedMaterials(design));
    });
  }

  /** One step back or forth. In the middle of a stroke or of another change it is that which is taken back, and not the step before. */
  async travel(direction: "undo" | "redo"): Promise<void> {
    const { giveUp, finishWork } = this.#parts;
    if (direction === "redo") finishWork();
    else if (giveUp()) return;
    await this.#inTurn(() => this.#step(direction));
  }

  async #step(direction: "undo" | "redo"): Promise<void> {
    const { session, store, board } = this.#parts;
    await session.settled();
    if (session.cancelPreview()) return;
    const label = direction === "undo" ? store.state.undoLabel : store.state.redoLabel;
    const position = session.position + (direction === "undo" ? -1 : 1);
    await this.#travelTo(position, () =>
      board.announce(
        direction === "undo"
          ? this.#parts.board.strings.announce.undone(label ?? "")
          : this.#parts.board.strings.announce.redone(label ?? ""),
      ),
    );
  }

  /** To any step of the history: a place among its labels. */
  async travelTo(position: number): Promise<void> {
    const { session, store, board, giveUp } = this.#parts;
    giveUp();
    await this.#inTurn(async () => {
      await session.settled();
      const label = store.state.history.labels[position];
      const { announce, history } = board.strings;
      await this.#travelTo(position, () => board.announce(announce.travelled(history.step(label ?? ""))));
    });
  }

  /** One after the other: a step that opens another model takes its time, and the next goes out from where it arrives. */
  #inTurn(work: () => Promise<void>): Promise<void> {
    const turn = this.#travels.then(work);
    this.#travels = turn.catch(() => undefined);
    return turn;
  }

  /** Steps lead across models too, which takes a moment: the old model is opened again. */
  async #travelTo(position: number, arrived: () => void): Promise<void> {
    const { session, store, models, board } = this.#parts;
    if (store.state.switching || store.state.readonly || position === session.position) return;
    const goal = session.snapshotAt(position);
    if (!goal) return;
    const arrive = (): void => {
      session.travelTo(position);
      arrived();
    };
    if (goal.model === store.state.model?.ref || goal.model === null) {
      const [id, ...others] = returnedLayers(session.recordedDesign, goal.design);
      arrive();
      // It was chosen when it went or came, and is what comes next is about.
      if (id !== undefined) session.select(id, others);
      return;
    }
    const { model, design } = goal;
    const label = store.state.history.labels[position] ?? "";
    try {
      const onOpen = (): void => {
        store.set({ designName: this.#parts.projects().nameOf(model) ?? fileStem(model.title) });
        if (session.snapshotAt(position) === goal) {
          arrive();
          return;
        }
        // A step that was recorded while the model was being read has taken its place: it comes after that one.
        session.recordModel(model, design, label);
        arrived();
      };
      await models.open(model, design, onOpen, { keepsView: true });
    } catch (thrown) {
      board.error(this.#parts.board.strings.errors.couldNotOpen(model.title), thrown);
    }
  }

  async #openModel(ref: ModelRef, design: Design): Promise<void> {
    const { session, models, store, board } = this.#parts;
    let left = session.recordedDesign;
    let worked = false;
    await models.open(ref, design, () => {
      // With what was done while the model was being read.
      left = session.recordedDesign;
      worked = store.state.unsaved && left.layers.length > 0;
      store.set({ designName: fileStem(ref.title) });
      session.recordModel(ref, design, this.#parts.board.strings.steps.openModel);
      session.select(design.layers[0]?.id ?? null);
    });
    board.dismissAll();
    board.announce(this.#parts.board.strings.announce.opened(ref.title));
    if (worked) {
      const bring = (): void => session.record({ ...left }, this.#parts.board.strings.steps.bringDecals);
      board.info({
        title: this.#parts.board.strings.notices.newModel(ref.title),
        message: this.#parts.board.strings.notices.workKept,
        action: { label: this.#parts.board.strings.notices.bringDecals, run: bring },
      });
    }
  }

  async #readDesign(file: CollectedFile, companions: readonly CollectedFile[]): Promise<Design> {
    const parsed = parseDesign(await file.file.text(), file.file.name);
    noteRead(parsed);
    const place: DesignPlace = { path: file.path, files: companions };
    return this.#opening(file.file.name, () => this.#parts.library.adopt(parsed, place));
  }

  /** Opens a model with a design that was read and is whole; what was open before stays in the history. */
  async openProject({ name, design, model, targets }: ProjectContent): Promise<void> {
    const { session, models, store, board } = this.#parts;
    noteRead(design);
    models.rememberSettings(model, targets);
    await models.open(model, design, () => {
      store.set({ designName: name });
      session.recordModel(model, design, this.#parts.board.strings.steps.openProject);
      session.select(design.layers.at(-1)?.id ?? null);
    });
    board.dismissAll();
    board.announce(this.#parts.board.strings.announce.opened(name));
  }

  #takeDesign(design: Design, fileName: string): void {
    const { session, store, board } = this.#parts;
    store.set({ designName: fileStem(fileName) });
    session.record(design, this.#parts.board.strings.steps.openDesign);
    session.markSaved();
    session.select(design.layers.at(-1)?.id ?? null);
    const materials = new Set(store.state.model?.info.materials.map(({ index }) => index));
    const lost = design.layers.filter(
      (layer) => !materialsIn(layer).every((material) => materials.has(material)),
    ).length;
    if (lost > 0)
      board.info({
        title: this.#parts.board.strings.notices.otherModel,
        message: this.#parts.board.strings.notices.lostLayers(lost),
      });
    board.announce(this.#parts.board.strings.announce.opened(fileName));
  }

  /** In somebody's page the model and the design are the page's. */
  #notHere([first]: readonly CollectedFile[]): TexelcastError {
    const { notHere, notHereHint } = this.#parts.board.strings.errors;
    const subject = first?.path ?? "";
    return new ToldError("unsupported", notHere(subject), { subject, hint: notHereHint });
  }

  /** Said once, and not for each of the files. */
  #checkModel(pictures: readonly CollectedFile[], fonts: readonly CollectedFile[]): void {
    const { store, board } = this.#parts;
    const [first] = [...pictures, ...fonts];
    if (!first || store.state.model) return;
    const { noModelYet, noModelForText } = board.strings.errors;
    const message = pictures.length > 0 ? noModelYet : noModelForText;
    throw new ToldError("bad-argument", message, { subject: first.file.name });
  }

  /** What cannot be used is named, and keeps none of the others out. */
  async #useEach(files: readonly CollectedFile[], use: (file: CollectedFile) => Promise<void>): Promise<void> {
    const { board } = this.#parts;
    const refused: { readonly name: string; readonly thrown: unknown }[] = [];
    for (const each of files) {
      await use(each).catch((thrown: unknown) => refused.push({ name: each.file.name, thrown }));
    }
    const { couldNotOpen, couldNotOpenThese } = board.strings.errors;
    const names = refused.map(({ name }) => name);
    if (names.length > MAX_NOTICES) this.#refuse(couldNotOpenThese(names), refused[0]?.thrown);
    else for (const { name, thrown } of refused) this.#refuse(couldNotOpen(name), thrown);
  }

  async #addPicture({ file }: CollectedFile, hit: SurfaceHit | null, apart: boolean): Promise<void> {
    const { library, decals, admission } = this.#parts;
    admission?.checkRoom(1);
    const picture = await this.#takePicture(file);
    try {
      // Somebody may have added another one meanwhile.
      admission?.checkRoom(1);
      decals.add(fileStem(file.name), picture, hit, apart);
    } finally {
      library.release([picture.asset]);
    }
  }

  /** To be released by who asked for it. */
  async #takePicture(file: File): Promise<LibraryPicture> {
    const { library, admission } = this.#parts;
    const bytes = await bytesOf(file);
    return await library.add(file.name, (await admission?.admit("picture", file.name, bytes)) ?? bytes);
  }

  async #replacePicture(id: string, [chosen]: readonly CollectedFile[]): Promise<void> {
    const { library, decals, board, session } = this.#parts;
    if (!chosen) return;
    const { file } = chosen;
    try {
      const picture = await this.#takePicture(file);
      try {
        const { recordedDesign } = session;
        const layer = layerById(recordedDesign, id);
        const before = layer?.type === "decal" ? library.get(recordedDesign.assets[layer.asset]) : undefined;
        decals.replacePicture(id, fileStem(file.name), picture, before);
      } finally {
        library.release([picture.asset]);
      }
    } catch (thrown) {
      board.error(board.strings.errors.couldNotOpen(file.name), thrown);
    }
  }

  async #useFont({ file }: CollectedFile, hit: SurfaceHit | null): Promise<void> {
    const bytes = await bytesOf(file);
    const admitted = await this.#parts.admission?.admit("font", file.name, bytes);
    await this.#parts.texts().useFontFile(file.name, admitted ?? bytes, hit);
  }

  async #export(name: string, type: string, make: () => Promise<Uint8Array>): Promise<void> {
    const { tasks, board, session } = this.#parts;
    await session.settled();
    try {
      const bytes = await tasks.run(this.#parts.board.strings.tasks.exporting(name), make, { cancellable: false });
      download(name, type, bytes);
      board.announce(this.#parts.board.strings.announce.exported(name));
      await this.#parts.texts().tellMissing();
    } catch (thrown) {
      board.error(this.#parts.board.strings.errors.couldNotExport(name), thrown);
    }
  }
}
