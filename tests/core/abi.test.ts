import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import * as abi from "../../web/core/abi.ts";
import * as sizes from "../../web/core/sizes.ts";
import type { StructFields, StructLayout } from "../../web/core/struct-layout.ts";

const header = readFileSync(new URL("../../wasm/texelcast.h", import.meta.url), "utf8");
const code = header.replace(/\/\*[\s\S]*?\*\//g, "");

function camelCase(name: string): string {
  return name.replace(/_([a-z0-9])/g, (_, letter: string) => letter.toUpperCase());
}

/** Fields of a struct of the header, in order, as the TypeScript table would write them. */
function structOfHeader(name: string): [string, { type: string; length?: number }][] {
  const body = new RegExp(`typedef struct ${name} \\{([^}]*)\\} ${name};`).exec(code)?.[1] ?? "";
  return [...body.matchAll(/(uint32_t|float) ([^;]+);/g)].flatMap(([, type, names]) =>
    (names ?? "").split(",").map((declarator): [string, { type: string; length?: number }] => {
      const [, field = "", length] = /(\w+)(?:\[(\d+)\])?/.exec(declarator) ?? [];
      const layout = { type: type === "float" ? "f32" : "u32" };
      return [camelCase(field), length === undefined ? layout : { ...layout, length: Number(length) }];
    }),
  );
}

function enumOfHeader(name: string, prefix: string): [string, number][] {
  const body = new RegExp(`typedef enum ${name} \\{([^}]*)\\}`).exec(code)?.[1] ?? "";
  const items = body.split(",").map((item) => item.trim());
  return items
    .map((item, i): [string, number] => [camelCase(item.slice(prefix.length).toLowerCase()), i])
    .filter(([item]) => item !== "count" && !item.endsWith("Count"));
}

describe("the tables of the C ABI", () => {
  it.each([
    ["TxcSessionDef", abi.SessionDefLayout],
    ["TxcSessionStats", abi.SessionStatsLayout],
    ["TxcModelInfo", abi.ModelInfoLayout],
    ["TxcMaterialInfo", abi.MaterialInfoLayout],
    ["TxcMeshDef", abi.MeshDefLayout],
    ["TxcTargetDef", abi.TargetDefLayout],
    ["TxcMapInfo", abi.MapInfoLayout],
    ["TxcLayerDef", abi.LayerDefLayout],
    ["TxcDab", abi.DabLayout],
    ["TxcRect", abi.RectLayout],
    ["TxcUpdate", abi.UpdateLayout],
    ["TxcZone", abi.ZoneLayout],
    ["TxcZoneSurface", abi.ZoneSurfaceLayout],
    ["TxcLayerMetrics", abi.LayerMetricsLayout],
  ] as [string, StructLayout<StructFields>][])("have the fields of %s in the header's order", (name, layout) => {
    expect(Object.entries(layout.fields)).toEqual(structOfHeader(name));
  });

  it("leave out no struct of the header", () => {
    const structs = [...code.matchAll(/typedef struct (\w+) \{/g)].map(([, name]) => name);
    const tables = Object.keys(abi).filter((name) => name.endsWith("Layout"));
    expect(structs).toEqual(tables.map((name) => `Txc${name.slice(0, -"Layout".length)}`).sort(byHeader(structs)));
  });

  it.each([
    ["TxcMapView", "TXC_VIEW_", abi.MapViews],
    ["TxcFilter", "TXC_FILTER_", abi.Filters],
    ["TxcLayerKind", "TXC_LAYER_", abi.LayerKinds],
    ["TxcProjector", "TXC_PROJECTOR_", abi.Projectors],
    ["TxcBlend", "TXC_BLEND_", abi.Blends],
    ["TxcBlendSpace", "TXC_BLEND_SPACE_", abi.BlendSpaces],
    ["TxcWrap", "TXC_WRAP_", abi.Wraps],
    ["TxcOcclusion", "TXC_OCCLUSION_", abi.Occlusions],
    ["TxcTip", "TXC_TIP_", abi.Tips],
    ["TxcZoneKind", "TXC_ZONE_", abi.ZoneKinds],
    ["TxcPrintMap", "TXC_PRINT_MAP_", abi.PrintMaps],
  ] as [string, string, Record<string, number>][])("number %s as the header does", (name, prefix, numbers) => {
    expect(Object.entries(numbers)).toEqual(enumOfHeader(name, prefix));
  });

  it("list every function of the header with its number of arguments", () => {
    const functions = [...code.matchAll(/TXC_API [\w* ]+?(txc_\w+)\(([^)]*)\);/g)].map(([, name, parameters]) => {
      return [name, parameters === "void" ? 0 : (parameters ?? "").split(",").length];
    });
    expect(Object.entries(abi.CORE_FUNCTIONS)).toEqual(functions);
  });

  it("have the header's constants", () => {
    expect(code).toContain(`#define TXC_ABI_VERSION ${abi.ABI_VERSION}u`);
    expect(code).toContain(`#define TXC_MAX_SIZE ${sizes.MAX_SIZE}u`);
    expect(code).toContain(`#define TXC_MAX_TEXTURE_SIZE ${sizes.MAX_TEXTURE_SIZE}u`);
    expect(code).toContain(`#define TXC_NONE 0x${abi.NONE.toString(16)}u`);
  });
});

function byHeader(order: readonly (string | undefined)[]): (a: string, b: string) => number {
  return (a, b) => order.indexOf(a) - order.indexOf(b);
}
