/** The licences of the packages whose code or files lie in ours, and of what is compiled into the module, as one text. */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { inRoot } from "../bootstrap/paths.mjs";

/** What a package holds of others, whose licence it names without its text. */
const WITHIN = `Of three's files, the transcoder of KTX2 textures: Basis Universal, Copyright (C) 2019-2024 Binomial LLC. Its glue is changed
so that a policy without eval allows it. Licensed under the Apache License 2.0, which stands below (@jsquash/jpeg).`;

/**
 * @param {Iterable<string>} files that went into the bundles or beside them, absolute
 * @returns {string}
 */
export function licenceText(files) {
  const folders = new Set([...files].map(packageFolder).filter((folder) => folder !== null));
  const parts = [...folders].sort().map((folder) => {
    const { name, version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    const texts = readdirSync(folder)
      .filter((file) => /^(licen[cs]e|copying|ofl|notice)/i.test(file))
      .sort()
      .map((file) => readFileSync(join(folder, file), "utf8").trim());
    return [`${name} ${version} (${license})`, ...texts].join("\n\n");
  });
  const head = "Texelcast holds code and files of these packages, under their own licences.";
  const core = readFileSync(inRoot("wasm/LICENCES.txt"), "utf8").trim();
  return `${[head, core, WITHIN, ...parts].join(`\n\n${"-".repeat(80)}\n\n`)}\n`;
}

/** @param {string} file @returns {string | null} */
function packageFolder(file) {
  if (!file.includes("node_modules")) return null;
  for (let folder = dirname(file); folder !== dirname(folder); folder = dirname(folder)) {
    const manifest = join(folder, "package.json");
    // Some packages have nameless ones in their folders, to say what kind of module lies there.
    if (existsSync(manifest) && JSON.parse(readFileSync(manifest, "utf8")).version) return folder;
  }
  return null;
}
