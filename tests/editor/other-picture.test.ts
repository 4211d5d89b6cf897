import { expect, it } from "vitest";
import { fittedPicture } from "../../web/editor/state/other-picture.ts";
import { FRONT } from "../support/layers.ts";

it("another picture stays within the box of the one before it, and is not drawn out, whatever throws it", () => {
  const box = { ...FRONT, size: [2, 1, 3] } as const;
  expect(fittedPicture(box, 2)).toEqual({ ...box, size: [2, 0.5, 3] });
  expect(fittedPicture(box, 0.5)).toEqual({ ...box, size: [1, 1, 3] });
  const stamp = { kind: "uv", center: [0.5, 0.5], size: [0.2, 0.4], angle: 30 } as const;
  expect(fittedPicture(stamp, 4)).toEqual({ ...stamp, size: [0.2, 0.1] });
  const label = { ...FRONT, kind: "cylindrical", radius: 1, height: 0.4, arc: 90, depth: 0.1 } as const;
  expect(fittedPicture(label, 2)).toMatchObject({ arc: 90, height: 0.2 });
  expect(fittedPicture(label, 0.5)).toMatchObject({ arc: 45, height: 0.4 });
  const view = { ...FRONT, kind: "perspective", fov: 90, aspect: 1, near: 0.1, far: 2 } as const;
  // Half as high in the picture, which is half the tangent and not half the angle.
  expect(fittedPicture(view, 2)).toMatchObject({ aspect: 2, fov: expect.closeTo(53.1301, 4) });
  expect(fittedPicture(view, 0.5)).toMatchObject({ aspect: 0.5, fov: expect.closeTo(90, 9) });
});
