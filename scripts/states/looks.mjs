/** How the page is looked at: on which screen, in which colours, in which language. */

/**
 * @typedef {object} Look
 * @property {string} name
 * @property {{ width: number, height: number }} viewport CSS pixels
 * @property {boolean} touch a finger is the pointer
 * @property {"light" | "dark"} scheme
 * @property {string} query of the page's address
 */

const SCREENS = {
  desktop: { viewport: { width: 1440, height: 900 }, touch: false },
  "tablet-upright": { viewport: { width: 820, height: 1180 }, touch: true },
  "tablet-wide": { viewport: { width: 1180, height: 820 }, touch: true },
  phone: { viewport: { width: 390, height: 844 }, touch: true },
};

/**
 * Each screen in both colours in one of the languages, then a desktop and a phone that read from right to left: what a
 * look shows does not depend on how the rest is combined.
 *
 * @type {readonly (readonly [keyof typeof SCREENS, "light" | "dark", "en" | "de" | "rtl"])[]}
 */
const COMBINED = [
  ["desktop", "light", "en"],
  ["desktop", "dark", "de"],
  ["desktop", "light", "rtl"],
  ["tablet-upright", "light", "de"],
  ["tablet-upright", "dark", "en"],
  ["tablet-wide", "light", "en"],
  ["tablet-wide", "dark", "de"],
  ["phone", "light", "en"],
  ["phone", "dark", "de"],
  ["phone", "light", "rtl"],
];

const QUERIES = { en: "lang=en", de: "lang=de", rtl: "lang=en&dir=rtl" };

/** @type {readonly Look[]} */
export const LOOKS = COMBINED.map(([screen, scheme, words]) => ({
  name: `${screen}-${scheme}-${words}`,
  ...SCREENS[screen],
  scheme,
  query: QUERIES[words],
}));
