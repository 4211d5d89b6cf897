/** A project: a design with the model it is for, under a name. What is kept in the browser, and what a file holds. */
import type { Design } from "../document/index.ts";
import type { ModelRef } from "../state/design-state.ts";
import type { TargetSettings } from "../state/editor-state.ts";

/** A project as the editor has it: every picture is inside the design, as a `data:` URI. */
export interface ProjectContent {
  readonly name: string;
  readonly design: Design;
  readonly model: ModelRef;
  readonly targets: ReadonlyMap<number, TargetSettings>;
}

/** What a list of projects shows. */
export interface ProjectSummary {
  readonly id: string;
  readonly name: string;
  /** Milliseconds since 1970. */
  readonly modified: number;
  /** Of the design, its pictures and the model, bytes. */
  readonly size: number;
  readonly layers: number;
  readonly modelTitle: string;
  /** A small picture as a `data:` URI; null before one was made. */
  readonly thumbnail: string | null;
  /** Counts saves: whoever saves says which one it has seen. */
  readonly revision: number;
}

/** A model without its bytes: a demo, which comes with the page, or the user's own files by their contents' names. */
export type StoredModel =
  | { readonly kind: "demo"; readonly id: string; readonly title: string }
  | {
      readonly kind: "files";
      readonly title: string;
      readonly name: string;
      readonly blob: string;
      readonly resources: readonly { readonly uri: string; readonly blob: string }[];
    };

/** What is read back: a demo's bytes are fetched by whoever opens it. */
export interface LoadedProject {
  readonly summary: ProjectSummary;
  readonly design: Design;
  readonly model: { readonly kind: "demo"; readonly id: string; readonly title: string } | ModelRef;
  readonly targets: ReadonlyMap<number, TargetSettings>;
  /** The newest save could not be read, so this is the one before it. */
  readonly fromBackup: boolean;
}
