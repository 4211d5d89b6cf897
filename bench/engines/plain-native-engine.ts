/** The paper's plain method (bench/plain) compiled for this machine, in a process of its own that we take turns with. */
import { type ChildProcessWithoutNullStreams, spawn } from "node:child_process";
import { once } from "node:events";
import { mkdir, writeFile } from "node:fs/promises";
import { createInterface, type Interface } from "node:readline";
import { fileURLToPath } from "node:url";
import type { Picture } from "../../web/engine/engine-api.ts";
import { decalFromModel, directionModel } from "../planar-matrix.ts";
import type { BenchMesh } from "../work.ts";
import type { BenchEngine, DragStep, Run } from "./engine.ts";

const FOLDER = fileURLToPath(new URL("../../build/native-bench/", import.meta.url));
const PROGRAM = `${FOLDER}plain_method${process.platform === "win32" ? ".exe" : ""}`;
/** Without folders: the protocol's words are separated by spaces. */
const MESH_FILE = "bench_mesh.bin";
const DECAL_FILE = "bench_decal.bin";

export class PlainNativeEngine implements BenchEngine {
  readonly name = "plain method, native";
  readonly #process: ChildProcessWithoutNullStreams;
  readonly #lines: Interface;
  /** Rejects when the process ends, so that a question to a crashed one does not wait for ever. */
  readonly #ended: Promise<never>;

  constructor() {
    this.#process = spawn(PROGRAM, { cwd: FOLDER });
    this.#process.stderr.pipe(process.stderr);
    this.#lines = createInterface(this.#process.stdout);
    this.#ended = once(this.#process, "close").then(([code]) => {
      throw new Error(`${PROGRAM} ended with exit code ${code}`);
    });
    this.#ended.catch(() => {}); // its end after the last question is no fault
  }

  async load(mesh: BenchMesh, decal: Picture): Promise<void> {
    const counts = Uint32Array.of(mesh.positions.length / 3, mesh.indices.length);
    await mkdir(FOLDER, { recursive: true });
    await writeFile(
      FOLDER + MESH_FILE,
      Buffer.concat([counts, mesh.positions, mesh.normals, mesh.uvs, mesh.indices].map(bytesOf)),
    );
    await writeFile(
      FOLDER + DECAL_FILE,
      Buffer.concat([Uint32Array.of(decal.width, decal.height), decal.rgba].map(bytesOf)),
    );
    await this.#ask(`load ${MESH_FILE} ${DECAL_FILE}`);
  }

  async bake(size: number): Promise<Run> {
    return parseRun(await this.#ask(`bake ${size}`));
  }

  async project({ projector }: DragStep): Promise<Run> {
    return parseRun(
      await this.#ask(`project ${[...decalFromModel(projector), ...directionModel(projector)].join(" ")}`),
    );
  }

  close(): void {
    this.#process.stdin.end();
  }

  async #ask(line: string): Promise<string> {
    this.#process.stdin.write(`${line}\n`);
    const [answer] = await Promise.race([once(this.#lines, "line"), this.#ended]);
    return answer;
  }
}

function parseRun(line: string): Run {
  const [milliseconds, texels] = line.split(" ").map(Number);
  return { milliseconds, texels };
}

function bytesOf(array: Float32Array | Uint32Array | Uint8Array): Uint8Array {
  return new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
}
