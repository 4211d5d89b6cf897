import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { createEngineHost, type EngineHost } from "../../web/engine/engine-host.ts";
import { writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject, JsonValue } from "../../web/engine/gltf-json.ts";
import { buildModel, cube, type ModelParts, plane } from "../support/model-builder.ts";
import { solidPng } from "../support/png-file.ts";
import { seeded } from "../support/seeded.ts";

/** Any rate of broken files must leave the engine whole, so one engine takes them all. */
const ROUNDS = 1500;

const parts: ModelParts = {
  meshes: [cube(0), plane(1, 1)],
  materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } }, name: "a" }, {}],
  textures: [{ source: 0, sampler: 0 }],
  samplers: [{ magFilter: 9728 }],
  images: [{ bytes: solidPng(4, 4, [1, 2, 3, 255]), mimeType: "image/png" }],
};

/** Loads the bytes and opens what can be opened. Anything but a typed error is thrown on. */
async function survive(engine: EngineHost, bytes: Uint8Array, round: number): Promise<string> {
  try {
    const { materials } = await engine.loadModel({ name: "fuzz.glb", bytes });
    for (const { index } of materials) await engine.openTarget({ material: index, width: 16, height: 16 });
    await engine.exportGlb();
    await engine.exportUsdz();
    return "fine";
  } catch (error) {
    if (!(error instanceof TexelcastError)) throw error;
    if (["engine-crashed", "internal"].includes(error.code)) {
      throw new Error(`round ${round}: ${error.message}`, { cause: error });
    }
    return error.code;
  }
}

describe("a damaged model", () => {
  it("gives a typed error or loads, whichever of its bytes are flipped", async () => {
    const { json, binary } = buildModel(parts);
    const whole = writeGlb(json, binary);
    const engine = createEngineHost();
    const outcomes = new Set<string>();
    const random = seeded(20261120);
    for (let round = 0; round < ROUNDS; round++) {
      const bytes = whole.slice();
      for (let flips = 1 + Math.floor(random() * 3); flips > 0; flips--) {
        const at = Math.floor(random() * bytes.length);
        bytes[at] = (bytes[at] ?? 0) ^ (1 << Math.floor(random() * 8));
      }
      outcomes.add(await survive(engine, bytes, round));
    }
    engine.dispose();
    expect(outcomes).toContain("fine");
    expect(outcomes).toContain("bad-container");
    expect(outcomes.size).toBeGreaterThan(3);
  });

  it("gives a typed error or loads, whichever of its values are replaced", async () => {
    const { json, binary } = buildModel(parts);
    const engine = createEngineHost();
    const outcomes = new Set<string>();
    const random = seeded(8192);
    const strange: JsonValue[] = [
      -1,
      0,
      1,
      3,
      0.5,
      1e9,
      2 ** 31,
      2 ** 32 - 1,
      1e300,
      "x",
      "",
      null,
      true,
      [],
      [[]],
      {},
      [1, 2, 3],
    ];
    for (let round = 0; round < ROUNDS; round++) {
      const copy = structuredClone(json);
      for (let changes = 1 + Math.floor(random() * 2); changes > 0; changes--) {
        replaceSomewhere(copy, random, () => strange[Math.floor(random() * strange.length)]);
      }
      outcomes.add(await survive(engine, writeGlb(copy, binary), round));
    }
    engine.dispose();
    expect(outcomes).toContain("fine");
    expect(outcomes).toContain("bad-container");
    expect(outcomes.size).toBeGreaterThan(3);
  });
});

/** Replaces (or, without a value, removes) one member somewhere in the document. */
function replaceSomewhere(json: JsonObject, random: () => number, pick: () => JsonValue | undefined): void {
  const places: [parent: Record<string, JsonValue | undefined>, key: string][] = [];
  const visit = (value: JsonValue | undefined): void => {
    if (typeof value !== "object" || value === null) return;
    for (const [key, member] of Object.entries(value)) {
      places.push([value as Record<string, JsonValue | undefined>, key]);
      visit(member);
    }
  };
  visit(json);
  const place = places[Math.floor(random() * places.length)];
  if (place === undefined) return;
  const [parent, key] = place;
  if (random() < 0.15 && !Array.isArray(parent)) delete parent[key];
  else parent[key] = structuredClone(pick());
}
