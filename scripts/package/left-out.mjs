/**
 * An esbuild plugin for pages' scripts: questions that three-mesh-bvh answers and nobody here asks (two trees against each other, a
 * geometry against a tree) stay out of the package. They are methods of the tree's class, which no bundler drops by itself, and
 * would be 2 kB of what a shop's page loads with the first touch.
 */
import { basename } from "node:path";

const FOLDER = /three-mesh-bvh[\\/]src[\\/]core[\\/]cast[\\/]/;

/** The files, each of one function. */
const FUNCTIONS = {
  "bvhcast.js": "bvhcast",
  "closestPointToGeometry.generated.js": "closestPointToGeometry",
  "closestPointToGeometry_indirect.generated.js": "closestPointToGeometry_indirect",
  "intersectsGeometry.generated.js": "intersectsGeometry",
  "intersectsGeometry_indirect.generated.js": "intersectsGeometry_indirect",
};

/** The tree's methods that need them. */
export const LEFT_OUT = ["bvhcast", "closestPointToGeometry", "intersectsGeometry"];

/** @returns {import("esbuild").Plugin} */
export function leftOut() {
  return {
    name: "left-out",
    setup(build) {
      build.onLoad({ filter: FOLDER }, ({ path }) => {
        const name = /** @type {Record<string, string>} */ (FUNCTIONS)[basename(path)];
        return name === undefined ? null : { contents: `export function ${name}() { throw new Error("left out"); }` };
      });
    },
  };
}
