/** Models of ../shared, where a checkout has them beside it. */
import { existsSync, readFileSync } from "node:fs";
import { test } from "@playwright/test";
import type { TestFile } from "./editor-page.ts";
import { file } from "./test-files.ts";

const FOLDER = new URL("../../../../shared/models/", import.meta.url);

export function skipWithoutShared(): void {
  test.skip(!existsSync(FOLDER), "../shared/models is not there");
}

export const sharedFile = (name: string): TestFile => file(name, readFileSync(new URL(name, FOLDER)));
