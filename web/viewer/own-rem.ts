/**
 * The size of type that lengths go by. A page may set one of its own on its root (`html { font-size: 62.5% }`), with which all
 * that is measured in `rem` would shrink, in shadow trees too. Inside `<texelcast-editor>` a `rem` is therefore the browser's
 * own size of type, as its user has set it; on the editor's own page it stays what it is.
 */
export const REM = "--_texelcast-rem";

/**
 * The styles with their rems in it. Heads of queries stay: no custom property counts there. Those of media go by the browser's own
 * size anyway; those of containers would go by the page's and are written in `em`, the size of type of the container itself.
 */
export function inOwnRem(style: string): string {
  return style.replace(
    /(@[^{}]*\{)|(-?[\d.]+)rem\b/g,
    (_, head: string | undefined, count: string) => head ?? `calc(${count}*var(${REM},1rem))`,
  );
}
