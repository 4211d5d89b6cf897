/** Plays a model's first animation for viewing, and brings it back to rest exactly. */
import { AnimationMixer, LoopRepeat } from "three";
import type { ModelScene } from "./model-scene.ts";

export class ModelAnimation {
  readonly #mixer: AnimationMixer;
  readonly #scene: ModelScene;
  #playing = false;

  constructor(scene: ModelScene) {
    this.#scene = scene;
    this.#mixer = new AnimationMixer(scene.root);
  }

  get exists(): boolean {
    return this.#scene.animations.length > 0;
  }

  get playing(): boolean {
    return this.#playing;
  }

  set playing(value: boolean) {
    const clip = this.#scene.animations[0];
    if (clip === undefined || value === this.#playing) {
      return;
    }
    this.#playing = value;
    if (value) {
      this.#mixer.clipAction(clip).setLoop(LoopRepeat, Number.POSITIVE_INFINITY).reset().play();
    } else {
      // The mixer puts back every value that it found: the nodes' own pose, in which decals are placed.
      this.#mixer.stopAllAction();
      this.#scene.root.updateMatrixWorld(true);
    }
  }

  /** Goes on by `delta` seconds. */
  advance(delta: number): void {
    this.#mixer.update(delta);
  }

  dispose(): void {
    this.#mixer.stopAllAction();
    this.#mixer.uncacheRoot(this.#scene.root);
  }
}
