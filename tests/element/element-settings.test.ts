import { describe, expect, it } from "vitest";
import { DEFAULTS } from "../../web/element/element-properties.ts";
import { readSettings } from "../../web/element/element-settings.ts";
import { german } from "../../web/element/words/german.ts";
import { english, languageOf } from "../../web/element/words/words.ts";

describe("the element in bare Node", () => {
  it("is imported without a browser", async () => {
    expect(typeof HTMLElement).toBe("undefined");
    const { EDITOR_TAG, TexelcastEditor } = await import("../../web/element/define.ts");
    expect([EDITOR_TAG, typeof TexelcastEditor]).toEqual(["texelcast-editor", "function"]);
    expect(typeof document).toBe("undefined");
  });

  it("gives a server all the names that it gives a page, so that one import serves both", async () => {
    const page = await import("../../web/element/define.ts");
    const server = await import("../../web/package/define-server.ts");
    expect(Object.keys(server).sort()).toEqual(Object.keys(page).sort());
    expect(server.EDITOR_TAG).toBe(page.EDITOR_TAG);
  });
});

describe("the element's settings", () => {
  it("are the defaults where nothing was said", () => {
    const { settings, orbit, faults } = readSettings(DEFAULTS, english);
    expect(settings).toMatchObject({ material: null, size: null, maxDecals: null, readonly: false });
    expect(settings.limits).toEqual({ megapixels: 64, bytes: 20 * 2 ** 20 });
    expect([orbit, faults.size]).toEqual([null, 0]);
  });

  it("hold the default where something wrong was said, and say what", () => {
    const wrong = { ...DEFAULTS, size: Number.NaN, maxDecals: 2.5, maxMegapixels: -1, minCameraOrbit: "30 degrees" };
    const { settings, faults } = readSettings(wrong, english);
    expect(settings).toMatchObject({ size: null, maxDecals: null });
    expect(settings.limits.megapixels).toBe(64);
    expect([...faults.keys()]).toEqual(["size", "maxDecals", "maxMegapixels", "minCameraOrbit"]);
    expect([...faults.values()].map(({ code }) => code)).toEqual(Array(4).fill("bad-argument"));
  });

  it("name a word that is none of the property's, and limits that cross", () => {
    const wrong = { ...DEFAULTS, mode: "ful", loading: "soon", minCameraOrbit: "90deg", maxCameraOrbit: "10deg" };
    const { settings, faults } = readSettings(wrong as typeof DEFAULTS, english);
    expect([...faults].map(([name, { value }]) => [name, value])).toEqual([
      ["mode", "ful"],
      ["loading", "soon"],
      ["minCameraOrbit", "90deg"],
      ["maxCameraOrbit", "90deg"],
    ]);
    expect(settings.camera.min).toEqual(settings.camera.max);
    const lost = readSettings({ ...DEFAULTS, cameraOrbit: "north" }, german).faults.get("cameraOrbit");
    expect(lost?.message).toBe(german.errors.badOption("cameraOrbit"));
    const apart = { ...DEFAULTS, minCameraOrbit: "auto auto 50%", maxCameraOrbit: "auto auto 0.4m" };
    expect(readSettings(apart, english).faults.size).toBe(0);
  });

  it("have one fault for two limits that cross, whichever of them was written last", () => {
    const crossed = { ...DEFAULTS, minCameraOrbit: "90deg auto auto", maxCameraOrbit: "10deg auto auto" };
    const { faults } = readSettings(crossed, english);
    expect(faults.get("maxCameraOrbit")).toBeDefined();
    expect(faults.get("maxCameraOrbit")).toBe(faults.get("minCameraOrbit"));
  });

  it("name a beforeAccept that is no function, and keep it, so that it refuses and does not let all in", () => {
    for (const [beforeAccept, value] of [
      ["yes", "yes"],
      [true, "true"],
      [{}, "object"],
    ]) {
      const { settings, faults } = readSettings({ ...DEFAULTS, beforeAccept } as typeof DEFAULTS, english);
      expect([...faults.values()]).toMatchObject([
        { code: "bad-argument", field: "beforeAccept", value, hint: "function" },
      ]);
      expect(settings.beforeAccept).toBe(beforeAccept);
    }
    for (const beforeAccept of [null, undefined, () => true]) {
      expect(readSettings({ ...DEFAULTS, beforeAccept } as typeof DEFAULTS, english).faults.size).toBe(0);
    }
  });

  it("read orbits as angles and a distance", () => {
    const { orbit, settings } = readSettings(
      { ...DEFAULTS, cameraOrbit: "30deg 1.5rad 40cm", maxCameraOrbit: "auto 90deg 150%" },
      english,
    );
    expect(orbit?.theta).toBe(30);
    expect(orbit?.phi).toBeCloseTo(85.94, 2);
    expect(orbit?.distance).toEqual({ value: 0.4, unit: "m" });
    expect(settings.camera.max).toEqual({ theta: null, phi: 90, distance: { value: 1.5, unit: "share" } });
  });

  it("speak the first language that is spoken here", () => {
    expect(languageOf(["", null, "de-AT", "en"])).toBe("de");
    expect(languageOf(["fr", "EN_us"])).toBe("en");
    expect(languageOf(["fr"])).toBe("en");
  });
});
