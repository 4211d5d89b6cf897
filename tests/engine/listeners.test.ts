/** What listeners of an engine throw, in its own thread and beside a worker. */
import { afterEach, describe, expect, it, onTestFinished, vi } from "vitest";
import type { Engine } from "../../web/engine/engine-api.ts";
import { createEngineClient } from "../../web/engine/engine-client.ts";
import { fill } from "../support/layers.ts";
import { endHosts, startHost } from "../support/painted-plane.ts";
import { ThreadWorker } from "../support/thread-worker.ts";
import { halvesGlb } from "../support/two-halves.ts";

afterEach(endHosts);

const RED = [1, 0, 0, 1] as const;

function startClient(): Engine {
  const engine = createEngineClient({ createWorker: () => new ThreadWorker() as unknown as Worker });
  onTestFinished(() => engine.dispose());
  return engine;
}

/** What nobody handles, from here to the test's end, instead of the runner. */
function unhandled(): unknown[] {
  const runners = process.listeners("unhandledRejection");
  const heard: unknown[] = [];
  process.removeAllListeners("unhandledRejection");
  process.on("unhandledRejection", (reason) => heard.push(reason));
  onTestFinished(() => {
    process.removeAllListeners("unhandledRejection");
    for (const runner of runners) process.on("unhandledRejection", runner);
  });
  return heard;
}

describe.each([
  ["in its own thread", () => startHost()],
  ["of a worker", startClient],
])("a listener that throws, of an engine %s", (_, start) => {
  it("keeps neither the others nor further targets from an update, and is told as what nobody handled", async () => {
    const heard = unhandled();
    const engine = start();
    await engine.loadModel({ name: "halves.glb", bytes: halvesGlb({ materials: 2 }) });
    for (const material of [0, 1]) await engine.openTarget({ material, width: 16, height: 16 });
    await engine.idle();
    const thrown = new Error("not my day");
    const seen: number[] = [];
    engine.onUpdate(() => {
      throw thrown;
    });
    engine.onUpdate(({ material }) => seen.push(material));
    engine.setLayers([fill("a", RED), fill("b", RED, { material: 1 })], 1);
    await engine.idle();
    expect(seen).toEqual([0, 1]);
    expect([...(await engine.readTexels(1, 8, 8, 1, 1))]).toEqual([255, 0, 0, 255]);
    await vi.waitFor(() => expect(heard).toEqual([thrown, thrown]));
  });

  it("keeps no other from an error", async () => {
    const heard = unhandled();
    const engine = start();
    const codes: unknown[] = [];
    engine.onError((error) => {
      throw error;
    });
    engine.onError((error) => codes.push((error as { code?: unknown }).code));
    await engine.loadModel({ name: "halves.glb", bytes: halvesGlb({ materials: 2 }) });
    await engine.openTarget({ material: 0, width: 16, height: 16 });
    engine.setLayers([fill("a", [9, 0, 0, 1])], 1);
    await engine.idle().catch(() => undefined);
    await vi.waitFor(() => expect(heard).toMatchObject([{ code: "bad-argument" }]));
    expect(codes).toEqual(["bad-argument"]);
  });
});
