/**
 * Long use of the editor at random: whatever is done, in whatever order, each step of the history is one picture, and what is
 * saved is what is seen. One seed and few acts here; a longer one is asked for by the environment:
 *
 *     TEXELCAST_SOAK_SEEDS=1,2,3 TEXELCAST_SOAK_ACTS=200 TEXELCAST_SOAK_MODEL=ten npx playwright test e2e/soak
 *
 * The model is one of `SOAK_MODELS`, or the path of a GLB. What was done is printed where it fails; with TEXELCAST_SOAK_LOUD=1 each act as
 * it begins.
 */
import { readFileSync } from "node:fs";
import path from "node:path";
import type { Editor } from "../../web/editor/state/editor.ts";
import { seeded } from "../support/seeded.ts";
import { type EditorPage, expect, type TestFile, test } from "./support/editor-page.ts";
import { renderedAs } from "./support/rendered.ts";
import { FIRST_ACTS, SOAK_ACTS, Soak } from "./support/soak-acts.ts";
import { SOAK_MODELS } from "./support/soak-models.ts";
import { file } from "./support/test-files.ts";

const {
  TEXELCAST_SOAK_SEEDS = "1",
  TEXELCAST_SOAK_ACTS = "40",
  TEXELCAST_SOAK_MODEL = "ten",
  TEXELCAST_SOAK_LOUD,
} = process.env;
const ACTS = Number(TEXELCAST_SOAK_ACTS);
/** After so many acts what is kept is read again. */
const KEPT_AFTER = 20;

declare global {
  interface Window {
    /** What each step was seen as, by itself and by the sizes of the textures. */
    seenSteps: WeakMap<object, Map<string, string>>;
  }
}

/** What is seen of the open textures, and the document; `changed` names a step that was seen otherwise before. */
interface Seen {
  /** By material, size and gutter. */
  readonly hashes: Readonly<Record<string, string>>;
  readonly design: string;
  readonly changed: string | null;
}

const command = <Result>(editor: EditorPage, run: (of: Editor) => Result): Promise<Awaited<Result>> =>
  editor.page.evaluate(`(${run})(document.querySelector("tc-workbench").editor)`) as Promise<Awaited<Result>>;

const seen = (editor: EditorPage): Promise<Seen> =>
  command(editor, async ({ store, session, engine }) => {
    await window.texelcast.idle();
    const hashes: Record<string, string> = {};
    for (const { material, width, gutter } of store.state.targets.values()) {
      hashes[`material ${material} at ${width}, gutter ${gutter}`] = await engine.hash(material);
    }
    window.seenSteps ??= new WeakMap();
    const before = window.seenSteps.get(session.recorded) ?? new Map<string, string>();
    window.seenSteps.set(session.recorded, before);
    const changed = Object.keys(hashes).find((key) => (before.get(key) ?? hashes[key]) !== hashes[key]);
    for (const [key, hash] of Object.entries(hashes)) if (!before.has(key)) before.set(key, hash);
    const step = `${session.position} (${store.state.undoLabel})`;
    if (session.recorded.model !== store.state.model?.ref) throw new Error(`Step ${step} is of another model.`);
    return { hashes, design: JSON.stringify(session.design), changed: changed ? `${step}: ${changed}` : null };
  });

/** The newest step is the same again after the one before it. */
async function expectSameThereAndBack(editor: EditorPage): Promise<void> {
  const here = await seen(editor);
  expect(here.changed, "a step that looks otherwise than before").toBeNull();
  // The first is the opening of the model itself.
  if ((await command(editor, ({ session }) => session.position)) < 2) return;
  await command(editor, ({ files }) => files.travel("undo"));
  expect((await seen(editor)).changed, "an undone step that looks otherwise than before").toBeNull();
  await command(editor, ({ files }) => files.travel("redo"));
  const back = await seen(editor);
  expect(back.design, "the document after an undo and a redo").toBe(here.design);
  expect(back.changed, "a redone step that looks otherwise than before").toBeNull();
}

/** What the page shows is what it keeps, and what the command line makes of the saved file. */
async function expectKept(editor: EditorPage): Promise<void> {
  const here = await seen(editor);
  const material = await command(editor, ({ store }) => store.state.material);
  const { bytes } = await editor.savedProject();
  const exported = await editor.exported("Texture as PNG");
  const options = ["--material", String(material)];
  const byCommand = renderedAs("rendered.png", [{ name: "saved.texelcast", bytes }], options);
  expect(byCommand.equals(exported.bytes), `the command line makes the page's picture of material ${material}`).toBe(
    true,
  );
  await editor.page.evaluate(() => window.texelcast.kept());
  await editor.reload();
  const again = await seen(editor);
  expect(JSON.parse(again.design), "the document after a reload").toEqual(JSON.parse(here.design));
  const common = Object.keys(again.hashes).filter((key) => key in here.hashes);
  expect(common.length).toBeGreaterThan(0);
  for (const key of common) expect(again.hashes[key], `${key} after a reload`).toBe(here.hashes[key]);
}

const weighed = SOAK_ACTS.flatMap((act) => Array.from({ length: act.weight ?? 1 }, () => act));

const modelNamed = (name: string): TestFile =>
  SOAK_MODELS[name]?.() ?? file(path.basename(name), readFileSync(name), "model/gltf-binary");

for (const seed of TEXELCAST_SOAK_SEEDS.split(",").map(Number)) {
  test(`whatever is done, each step is one picture, and what is kept is what is seen (seed ${seed})`, async ({
    editor,
  }) => {
    test.setTimeout(60_000 + ACTS * 20_000);
    await editor.open();
    await editor.openModel([modelNamed(TEXELCAST_SOAK_MODEL)]);
    const soak = new Soak(editor, seeded(seed * 7919 + 1));
    const done: string[] = [];
    try {
      for (let count = 1; count <= ACTS; count += 1) {
        const first = SOAK_ACTS.find(({ name }) => name === FIRST_ACTS[count - 1]);
        const act = first ?? soak.pick(weighed);
        done.push(act.name);
        if (TEXELCAST_SOAK_LOUD) console.info(`${count}: ${act.name}`);
        await act.run(soak);
        if (count % 3 === 0) await expectSameThereAndBack(editor);
        if (count % KEPT_AFTER === 0 || count === ACTS) await expectKept(editor);
        const refusals = await command(editor, ({ store }) =>
          store.state.notices.filter(({ tone }) => tone === "error"),
        );
        expect(refusals).toEqual([]);
      }
    } catch (thrown) {
      console.info(`Seed ${seed}: ${done.map((name, at) => `${at + 1} ${name}`).join("; ")}`);
      throw thrown;
    }
  });
}
