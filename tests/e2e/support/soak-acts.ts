/** What somebody does in the editor, one thing after the other, by a seed: by mouse, keys and the panels' own commands. */
import { readFileSync } from "node:fs";
import type { Page } from "@playwright/test";
import type { Design, DesignLayer, Projector } from "../../../web/editor/document/index.ts";
import { BLEND_MODES, isPlaced } from "../../../web/editor/document/index.ts";
import type { Editor } from "../../../web/editor/state/editor.ts";
import { paintPng } from "../../support/png-file.ts";
import type { EditorPage, Point } from "./editor-page.ts";
import { SOAK_MODELS } from "./soak-models.ts";
import { file, halfBareGlb } from "./test-files.ts";

const FONT = new URL(
  "../../../node_modules/@expo-google-fonts/lobster/400Regular/Lobster_400Regular.ttf",
  import.meta.url,
);

const SVG =
  '<svg xmlns="http://www.w3.org/2000/svg" width="60" height="40"><rect width="60" height="40" rx="9" fill="#286"/><circle cx="20" cy="20" r="12" fill="#fc3"/></svg>';

export interface Act {
  readonly name: string;
  /** How often it is done beside the others; 1 without it. */
  readonly weight?: number;
  readonly run: (soak: Soak) => Promise<unknown>;
}

export class Soak {
  readonly editor: EditorPage;
  readonly page: Page;
  /** 0 to below 1. */
  readonly random: () => number;

  constructor(editor: EditorPage, random: () => number) {
    this.editor = editor;
    this.page = editor.page;
    this.random = random;
  }

  pick<T>(from: readonly T[]): T {
    return from[Math.floor(this.random() * from.length)] as T;
  }

  between(least: number, most: number): number {
    return least + this.random() * (most - least);
  }

  whole(most: number): number {
    return Math.floor(this.random() * (most + 1));
  }

  /** A place on the view, not too near its rim. */
  async place(): Promise<Point> {
    const box = await this.editor.view.boundingBox();
    if (!box) throw new Error("The page shows no model.");
    return {
      x: box.x + box.width * this.between(0.3, 0.7),
      y: box.y + box.height * this.between(0.3, 0.7),
    };
  }

  /** Runs a function of the page's own editor, as its panels do. */
  command<Argument>(run: (editor: Editor, argument: Argument) => unknown, argument?: Argument): Promise<unknown> {
    return this.page.evaluate(
      `(async () => { await (${run})(document.querySelector("tc-workbench").editor, ${JSON.stringify(argument ?? null)}); })()`,
    );
  }

  /** Keys that are for the view. */
  async keys(...keys: string[]): Promise<void> {
    await this.command((editor) => editor.work.focus());
    for (const key of keys) await this.page.keyboard.press(key);
  }

  /** Any layer of the tree but those in masks and paint layers. */
  async layer(): Promise<DesignLayer | undefined> {
    const all = (layers: Design["layers"]): DesignLayer[] =>
      layers.flatMap((layer) => (layer.type === "group" ? [layer, ...all(layer.layers)] : [layer]));
    const layers = all((await this.editor.design()).layers);
    return layers.length === 0 ? undefined : this.pick(layers);
  }

  /** Chooses any layer. */
  async chosen(): Promise<DesignLayer | undefined> {
    const layer = await this.layer();
    if (layer) await this.editor.select(layer.id);
    return layer;
  }

  /** Changes the chosen layer, as a field of the panel does. */
  async change(patch: object): Promise<void> {
    const layer = await this.chosen();
    if (layer) await this.changeLayer(layer.id, patch);
  }

  async changeLayer(id: string, patch: object): Promise<void> {
    await this.command(
      (editor, [id, patch]) => {
        if (editor.layers.unlocked([id]).length > 0) editor.layers.change(id, patch, "Soak");
      },
      [id, patch] as const,
    );
  }

  /** A drag over the view by mouse. */
  async drag(): Promise<void> {
    const [from, to] = [await this.place(), await this.place()];
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 3 });
    await mouse.move(to.x, to.y, { steps: 3 });
    await mouse.up();
  }

  async useTool(key: string): Promise<void> {
    await this.keys(key);
    await this.drag();
    if (this.random() < 0.3) await this.drag();
    await this.keys("v");
  }
}

const color = (soak: Soak): string => `#${(0x1000000 + soak.whole(0xffffff)).toString(16).slice(1)}`;

const picture = (soak: Soak) => {
  const [a, b] = [soak.whole(255), soak.whole(255)];
  const [width, height] = [8 + soak.whole(90), 8 + soak.whole(90)];
  return file(
    `picture ${a}.png`,
    paintPng(width, height, (x, y) => [(x * 7 + a) & 255, (y * 5 + b) & 255, a, (x + y) % 9 === 0 ? 90 : 255]),
    "image/png",
  );
};

/** What there is to work with at first. */
export const FIRST_ACTS: readonly string[] = ["drop a picture", "add a gradient", "paint", "drop an SVG", "add text"];

const onChosen =
  (key: string): Act["run"] =>
  async (soak) => {
    await soak.chosen();
    await soak.keys(key);
  };

export const SOAK_ACTS: readonly Act[] = [
  { name: "drop a picture", weight: 3, run: async (soak) => soak.editor.drop([picture(soak)], await soak.place()) },
  {
    name: "drop an SVG",
    run: async (soak) => soak.editor.drop([file("disc.svg", SVG, "image/svg+xml")], await soak.place()),
  },
  { name: "add a demo's decal", run: ({ page }) => page.locator("tc-decal-palette [data-decal]").first().click() },
  {
    name: "add text",
    run: async (soak) => {
      await soak.command((editor) => editor.texts.add());
      await soak.page.keyboard.press("Escape");
    },
  },
  {
    name: "drop a font",
    run: async (soak) => {
      await soak.chosen();
      await soak.editor.drop([file("Lobster.ttf", readFileSync(FONT), "font/ttf")], await soak.place());
    },
  },
  { name: "add a fill", run: ({ editor }) => editor.addLayer(/^Fill/) },
  { name: "add a gradient", run: ({ editor }) => editor.addLayer(/^Gradient/) },
  { name: "add a paint layer", run: ({ editor }) => editor.addLayer(/^Paint/) },
  { name: "paint", weight: 4, run: (soak) => soak.useTool("b") },
  { name: "erase", weight: 2, run: (soak) => soak.useTool("e") },
  {
    name: "paint on both sides",
    run: async (soak) => {
      await soak.command((editor) => editor.tools.configure({ hardness: 0.3, flow: 0.6, mirror: "x" }));
      await soak.useTool("b");
      await soak.command((editor) => editor.tools.configure({ mirror: "none" }));
    },
  },
  {
    name: "choose the brush's size and colour",
    run: (soak) =>
      soak.command(
        (editor, [color, share]) => {
          const { least, most } = editor.tools.sizes;
          editor.tools.configure({ color, size: least * (most / least) ** share });
        },
        [color(soak), soak.between(0.2, 0.8)] as const,
      ),
  },
  {
    name: "choose the brush's tip",
    run: async (soak) => {
      const { name, buffer } = picture(soak);
      const tip = soak.random() < 0.75 ? buffer.toString("base64") : null;
      await soak.command(
        async (editor, [name, tip, tinted]) => {
          editor.tools.configure({ tip: null, tinted });
          if (tip === null) return;
          const bytes = Uint8Array.from(atob(tip), (character) => character.charCodeAt(0));
          await editor.tips.useFile(new File([bytes], name));
        },
        [name, tip, soak.random() < 0.5] as const,
      );
    },
  },
  {
    name: "add a mask and paint on it",
    weight: 2,
    run: async (soak) => {
      await soak.chosen();
      await soak.command((editor, hideAll) => editor.layers.addMask(hideAll), soak.random() < 0.4);
      await soak.command((editor) => {
        const { selectedId } = editor.store.state;
        if (selectedId) editor.layers.editMask(selectedId, true);
      });
      await soak.useTool(soak.pick(["b", "e"]));
    },
  },
  {
    name: "invert or remove a mask",
    run: async (soak) => {
      await soak.chosen();
      await soak.command(
        (editor, inverts) => (inverts ? editor.layers.invertMask() : editor.layers.removeMask()),
        soak.random() < 0.7,
      );
    },
  },
  {
    name: "group",
    run: async (soak) => {
      await soak.chosen();
      const other = await soak.layer();
      if (other) await soak.command((editor, id) => editor.layers.toggleSelected(id), other.id);
      await soak.keys("Control+g");
    },
  },
  { name: "ungroup", run: onChosen("Control+Shift+g") },
  { name: "merge", run: onChosen("Control+e") },
  {
    name: "put up or down",
    weight: 2,
    run: async (soak) => {
      await soak.chosen();
      await soak.keys(...Array.from({ length: 1 + soak.whole(3) }, () => soak.pick(["Control+]", "Control+["])));
    },
  },
  {
    name: "duplicate",
    run: async (soak) => {
      if ((await soak.editor.design()).layers.length > 12) return;
      await soak.chosen();
      await soak.keys("Control+d");
    },
  },
  { name: "delete", run: onChosen("Delete") },
  {
    name: "copy and paste",
    run: async (soak) => {
      if ((await soak.editor.design()).layers.length > 12) return;
      await soak.chosen();
      await soak.command(async (editor) => {
        editor.clipboard.copy();
        await editor.clipboard.pasteAgain();
      });
    },
  },
  {
    name: "rename",
    run: async (soak) => {
      const layer = await soak.layer();
      const name = soak.pick(["Логотип", "a", "名前 ✓", "x".repeat(150), '"quoted" \\ <b>']);
      if (layer) await soak.command((editor, [id, name]) => editor.layers.rename(id, name), [layer.id, name] as const);
    },
  },
  {
    name: "hide or show",
    weight: 2,
    run: async (soak) => {
      const layer = await soak.layer();
      if (layer) await soak.command((editor, id) => editor.layers.toggleVisible([id]), layer.id);
    },
  },
  {
    name: "lock one, or unlock what is locked",
    run: async (soak) => {
      const layer = await soak.layer();
      if (!layer) return;
      await soak.command((editor, id) => {
        const locked = editor.session.design.layers.filter(({ locked }) => locked).map(({ id }) => id);
        editor.layers.toggleLocked(locked.length > 0 ? locked : [id]);
      }, layer.id);
    },
  },
  { name: "blend", weight: 2, run: (soak) => soak.change({ blend: soak.pick(BLEND_MODES) }) },
  { name: "blend space", run: (soak) => soak.change({ blendSpace: soak.pick(["srgb", "linear"]) }) },
  { name: "lock alpha", run: (soak) => soak.change({ lockAlpha: soak.random() < 0.5 }) },
  { name: "opacity", run: (soak) => soak.change({ opacity: Math.round(soak.random() * 100) / 100 }) },
  {
    name: "opacity by a digit",
    run: async (soak) => {
      await soak.chosen();
      await soak.keys(String(soak.whole(9)));
    },
  },
  {
    name: "how a picture is thrown",
    weight: 3,
    run: async (soak) => {
      const layer = await soak.chosen();
      if (!layer || !isPlaced(layer)) return;
      const kinds: Projector["kind"][] = ["planar", "perspective", "cylindrical", "uv"];
      await soak.command((editor, kind) => editor.decals.convert(kind), soak.pick(kinds));
    },
  },
  {
    name: "how a picture is read",
    run: async (soak) => {
      const layer = await soak.layer();
      if (!layer || !isPlaced(layer)) return;
      const patch = soak.pick([
        { wrap: soak.pick(["none", "repeat"]) },
        { filter: soak.pick(["linear", "nearest"]) },
        { flipX: soak.random() < 0.5 },
        { flipY: soak.random() < 0.5 },
        { occlusion: soak.pick(["self", "none"]) },
        { backfaces: soak.random() < 0.5 },
        { angleFade: soak.pick([[70, 90] as const, [0, 0] as const, [20, 45] as const, [90, 90] as const]) },
      ]);
      await soak.changeLayer(layer.id, patch);
    },
  },
  {
    name: "drag over the model",
    weight: 4,
    run: async (soak) => {
      await soak.chosen();
      await soak.drag();
    },
  },
  {
    name: "drag a decal",
    weight: 3,
    run: async (soak) => {
      const layer = await soak.chosen();
      if (!layer || !isPlaced(layer) || layer.projector.kind !== "planar") return;
      const point = await soak.page.evaluate((at) => window.texelcast.project(...at), layer.projector.position);
      if (point) await soak.editor.drag(point, await soak.place(), 4);
    },
  },
  {
    name: "nudge, turn and size by keys",
    weight: 3,
    run: async (soak) => {
      await soak.chosen();
      const keys = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "+", "-", "[", "]", "Shift+ArrowUp"];
      await soak.keys(...Array.from({ length: 1 + soak.whole(5) }, () => soak.pick(keys)));
    },
  },
  {
    name: "align by keys",
    run: async (soak) => {
      await soak.chosen();
      await soak.keys(soak.pick(["Alt+s", "Alt+u", "Alt+v", "Alt+m", "Alt+p", "Alt+w"]));
    },
  },
  {
    name: "type into a field",
    run: async (soak) => {
      await soak.chosen();
      const fields = soak.page.locator("tc-layer-properties tc-number input:visible");
      const count = await fields.count();
      if (count === 0) return;
      const field = fields.nth(soak.whole(count - 1));
      if (!(await field.isEnabled()) || (await soak.page.locator("tc-layer-properties .locked").count()) > 0) return;
      await field.fill(soak.pick(["0", "1", "-3", "17", "1e9", "0.001", "abc", "50"]));
      await field.press(soak.pick(["Enter", "Tab", "Escape"]));
    },
  },
  {
    name: "another material",
    weight: 2,
    run: (soak) =>
      soak.command((editor, share) => {
        const usable = (editor.store.state.model?.info.materials ?? []).filter(({ refusal }) => refusal === null);
        const material = usable[Math.floor(share * usable.length)];
        if (material) editor.showMaterial(material.index);
      }, soak.random()),
  },
  {
    name: "a layer on another material",
    run: async (soak) => {
      const layer = await soak.layer();
      if (!layer || layer.type === "group") return;
      await soak.command(
        (editor, [id, share]) => {
          const usable = (editor.store.state.model?.info.materials ?? []).filter(({ refusal }) => refusal === null);
          const material = usable[Math.floor(share * usable.length)]?.index ?? 0;
          if (editor.layers.unlocked([id]).length > 0) editor.layers.change(id, { material }, "Soak");
        },
        [layer.id, soak.random()] as const,
      );
    },
  },
  {
    name: "another texture size",
    run: (soak) =>
      soak.command((editor, settings) => editor.configureTarget(settings), {
        size: soak.pick([null, 256, 512, 1024]),
        gutter: soak.pick([null, null, 0, 5]),
      }),
  },
  {
    name: "undo and redo in bursts",
    weight: 3,
    run: async (soak) => {
      const keys = Array.from({ length: 1 + soak.whole(9) }, () =>
        soak.random() < 0.6 ? "Control+z" : soak.pick(["Control+y", "Control+Shift+z"]),
      );
      await soak.keys(...keys);
    },
  },
  {
    name: "undo while something comes",
    run: async (soak) => {
      const at = await soak.place();
      await Promise.all([soak.editor.drop([picture(soak)], at), soak.page.keyboard.press("Control+z")]);
    },
  },
  {
    name: "have little memory for the history",
    run: (soak) =>
      soak.command((editor, bytes) => editor.session.setHistoryBudget(bytes), soak.pick([5000, 50_000, 2 ** 28])),
  },
  {
    name: "open another model, work and go back meanwhile",
    run: async (soak) => {
      const { buffer } = soak.pick([...Object.values(SOAK_MODELS), halfBareGlb])();
      await soak.command(
        async (editor, [base64, wait, steps]) => {
          const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
          const opened = editor.files.openFiles([{ path: "other.glb", file: new File([bytes], "other.glb") }]);
          await new Promise((resolve) => setTimeout(resolve, wait));
          editor.layers.duplicate();
          await Promise.all([opened, ...steps.map((direction) => editor.files.travel(direction))]);
        },
        [
          buffer.toString("base64"),
          soak.whole(60),
          Array.from({ length: soak.whole(4) }, () => soak.pick(["undo", "undo", "redo"] as const)),
        ] as const,
      );
    },
  },
  { name: "unwrap", run: (soak) => soak.command((editor) => editor.unwrapping?.run()) },
  {
    name: "turn the model",
    run: async (soak) => {
      await soak.keys("Escape");
      await soak.drag();
    },
  },
];
