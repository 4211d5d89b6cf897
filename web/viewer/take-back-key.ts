/** Whether a key takes back what the pointer has under way, without a trace: Escape, or the keys of an undo. */
export function takesBack({ key, ctrlKey, metaKey, shiftKey, altKey }: KeyboardEvent): boolean {
  return key === "Escape" || ((ctrlKey || metaKey) && !shiftKey && !altKey && key.toLowerCase() === "z");
}
