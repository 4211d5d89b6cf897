import { expect, it } from "vitest";
import { fileNameOf } from "../../web/editor/files/download.ts";

it.each([
  ["Mug", "Mug"],
  ["Mug.", "Mug"],
  ["Wait … ...", "Wait …"],
  [" v1.2 ", "v1.2"],
  ["7/8: done?", "7-8- done-"],
  ["...", "texelcast"],
])("a project of the name “%s” is saved in a file of the name “%s”, whose ending has one dot", (name, stem) => {
  expect(fileNameOf(name)).toBe(stem);
});
