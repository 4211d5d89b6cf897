/**
 * The window that something is seen in. A page may put it into another one than that of the script, whose observers see nothing
 * of it and whose listeners do not hear its keys.
 */
export const windowOf = (element: Element): Window & typeof globalThis => element.ownerDocument.defaultView ?? window;
