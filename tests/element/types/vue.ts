import type { GlobalComponents } from "vue";
import { h } from "vue";
import type { TexelcastEditorVue } from "../../../web/element/vue.ts";

type Props = InstanceType<GlobalComponents["texelcast-editor"]>["$props"];

export const good: TexelcastEditorVue & Props = {
  src: "mug.glb",
  maxDecals: 3,
  "min-camera-orbit": "auto 30deg",
  onSubmit: ({ detail }) => detail.texture.sha256.length,
};
export const node = h("texelcast-editor", good);

// @ts-expect-error There is no such mode.
export const badMode: Props = { mode: "shopp" };
