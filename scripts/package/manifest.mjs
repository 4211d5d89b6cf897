/** What the package offers, and its own package.json: name, version and the like from the checkout's, the rest from its entries. */

/**
 * `server`: another source in Node. `edge`: another where neither Node nor a page runs it.
 * @type {Readonly<Record<string, {source: string, name: string, runs: "page" | "node", server?: string, edge?: string}>>}
 */
export const ENTRIES = {
  // Of Node's own bundle there: what `texelcast/node` throws must be of the class that this one names.
  ".": { source: "web/package/index.ts", name: "index", runs: "page", server: "web/package/index.ts" },
  "./define": {
    source: "web/element/define.ts",
    name: "define",
    runs: "page",
    server: "web/package/define-server.ts",
    edge: "web/package/define-server.ts",
  },
  // Types alone: the tag in React's JSX and in Vue's templates.
  "./react": { source: "web/element/react.ts", name: "react", runs: "page" },
  "./vue": { source: "web/element/vue.ts", name: "vue", runs: "page" },
  "./core": { source: "web/package/core.ts", name: "core", runs: "page" },
  "./three": { source: "web/package/three.ts", name: "three", runs: "page" },
  "./node": { source: "node/package.ts", name: "node", runs: "node", edge: "web/package/node-edge.ts" },
  "./host": { source: "web/package/host.ts", name: "host", runs: "page" },
  "./embed": { source: "web/package/embed.ts", name: "embed", runs: "page" },
};

/** What the runtimes of servers that are no Node call themselves: Vercel's and Next.js's, Cloudflare's. */
export const EDGES = ["edge-light", "workerd"];

/** Both ends are what tests/package runs: `three-oldest` and `three` of the checkout. */
export const THREE_RANGE = ">=0.175.0 <0.188.0";

/** @param {Record<string, any>} checkout the checkout's package.json */
export function manifestOf(checkout) {
  const { name, version, description, keywords, license, author, engines } = checkout;
  const exports = Object.fromEntries(
    Object.entries(ENTRIES).map(([path, { source, name: entry, server, edge }]) => [
      path,
      {
        types: `./types/${source.replace(/\.ts$/, ".d.ts")}`,
        ...(server && { node: `./dist/${entry}-server.js` }),
        ...(edge && Object.fromEntries(EDGES.map((runtime) => [runtime, `./dist/${entry}-edge.js`]))),
        default: `./dist/${entry}.js`,
      },
    ]),
  );
  return {
    name,
    version,
    description,
    keywords,
    license,
    author,
    type: "module",
    engines,
    bin: { texelcast: "dist/cli.js" },
    exports: {
      ...exports,
      "./texelcast.wasm": "./dist/assets/texelcast.wasm",
      "./design.schema.json": "./design.schema.json",
      "./zones.schema.json": "./zones.schema.json",
      "./wording/*.json": "./wording/*.json",
      "./package.json": "./package.json",
    },
    sideEffects: [
      "./dist/define.js",
      "./dist/standalone.js",
      "./dist/cli.js",
      "./dist/*-worker.js",
      // What those of them consist of that only import.
      "./dist/*-shared.js",
    ],
    customElements: "custom-elements.json",
    files: [
      "dist",
      "types",
      "docs",
      "custom-elements.json",
      "*.schema.json",
      "wording",
      "THIRD-PARTY-LICENCES.txt",
      "CHANGELOG.md",
    ],
    peerDependencies: { three: THREE_RANGE },
    peerDependenciesMeta: { three: { optional: true } },
  };
}
