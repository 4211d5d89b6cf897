/**
 * Types of `<texelcast-editor>` in React 19's JSX: `import type {} from "texelcast/react"` once in a project. React 19 sets properties
 * and listens to events of custom elements itself (`onchange`, `onsubmit`), so there is nothing to wrap.
 */
import type { DetailedHTMLProps, HTMLAttributes } from "react";
import type { TexelcastEditorAttributes, TexelcastEditorEventMap, TexelcastEditorProperties } from "./element-api.ts";
import type { TexelcastEditor } from "./texelcast-editor.ts";

type Listeners = {
  [Type in keyof TexelcastEditorEventMap as `on${Type}`]?: (event: TexelcastEditorEventMap[Type]) => void;
};
type Own = Omit<TexelcastEditorAttributes, keyof TexelcastEditorProperties> &
  Partial<TexelcastEditorProperties> & { class?: string };
type Html = DetailedHTMLProps<HTMLAttributes<TexelcastEditor>, TexelcastEditor>;

/** What may be written on the element in JSX. */
export type TexelcastEditorJsx = Omit<Html, keyof Own | keyof Listeners> & Own & Listeners;

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "texelcast-editor": TexelcastEditorJsx;
    }
  }
}
