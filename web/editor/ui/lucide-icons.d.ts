/** Icons by themselves: whoever names one in "lucide" is sent all that anybody names there. */
declare module "lucide/dist/esm/icons/*" {
  const icon: import("lucide").IconNode;
  export default icon;
}
declare module "lucide/dist/esm/createElement.mjs" {
  export { createElement as default } from "lucide";
}
