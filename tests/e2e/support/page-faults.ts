/** What keeps someone from using the page as it stands now: by axe's rules, and by the size of what is pressed. */
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "@playwright/test";
import type { AxeResults, RunOptions } from "axe-core";

/** Run from outside of the page, whose policy lets no other scripts in. */
const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const RUNS = {
  light: { type: "tag", values: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"] },
  // All that the colours change.
  dark: { type: "rule", values: ["color-contrast"] },
} as const satisfies Record<string, RunOptions["runOnly"]>;

const OUTLINE: RunOptions["runOnly"] = {
  type: "rule",
  values: [
    "heading-order",
    "page-has-heading-one",
    "region",
    "landmark-one-main",
    "landmark-unique",
    "landmark-no-duplicate-main",
    "landmark-no-duplicate-banner",
    "landmark-main-is-top-level",
    "landmark-banner-is-top-level",
    "landmark-complementary-is-top-level",
  ],
};

/** Serious and critical faults of all that is shown, shadow trees included; in dark, those of contrast. */
export async function seriousFaults(page: Page): Promise<string[]> {
  const faults: string[] = [];
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    await drawn(page);
    const found = await violationsOf(page, RUNS[colorScheme]);
    for (const { impact, told } of found) {
      if (impact === "serious" || impact === "critical") faults.push(`${colorScheme}: ${told}`);
    }
  }
  return faults;
}

/** What a screen reader that goes by landmarks and headings would miss, or find twice. */
export async function outlineFaults(page: Page): Promise<string[]> {
  return (await violationsOf(page, OUTLINE)).map(({ told }) => told);
}

async function violationsOf(page: Page, runOnly: RunOptions["runOnly"]): Promise<{ impact: unknown; told: string }[]> {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(`${AXE}; 0`);
  return page.evaluate(async (only) => {
    const { axe } = window as unknown as {
      axe: { run: (place: Document, options: RunOptions) => Promise<AxeResults> };
    };
    const { violations } = await axe.run(document, { runOnly: only, resultTypes: ["violations"], preload: false });
    return violations.flatMap(({ id, impact, nodes }) =>
      nodes.map(({ target, failureSummary }) => ({ impact, told: `${id} ${target}: ${failureSummary}` })),
    );
  }, runOnly);
}

/**
 * Waits until the other scheme's colours have come to rest: a control changes its background over 120 ms, and halfway
 * there its contrast is that of neither scheme. Two frames first, as transitions begin with the first of them.
 */
function drawn(page: Page): Promise<void> {
  return page.evaluate(async () => {
    const transitions = (root: Document | ShadowRoot): Animation[] => [
      ...root.getAnimations().filter((animation) => animation instanceof CSSTransition),
      ...[...root.querySelectorAll("*")].flatMap(({ shadowRoot }) => (shadowRoot ? transitions(shadowRoot) : [])),
    ];
    for (let frame = 0; frame < 2; frame += 1) await new Promise((done) => requestAnimationFrame(done));
    await Promise.allSettled(transitions(document).map(({ finished }) => finished));
  });
}

/**
 * Whatever is pressed and is smaller than `least` pixels either way; for fingers also fields whose type is so small that phones of Apple's
 * zoom the page in on them.
 */
export function smallTargets(page: Page, least: number): Promise<string[]> {
  return page.evaluate((least) => {
    const found = new Set<string>();
    const visit = (root: ParentNode): void => {
      for (const element of root.querySelectorAll<HTMLElement>("*")) {
        if (element.shadowRoot) visit(element.shadowRoot);
        if (!element.matches("button, select, input, textarea, summary, [role=tab], [role=slider]")) continue;
        const { host } = element.getRootNode() as ShadowRoot;
        // A press on its label, or anywhere in a number's field, is a press on the control.
        const field = host?.localName === "tc-number" ? (host as HTMLElement) : element;
        const target = element.closest<HTMLElement>("label") ?? field;
        if (!target.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
        const { width, height } = target.getBoundingClientRect();
        if (width === 0 || height === 0) continue;
        const name = element.getAttribute("aria-label") ?? element.textContent?.trim().slice(0, 30);
        const isTyped = element.matches("select, textarea, input:not([type=checkbox], [type=radio], [type=range])");
        const type = Number.parseFloat(getComputedStyle(element).fontSize);
        if (least >= 44 && isTyped && type < 16) found.add(`${host?.localName} "${name}" has type of ${type}`);
        if (Math.min(width, height) >= least - 0.5) continue;
        found.add(`${host?.localName} ${element.localName} "${name}" is ${width.toFixed(0)} × ${height.toFixed(0)}`);
      }
    };
    visit(document);
    return [...found];
  }, least);
}
