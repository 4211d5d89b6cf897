/**
 * Types of `<texelcast-editor>` in Vue's templates: `import type {} from "texelcast/vue"` once in a project. Vue must know that the
 * tag is no component of its own: `compilerOptions.isCustomElement: (tag) => tag === "texelcast-editor"`.
 */
import type { DefineComponent, HTMLAttributes } from "vue";
import type { TexelcastEditorAttributes, TexelcastEditorEventMap, TexelcastEditorProperties } from "./element-api.ts";

type Listeners = {
  [Type in keyof TexelcastEditorEventMap as `on${Capitalize<Type>}`]?: (event: TexelcastEditorEventMap[Type]) => void;
};
type Own = Omit<TexelcastEditorAttributes, keyof TexelcastEditorProperties> & Partial<TexelcastEditorProperties>;

/** What may be written on the element in a template. */
export type TexelcastEditorVue = Omit<HTMLAttributes, keyof Own | keyof Listeners> & Own & Listeners;

declare module "vue" {
  interface GlobalComponents {
    "texelcast-editor": DefineComponent<TexelcastEditorVue>;
  }
}
