/**
 * An esbuild plugin for pages' scripts. Packages that run in Node too hold branches for it, which no page takes; but a bundler
 * follows their imports all the same, and webpack and Turbopack refuse `node:fs` and `module` where they build for a browser.
 */

const NODE_MODULES = /^(node:.*|fs|path|url|module)$/;

/** @returns {import("esbuild").Plugin} */
export function noNode() {
  return {
    name: "no-node",
    setup(build) {
      build.onResolve({ filter: NODE_MODULES }, () => ({ path: "none", namespace: "no-node", sideEffects: false }));
      build.onLoad({ filter: /./, namespace: "no-node" }, () => ({ contents: "module.exports = {};" }));
    },
  };
}
