/** The licences of the packages whose code or files lie in ours, and of what is compiled into the module, as one text. */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { inRoot } from "../bootstrap/paths.mjs";

/** What a package holds of others, whose licence it names without its text. */
const WITHIN = `Of three's files, the transcoder of KTX2 textures: Basis Universal, Copyright (C) 2019-2024 Binomial LLC. Its glue is changed
so that a policy without eval allows it. Licensed under the Apache License 2.0, which stands below (@jsquash/jpeg).

Of @jsquash/avif's, the decoder's WebAssembly: libavif, Copyright 2019 Joe Drago, with parts that are Copyright (c) 2018-2019, VideoLAN and
dav1d authors, and libaom, Copyright (c) 2016, Alliance for Open Media, under the Alliance for Open Media Patent License 1.0
(https://aomedia.org/license/patent-license/) too. All rights reserved.

Redistribution and use in source and binary forms, with or without modification, are permitted provided that the following conditions
are met:

1. Redistributions of source code must retain the above copyright notice, this list of conditions and the following disclaimer.

2. Redistributions in binary form must reproduce the above copyright notice, this list of conditions and the following disclaimer in
the documentation and/or other materials provided with the distribution.

THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES
(INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES; LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION)
HOWEVER CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE)
ARISING IN ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.`;

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
