import { describe, expect, it } from "vitest";
import type { LimitName } from "../src/chart/frame";
import { peakPlace } from "../src/chart/marks";
import { type Box, settle } from "../src/scene/settle";

function box(x: number, y: number, width = 60): Box {
  return { x, y, width, height: 16 };
}

describe("names in the drawing", () => {
  it("stay where they are as long as nothing is there", () => {
    const one = box(100, 100);
    expect(settle(one, [box(161, 100), box(100, 117)], 640, 360)).toBe(true);
    expect(one).toEqual(box(100, 100));
  });

  it("go below what covers them, and below that", () => {
    const one = box(100, 100);
    expect(settle(one, [box(120, 104), box(90, 125, 30)], 640, 360)).toBe(true);
    expect(one).toEqual(box(100, 143));
  });

  it("go above where there is no room below, but not far from what they name", () => {
    const one = box(100, 350);
    expect(settle(one, [box(100, 352)], 640, 360)).toBe(true);
    expect(one.y).toBe(334);
    expect(settle(box(100, 350), [box(100, 352), box(100, 336)], 640, 360)).toBe(false);
  });

  it("are not cut off at the edge, and what is out of sight has none", () => {
    const one = box(630, 2);
    expect(settle(one, [], 640, 360)).toBe(true);
    expect(one).toEqual(box(610, 8));
    expect(settle(box(641, 100), [], 640, 360)).toBe(false);
    expect(settle(box(100, -1), [], 640, 360)).toBe(false);
  });
});

describe("the name of the highest point of a plot", () => {
  const area = { left: 52, right: 600, top: 24, bottom: 234, inverted: false, beside: 607 };
  const limit: LimitName = { text: "rated", left: 500, right: 596, baseline: 46, line: 50 };

  it("stands on its right, else on its left, else within the plot", () => {
    expect(peakPlace(100, 120, 200, area, [])).toEqual({ x: 107, y: 115 });
    expect(peakPlace(500, 120, 200, area, [])).toEqual({ x: 293, y: 115 });
    expect(peakPlace(250, 120, 400, area, []).x).toBe(200);
    expect(peakPlace(250, 120, 700, area, []).x).toBe(54);
  });

  it("is not struck through by a limit, nor on its name", () => {
    expect(peakPlace(100, 52, 200, area, [limit])).toEqual({ x: 107, y: 46 });
    expect(peakPlace(300, 52, 250, area, [limit])).toEqual({ x: 307, y: 34 });
    expect(peakPlace(300, 32, 250, area, [{ ...limit, line: 30, baseline: 26 }]).y).toBe(49); // no room above
  });
});
