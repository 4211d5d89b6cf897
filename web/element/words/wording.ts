/** Words of a shop's own, in any language, in place of the element's: plain JSON. */

/** Words with places in braces for what is told: "Delete {name}". Which places there are stands beside each. */
export type Template = string;

/** By the categories of plurals that a language has (CLDR), at the least "other". */
export type Counted = Template | { readonly [category in Intl.LDMLPluralRule]?: Template };

export interface Told {
  readonly message?: Template;
  /** What to do about it. */
  readonly hint?: Template;
}

/** Each may be left out: the element's own word then stays. */
export interface EditorWording {
  /** Language of the words (BCP 47, "fr"): for screen readers, plurals and the decimal sign. Default: the element's. */
  readonly lang?: string;
  /** What screen readers say of the view. */
  readonly view?: string;
  readonly start?: string;
  readonly loading?: string;
  readonly failed?: string;
  readonly retry?: string;
  readonly close?: string;
  readonly panel?: string;
  readonly addPicture?: string;
  readonly addText?: string;
  /** What a new text says until it is written. */
  readonly sampleText?: string;
  readonly drop?: string;
  readonly emptyTitle?: string;
  readonly emptyBody?: string;
  /** {most} */
  readonly full?: Counted;
  readonly list?: string;
  readonly kinds?: { readonly decal?: string; readonly text?: string; readonly other?: string };
  /** {name} */
  readonly remove?: Template;
  readonly undo?: string;
  readonly redo?: string;
  readonly fit?: string;
  readonly heatMap?: string;
  readonly heatMapOff?: string;
  readonly heatLegend?: { readonly good?: string; readonly least?: string };
  readonly words?: string;
  readonly font?: string;
  readonly color?: string;
  readonly width?: string;
  readonly height?: string;
  readonly turn?: string;
  readonly depth?: string;
  readonly centimetres?: string;
  readonly degrees?: string;
  readonly submit?: string;
  readonly submitting?: string;
  readonly submitted?: string;
  readonly printGood?: string;
  /** {count} */
  readonly printIssues?: Counted;
  /** {value} */
  readonly dpi?: Template;
  /** {value} */
  readonly area?: Template;
  /** To screen readers: {name} in `added`, `removed`, `selected`. */
  readonly announce?: {
    readonly added?: Template;
    readonly removed?: Template;
    readonly undone?: string;
    readonly redone?: string;
    readonly selected?: Template;
  };
  /** What undo takes back. */
  readonly steps?: {
    readonly add?: string;
    readonly addText?: string;
    readonly remove?: string;
    readonly change?: string;
    readonly design?: string;
  };
  readonly errors?: {
    readonly noModel?: string;
    readonly noModelHint?: string;
    /** {address} */
    readonly unreachable?: Template;
    readonly unreachableHint?: string;
    readonly notReady?: string;
    readonly readonly?: string;
    /** {most} */
    readonly tooMany?: Counted;
    readonly tooManyHint?: string;
    /** {name} */
    readonly refused?: Template;
    readonly refusedHint?: string;
    readonly notOpenable?: string;
    readonly emptyText?: string;
    /** {zone}, {material} */
    readonly zoneMaterial?: Template;
    /** {materials} */
    readonly zoneMaterialHint?: Template;
    readonly graphicsLost?: string;
    readonly graphicsLostHint?: string;
    /** {name} */
    readonly badOption?: Template;
    readonly unexpected?: string;
  };
  /** Nothing is where something new was to be put. */
  readonly nowhere?: Told;
  /** What words are drawn with could not be fetched, and nothing was changed. */
  readonly noFont?: Told;
  /** Of `snapshot()`. */
  readonly noGraphics?: Told;
  /** Behind a length, to screen readers, four: to the left, to the right, down, up. */
  readonly ways?: readonly string[];
  /** What the printer would say, by the report's codes: {value}, {limit}, {zone}, {characters}. `grave`: where it must not be printed so. */
  readonly findings?: { readonly [code: string]: Told & { readonly grave?: Told } };
  /** Errors by code, "bad-picture", or by code and reason, "bad-picture/cmyk", which goes first: {name}, {value}. */
  readonly told?: { readonly [code: string]: Told };
}
