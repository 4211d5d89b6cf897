/** Plays a model's animations, stops them anywhere, and brings the model back to rest exactly. */
import { type AnimationAction, type AnimationClip, AnimationMixer, LoopRepeat } from "three";
import type { ModelScene } from "./model-scene.ts";
import type { AnimationState, ClipInfo } from "./viewer-api.ts";

export const RESTING: AnimationState = { clip: null, playing: false, seconds: 0, speed: 1 };
/** How slow and how fast a clip may run, against its own speed. */
const SPEEDS = { least: 0.05, most: 4 } as const;

export class ModelAnimation {
  readonly clips: readonly ClipInfo[];
  readonly #mixer: AnimationMixer;
  readonly #scene: ModelScene;
  readonly #usable: readonly AnimationClip[];
  #action: AnimationAction | null = null;
  #state = RESTING;
  #pose = 0;

  constructor(scene: ModelScene) {
    this.#scene = scene;
    this.#usable = scene.animations.filter((clip) => clip.duration > 0);
    this.clips = this.#usable.map(({ name, duration }, index) => ({ name: name || `${index + 1}`, seconds: duration }));
    this.#mixer = new AnimationMixer(scene.root);
  }

  get state(): AnimationState {
    return this.#state;
  }

  get playing(): boolean {
    return this.#state.playing;
  }

  /** Whether the model stands otherwise than at rest. */
  get posed(): boolean {
    return this.#state.clip !== null;
  }

  /** Another number for every pose. */
  get pose(): number {
    return this.#pose;
  }

  /** What is not given stays. Without a clip the model rests; playing without one plays the first. */
  set(change: Partial<AnimationState>): void {
    const wanted = { ...this.#state, ...change };
    const clip = change.clip === undefined && change.playing === true ? (wanted.clip ?? 0) : wanted.clip;
    const info = clip === null ? undefined : this.clips[clip];
    const source = clip === null ? undefined : this.#usable[clip];
    this.#pose += 1;
    if (clip === null || info === undefined || source === undefined) {
      this.#rest(wanted.speed);
      return;
    }
    if (clip !== this.#state.clip || this.#action === null) {
      this.#mixer.stopAllAction();
      this.#action = this.#mixer.clipAction(source).setLoop(LoopRepeat, Number.POSITIVE_INFINITY).reset().play();
    }
    const seconds = change.clip !== undefined && change.seconds === undefined ? 0 : wanted.seconds;
    this.#state = {
      clip,
      playing: wanted.playing,
      seconds: within(seconds, 0, info.seconds),
      speed: within(wanted.speed, SPEEDS.least, SPEEDS.most),
    };
    this.#show();
  }

  /** Goes on by `delta` seconds of the page's time, round and round. */
  advance(delta: number): void {
    const { clip, playing, seconds, speed } = this.#state;
    const length = clip === null ? undefined : this.clips[clip]?.seconds;
    if (!playing || length === undefined) {
      return;
    }
    this.#state = { ...this.#state, seconds: (seconds + delta * speed) % length };
    this.#pose += 1;
    this.#show();
  }

  dispose(): void {
    this.#mixer.stopAllAction();
    this.#mixer.uncacheRoot(this.#scene.root);
  }

  #show(): void {
    if (this.#action !== null) {
      this.#action.time = this.#state.seconds;
      this.#mixer.update(0);
      this.#scene.root.updateMatrixWorld(true);
    }
  }

  /** The mixer puts back every value that it found: the nodes' own pose, in which the texture is painted. */
  #rest(speed: number): void {
    this.#mixer.stopAllAction();
    this.#action = null;
    this.#scene.root.updateMatrixWorld(true);
    this.#state = { ...RESTING, speed: within(speed, SPEEDS.least, SPEEDS.most) };
  }
}

function within(value: number, least: number, most: number): number {
  return Math.min(most, Math.max(least, Number.isFinite(value) ? value : least));
}
