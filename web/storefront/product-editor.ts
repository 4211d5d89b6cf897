/** The editor of a product page: the element in the page itself, or in an iframe of another origin. Both answer alike. */
import type { ChangeDetail, PrintReport, SnapshotOptions, SnapshotView, SubmitDetail } from "../element/element-api.ts";
import type { Product } from "./api/shop-api.ts";
import { keepFor, keptFor } from "./kept.ts";

export interface ProductEditor {
  /** Ends with `onSubmit`. */
  submit(): Promise<unknown>;
  snapshot(view: SnapshotView, options: SnapshotOptions): Promise<Blob>;
  validate(): Promise<PrintReport>;
}

export interface ProductEditorParts {
  readonly product: Product;
  /** As the editor's `design` property takes it; null for a product as it is. */
  readonly design: object | null;
  /** The editor's name for screen readers. */
  readonly label: string;
  readonly onChange: (detail: ChangeDetail) => void;
  readonly onSubmit: (detail: SubmitDetail) => void;
}

/** Puts the element into the page. Its code begins to load with the call, before the place is asked for. */
export async function placeElement(
  place: Promise<Element>,
  parts: Promise<ProductEditorParts>,
): Promise<ProductEditor> {
  const [{ TexelcastEditor }, { product, design, label, onChange, onSubmit }] = await Promise.all([
    import("../element/define.ts"),
    parts,
  ]);
  const element = new TexelcastEditor();
  // An element of no role has no name.
  element.role = "group";
  element.ariaLabel = label;
  element.addEventListener("change", ({ detail }) => onChange(detail));
  element.addEventListener("submit", (event) => {
    event.preventDefault();
    onSubmit(event.detail);
  });
  Object.assign(element, { ...propertiesOf(product), design });
  (await place).append(element);
  return element;
}

/** Puts the editor's page of another origin there. Rejects with a TexelcastError where that page does not answer. */
export async function placeFrame(
  page: string,
  place: Promise<Element>,
  parts: Promise<ProductEditorParts>,
): Promise<ProductEditor> {
  const { mountTexelcast } = await import("../embed/frame.ts");
  const { product, design, label, onChange, onSubmit } = await parts;
  // Addresses are read from the editor's page, which has the products' files too.
  const frame = await mountTexelcast(await place, { page, title: label, ...propertiesOf(product) });
  frame.addEventListener("change", ({ detail }) => onChange(detail));
  frame.addEventListener("submit", ({ detail }) => onSubmit(detail));
  if (design !== null) await frame.set({ design });
  return frame;
}

const propertiesOf = ({ model, zones, material, camera, poster }: Product) =>
  ({ mode: "shop", loading: "eager", src: model, zones, material, cameraOrbit: camera, poster }) as const;

const KEY = "handprint-editor";

/** Whether this tab wants its editors framed: `?editor=iframe` says so until `?editor=page`. */
export function wantsFrame(parameters: URLSearchParams): boolean {
  const asked = parameters.get("editor");
  if (asked !== null) keepFor("tab", KEY, asked);
  return (asked ?? keptFor("tab", KEY)) === "iframe";
}
