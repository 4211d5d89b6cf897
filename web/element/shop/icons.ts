/** The few icons of the shop's mode, each by itself: "lucide" as a whole would bring all that the editor shows. */
/// <reference path="../../editor/ui/lucide-icons.d.ts" />
export { default as ImagePlus } from "lucide/dist/esm/icons/image-plus.mjs";
export { default as Maximize } from "lucide/dist/esm/icons/maximize.mjs";
export { default as Redo2 } from "lucide/dist/esm/icons/redo-2.mjs";
export { default as ScanEye } from "lucide/dist/esm/icons/scan-eye.mjs";
export { default as Shapes } from "lucide/dist/esm/icons/shapes.mjs";
export { default as Trash2 } from "lucide/dist/esm/icons/trash.mjs";
export { default as Type } from "lucide/dist/esm/icons/type.mjs";
export { default as Undo2 } from "lucide/dist/esm/icons/undo-2.mjs";
