/**
 * The states of the page, in chapters that each begin with a page of its own. A state's name is its file's; what it does
 * builds on the states before it in its chapter. What it returns is done once its picture is taken.
 */

/** @typedef {import("./page-hand.mjs").PageHand} PageHand */
/** @typedef {(hand: PageHand) => Promise<void | (() => Promise<void>)>} State */
/**
 * @typedef {object} Chapter
 * @property {string} name
 * @property {boolean} [firstVisit] the hint is shown
 * @property {(page: import("@playwright/test").Page) => Promise<unknown>} [before] it is opened
 * @property {boolean} [unready] the page does not come to rest by itself
 * @property {readonly (readonly [string, State])[]} states
 */

/** @type {State} */
const asItIs = async () => {};

/** @param {...((hand: PageHand) => Promise<unknown>)} steps @returns {State} */
const inTurn =
  (...steps) =>
  async (hand) => {
    for (const step of steps) await step(hand);
  };

/** @param {string} panel @param {string} selector @returns {State} */
const revealing = (panel, selector) => async (hand) => {
  await hand.panel(/** @type {Parameters<PageHand["panel"]>[0]} */ (panel));
  await hand.reveal(selector);
};

/** @param {string} kind @returns {State} */
const projector = (kind) => async (hand) => {
  await hand.panel("properties");
  await hand.page.locator(`tc-layer-properties #projection input[value=${kind}]`).check({ force: true });
};

/** @param {string} tool @returns {State} */
const tool = (tool) => async (hand) => hand.tool(tool);

/** @param {string} map @returns {State} */
const map = (map) => async (hand) => {
  await hand.panel("texture");
  await hand.click(`tc-texture-panel #tab-${map}`);
};

/** @param {readonly (readonly [number, number])[]} moves @returns {State} */
const midStroke = (moves) => async (hand) => {
  await hand.hold(await hand.middle(), moves);
  return () => hand.page.mouse.up();
};

/** Lays the panel's view open and chooses in it. @param {string} selector @returns {State} */
const viewing = (selector) => async (hand) => {
  const button = hand.page.locator("#view-menu");
  if ((await button.getAttribute("aria-expanded")) !== "true") await button.click();
  await hand.page.locator(`tc-view-settings ${selector}`).click({ force: true });
};

/** @param {string} name of the error that keeping anything ends with @returns {Chapter["before"]} */
const storageFails = (name) => (page) =>
  page.addInitScript((name) => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException("The browser said no.", name);
    };
  }, name);

/** @type {readonly Chapter[]} */
export const CHAPTERS = [
  {
    name: "start",
    firstVisit: true,
    states: [
      ["hint-1", asItIs],
      ["hint-2", (hand) => hand.click("tc-first-hint #next")],
      ["hint-3", (hand) => hand.click("tc-first-hint #next")],
    ],
  },
  {
    name: "loading",
    unready: true,
    // It never arrives.
    before: (page) => page.route("**/mug.glb", () => {}),
    states: [["model", async (hand) => hand.page.waitForTimeout(1500)]],
  },
  {
    name: "empty",
    before: (page) =>
      page.route("**/demo.json", async (route) => {
        const catalogue = await (await route.fetch()).json();
        await route.fulfill({ json: { ...catalogue, models: [] } });
      }),
    states: [["page", asItIs]],
  },
  {
    name: "decal",
    states: [
      ["nothing-selected", (hand) => hand.press("Escape")],
      ["nothing-to-edit", (hand) => hand.panel("properties")],
      ["selected", (hand) => hand.select(0)],
      ["properties", (hand) => hand.panel("properties")],
      ["properties-end", revealing("properties", "tc-layer-properties section:last-of-type")],
      [
        "mid-drag",
        async (hand) => {
          await hand.hold(await hand.middle(), [[30, 12]]);
          return () => hand.page.mouse.up();
        },
      ],
      ["cylindrical", projector("cylindrical")],
      ["perspective", projector("perspective")],
      ["uv", projector("uv")],
    ],
  },
  {
    name: "text",
    states: [
      ["tool", tool("text")],
      [
        "typed",
        async (hand) => {
          const { x, y } = await hand.middle();
          await hand.page.mouse.click(x, y);
          await hand.panel("properties");
          await hand.page.locator("tc-text-fields textarea").fill("Good\nmorning");
          await hand.settle();
        },
      ],
      ["fonts", (hand) => hand.menu("tc-text-fields #font")],
      [
        "bent",
        async (hand) => {
          await hand.press("Escape");
          await hand.page.locator("tc-text-fields #outline").check();
          const curve = hand.page.locator('tc-number[data-field="curve"] input');
          await curve.fill("60");
          await curve.press("Enter");
        },
      ],
    ],
  },
  {
    name: "paint",
    states: [
      ["brush", tool("brush")],
      [
        "brush-stroke",
        midStroke([
          [60, 30],
          [20, 80],
          [-50, 60],
        ]),
      ],
      ["brush-more", (hand) => hand.click("#more-options")],
      ["palette", (hand) => hand.click("#show-palette")],
      [
        "properties",
        inTurn(
          (hand) => hand.press("Escape"),
          (hand) => hand.panel("properties"),
        ),
      ],
      ["eraser", tool("eraser")],
      ["eraser-stroke", midStroke([[70, 70]])],
      ["picker", tool("picker")],
    ],
  },
  {
    name: "layers",
    states: [
      [
        "add-menu",
        inTurn(
          (hand) => hand.panel("layers"),
          (hand) => hand.menu("tc-layer-list .add"),
        ),
      ],
      [
        "gradient",
        async (hand) => {
          await hand.page.locator("tc-layer-list .add [role=menuitem]").nth(2).click();
          await hand.settle();
          await hand.panel("properties");
        },
      ],
      ["radial", (hand) => hand.page.locator("tc-layer-properties input[value=radial]").check({ force: true })],
      [
        "fill-parts",
        async (hand) => {
          await hand.panel("layers");
          await hand.menu("tc-layer-list .add", 1);
          await hand.settle();
          await hand.panel("properties");
          const material = hand.page.locator("tc-layer-properties select#material");
          if (await material.count()) await material.selectOption({ index: 1 });
          await hand.page.locator("tc-layer-properties input[value=charts]").check({ force: true });
          await hand.settle();
          const { x, y } = await hand.middle();
          await hand.page.mouse.click(x, y + 20);
          await hand.settle();
        },
      ],
      [
        "masked",
        async (hand) => {
          await hand.press("v");
          await hand.panel("layers");
          await hand.click("tc-layer-list [data-action=add-mask]");
          await hand.tool("brush");
          await hand.drag(await hand.middle(), [[60, 40]]);
        },
      ],
      [
        "group",
        async (hand) => {
          await hand.press("v");
          for (const decal of ["badge", "flower", "waves"]) await hand.addDecal(decal);
          await hand.press("Control+a");
          await hand.page.locator("tc-layer-list .row").nth(0).click();
          await hand.page
            .locator("tc-layer-list .row")
            .nth(1)
            .click({ modifiers: ["Shift"] });
          await hand.press("Control+g");
        },
      ],
      [
        "several",
        async (hand) => {
          await hand.page.locator("tc-layer-list .row").nth(1).click();
          await hand.page
            .locator("tc-layer-list .row")
            .nth(3)
            .click({ modifiers: ["Shift"] });
        },
      ],
      ["several-properties", (hand) => hand.panel("properties")],
      [
        "more-menu",
        inTurn(
          (hand) => hand.panel("layers"),
          (hand) => hand.menu("tc-layer-list .more"),
        ),
      ],
      [
        "context-menu",
        async (hand) => {
          await hand.press("Escape");
          await hand.page.locator("tc-layer-list .row").nth(1).click({ button: "right" });
        },
      ],
      [
        "locked-hidden",
        async (hand) => {
          await hand.press("Escape");
          await hand.page.locator("tc-layer-list [data-action=locked]").nth(1).dispatchEvent("click");
          await hand.page.locator("tc-layer-list [data-action=visible]").nth(2).click();
        },
      ],
      ["history", (hand) => hand.panel("history")],
    ],
  },
  {
    name: "views",
    states: [
      ["view-menu", (hand) => hand.click("#view-menu")],
      ["unlit", viewing("input[value=unlit]")],
      ["wireframe", viewing("#wireframe")],
      ["backdrop-dark", viewing("input[name=background][value=dark]")],
      [
        "texture",
        inTurn(
          (hand) => hand.press("Escape"),
          (hand) => hand.panel("texture"),
        ),
      ],
      ["positions", map("positions")],
      ["normals", map("normals")],
      ["coverage", map("coverage")],
      ["overlap", map("overlap")],
      ["model-alone", (hand) => hand.press("Alt+1")],
      ["texture-alone", (hand) => hand.press("Alt+3")],
    ],
  },
  {
    name: "skin",
    states: [
      ["template-dialog", (hand) => hand.menu("tc-top-bar .projects", 1)],
      [
        "template",
        async (hand) => {
          await hand.press("Escape");
          await hand.template("block-wide");
        },
      ],
      ["pencil", tool("pencil")],
      [
        "pencil-stroke",
        midStroke([
          [-20, -40],
          [20, -60],
        ]),
      ],
      ["bucket", tool("bucket")],
      ["line", tool("line")],
      ["rectangle", tool("rectangle")],
      ["pixel-palette", (hand) => hand.click("#show-palette")],
      [
        "guide",
        inTurn(
          (hand) => hand.press("Escape"),
          (hand) => hand.panel("texture"),
          (hand) => hand.page.locator("#guide").check(),
        ),
      ],
      ["settings", (hand) => hand.panel("target")],
      ["parts", revealing("target", "tc-parts-list")],
      [
        "part-hidden",
        async (hand) => {
          await hand.page.locator("tc-parts-list .eye").nth(1).click();
          await hand.page.mouse.move(3, 300);
        },
      ],
      [
        "posed",
        async (hand) => {
          await hand.click("tc-stage #play");
          await hand.click("tc-animation-bar #play");
          await hand.page.locator("tc-animation-bar #scrub").fill("70");
        },
      ],
    ],
  },
  {
    name: "page",
    states: [
      ["project-menu", (hand) => hand.menu("tc-top-bar .projects")],
      [
        "model-menu",
        inTurn(
          (hand) => hand.press("Escape"),
          (hand) => hand.menu("tc-top-bar .models"),
        ),
      ],
      [
        "export-menu",
        inTurn(
          (hand) => hand.press("Escape"),
          (hand) => hand.menu("tc-top-bar tc-menu[alignEnd]"),
        ),
      ],
      [
        "help",
        inTurn(
          (hand) => hand.press("Escape"),
          (hand) => hand.press("?"),
        ),
      ],
      [
        "projects",
        async (hand) => {
          await hand.press("Escape");
          await hand.addDecal("badge");
          await hand.page.evaluate(() => window.texelcast.kept());
          await hand.template("avatar");
          await hand.addDecal("flower");
          await hand.page.evaluate(() => window.texelcast.kept());
          await hand.menu("tc-top-bar .projects", 0);
          await hand.page.waitForTimeout(600);
          await hand.click("tc-projects-dialog li:last-child [data-action=duplicate]");
          await hand.settle();
          await hand.click("tc-projects-dialog li:last-child [data-action=delete]");
        },
      ],
    ],
  },
  {
    name: "trouble",
    states: [
      ["broken-model", (hand) => hand.drop("knight.glb", "this is no model")],
      ["unknown-file", (hand) => hand.drop("letter.docx", "Dear Sirs")],
      [
        "engine-restarted",
        async (hand) => {
          await hand.dismissNotices();
          const next = hand.page.waitForEvent("worker");
          void hand.page
            .workers()
            .at(-1)
            ?.evaluate(() => close())
            .catch(() => undefined);
          await next;
          await hand.page.locator("tc-notice-stack section").first().waitFor();
        },
      ],
      [
        "long-work",
        async (hand) => {
          await hand.dismissNotices();
          await hand.panel("target");
          const size = hand.page.locator("tc-target-settings #size");
          await size.selectOption("8192");
          await hand.page.locator("tc-notice-stack .task button").waitFor();
          // It may have ended by then, and is not there to be cancelled.
          return () => size.selectOption({ index: 0 }).then(() => hand.settle());
        },
      ],
      [
        "context-lost",
        async (hand) => {
          await hand.settle();
          await hand.page.evaluate(() => {
            const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector("tc-workbench .tcv-canvas"));
            canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext();
          });
        },
      ],
    ],
  },
  {
    name: "storage-refused",
    before: storageFails("UnknownError"),
    states: [
      [
        "said",
        inTurn(
          (hand) => hand.addDecal("badge"),
          (hand) => hand.page.evaluate(() => window.texelcast.kept()),
        ),
      ],
    ],
  },
  {
    name: "storage-full",
    before: storageFails("QuotaExceededError"),
    states: [
      [
        "said",
        inTurn(
          (hand) => hand.addDecal("badge"),
          (hand) => hand.page.evaluate(() => window.texelcast.kept()),
        ),
      ],
    ],
  },
];
