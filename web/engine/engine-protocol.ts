/** What the engine's client and its worker say to each other. */
import type { TexelcastErrorJson } from "../core/texelcast-error.ts";
import type { CoreSource } from "../core/wasm-module.ts";
import type { Engine, EngineLayer, ExpectedChange, TargetOptions, TargetUpdate } from "./engine-api.ts";
import type { PrintFileOptions } from "./print-report.ts";
import type { SentLayer } from "./sent-layers.ts";

/** Calls that are answered, by name; arguments and results are the interface's own. */
export type CallName =
  | "loadModel"
  | "setAsset"
  | "removeAsset"
  | "setFont"
  | "measureText"
  | "openTarget"
  | "closeTarget"
  | "idle"
  | "viewMap"
  | "uvTriangles"
  | "readTexels"
  | "layerMiniature"
  | "hash"
  | "exportPng"
  | "exportGlb"
  | "exportUsdz"
  | "setZones"
  | "printReport"
  | "printMap"
  | "exportPrint"
  | "stats";

/** Callbacks and signals cannot cross: they become "progress" and "cancel" messages. */
export type CallArguments<Name extends CallName> = Name extends "openTarget"
  ? [TargetOptions]
  : Name extends "exportPrint"
    ? [PrintFileOptions]
    : Parameters<Engine[Name]>;
export type CallResult<Name extends CallName> = Awaited<ReturnType<Engine[Name]>>;

/** One call as data, its name and arguments matching. */
export type Call = {
  readonly [Name in CallName]: { readonly name: Name; readonly args: CallArguments<Name> };
}[CallName];

export type ClientMessage =
  | { readonly type: "start"; readonly wasm?: Exclude<CoreSource, URL>; readonly memoryBudgetMib?: number }
  | { readonly type: "call"; readonly id: number; readonly call: Call }
  | { readonly type: "cancel"; readonly id: number }
  /** Answered by "pong" as soon as the worker's thread is free. */
  | { readonly type: "ping" }
  | { readonly type: "expect"; readonly change: ExpectedChange | null }
  | { readonly type: "layers"; readonly layers: readonly SentLayer[]; readonly revision: number }
  /** What is no list of layers: the host tells what is wrong with it. */
  | { readonly type: "unreadable"; readonly layers: readonly EngineLayer[]; readonly revision: number };

export type WorkerMessage =
  | { readonly type: "result"; readonly id: number; readonly value: unknown }
  | { readonly type: "failure"; readonly id: number; readonly error: TexelcastErrorJson }
  | { readonly type: "progress"; readonly id: number; readonly share: number }
  | { readonly type: "update"; readonly update: TargetUpdate }
  | { readonly type: "error"; readonly error: TexelcastErrorJson }
  | { readonly type: "pong" }
  /** The worker's thread runs; it holds the Web Lock of this name until it ends, whatever ends it. */
  | { readonly type: "alive"; readonly lock: string }
  /** The newest layers have had their turn: the next list may come. */
  | { readonly type: "drawn" };
