import { describe, expect, it } from "vitest";
import { areaOf, type ChartSpec, type LimitName, liftOffName, limitNames } from "../src/chart/frame";
import { crosses, type Box as Drawn, type Paper, peakPlace } from "../src/chart/marks";
import { shortenedInside, verticalScale } from "../src/chart/scale";
import { Curve } from "../src/data/curve";
import type { Session } from "../src/player/session";
import { tooClose } from "../src/scene/labels";
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

  // All four began alike, so that each was "sling_between_the_hook_a…", and what it carried was cut off with the rest.
  it("show both ends where they are long", () => {
    expect(shortenedInside("sling_between_the_hook_and_lug_at_frame_117_starboard_side_3")).toBe(
      "sling_betw…ard_side_3",
    );
    expect(shortenedInside("the_main_hook_of_crane")).toHaveLength(21);
    expect(shortenedInside("main_hook_of_crane_21")).toBe("main_hook_of_crane_21");
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

  it("is not on a curve where there is room beside it", () => {
    const at = (left: number, right: number) => (one: { left: number; right: number }) =>
      one.left < right && one.right > left;
    expect(peakPlace(300, 120, 100, area, [], at(310, 600))).toEqual({ x: 193, y: 115 });
    expect(peakPlace(300, 120, 100, area, [], () => true)).toEqual({ x: 307, y: 115 });
    const wide = (one: { top: number }) => one.top < 120;
    expect(peakPlace(300, 120, 100, area, [], wide)).toEqual({ x: 307, y: 137 }); // below, where all above is taken
  });

  it("stands behind the name of lift-off where the curve is on its other side and below", () => {
    const name = { text: "lift-off", left: 304, right: 352, baseline: 117, line: Number.NEGATIVE_INFINITY };
    const curve = (one: Drawn) => one.left < 300 || one.bottom > 120;
    expect(peakPlace(300, 120, 100, area, [name], curve)).toEqual({ x: 356, y: 115 });
    const far = { ...name, right: 400 };
    expect(peakPlace(300, 120, 100, area, [far], curve).x).toBe(193); // it ends too far away
  });

  it("knows which curves run through its box", () => {
    const entry = {
      group: "g",
      name: "a",
      label: "a",
      unit: "kN",
      first: 0,
      count: 3,
      family: "",
      peak: null,
    };
    const line = new Curve(
      entry,
      Float64Array.of(0, 5, 10),
      Uint32Array.of(0, 1, 2),
      Float32Array.of(0, 10, 10),
    );
    const [x, y] = [(time: number) => 52 + 54.8 * time, (value: number) => 234 - 21 * value];
    const paper: Paper = { area, span: [0, 10], x, y };
    expect(crosses(line, paper, { left: 400, right: 500, top: 20, bottom: 30 })).toBe(true);
    expect(crosses(line, paper, { left: 400, right: 500, top: 30, bottom: 40 })).toBe(false);
    expect(crosses(line, paper, { left: 180, right: 200, top: 100, bottom: 115 })).toBe(false);
    expect(crosses(line, paper, { left: 180, right: 200, top: 115, bottom: 190 })).toBe(true);
  });
});

describe("the name of lift-off", () => {
  const area = { left: 52, right: 600, top: 24, bottom: 234, inverted: false, beside: 607 };
  const session = { lift: { header: { liftOff: 4 } }, span: [0, 10] } as unknown as Session;
  const limit = (line: number): LimitName => ({
    text: "limit",
    left: 560,
    right: 596,
    baseline: line + 12,
    line,
  });

  it("stands at the top, below a limit that would strike it out", () => {
    const place = (...lines: number[]) => liftOffName(session, area, lines.map(limit))[0]!.baseline;
    expect(place()).toBe(32);
    expect(place(60)).toBe(32);
    expect(place(26)).toBe(37);
    expect(place(34, 26)).toBe(45);
  });

  it("is not on a curve where there is room before its line or at the bottom", () => {
    const beside = (one: Drawn) => one.right > 272 && one.top < 60; // the line of lift-off is at 271.2
    const before = liftOffName(session, area, [], beside)[0]!;
    expect(before.right).toBeCloseTo(267.2);
    expect(before.baseline).toBe(32);
    const above = (one: Drawn) => one.top < 60;
    expect(liftOffName(session, area, [], above)[0]).toMatchObject({
      left: expect.closeTo(275.2),
      baseline: 228,
    });
    expect(liftOffName(session, area, [limit(225)], above)[0]!.baseline).toBe(32); // a limit is there
    expect(liftOffName(session, area, [], () => true)[0]).toMatchObject({
      left: expect.closeTo(275.2),
      baseline: 32,
    });
  });
});

describe("names of limits", () => {
  const area = { left: 52, right: 600, top: 24, bottom: 234, inverted: false, beside: 607 };
  const named = (values: number[]) =>
    limitNames(
      { limits: values.map((value) => ({ value, label: `at least ${value} m` })) } as ChartSpec,
      area,
      { low: 0, high: 50, ticks: [], digits: 0 },
    );

  it("are not struck out by the line of another", () => {
    const [two, little] = named([2, 0.05]);
    expect(two!.baseline).toBeCloseTo(two!.line - 4);
    expect(little!.baseline).toBeCloseTo(two!.baseline);
    expect(little!.right).toBeLessThanOrEqual(two!.left);
    const [low, high] = named([5, 40]);
    expect(low!.baseline).toBeCloseTo(low!.line - 4);
    expect(high!.baseline).toBeCloseTo(high!.line - 4);
  });
});

// Of 2.998 m to a wall that 3 m are asked of the drawing said "3.00 m < 3 m".
it("a distance that is too small is shown with decimals that say so", () => {
  expect(tooClose(2.5, 3)).toBe("2.50 m < 3 m");
  expect(tooClose(2.998, 3)).toBe("2.998 m < 3 m");
  expect(tooClose(-0.12, 0)).toBe("−0.12 m < 0 m");
});

// Of slings that carry 5 N the numbers in tonne-force, "0.00050 t", ran out of the plot.
it("an axis in tonne-force has room for its numbers", () => {
  const room = (most: number) => {
    const { right, beside } = areaOf(720, 150, { unit: "kN" }, verticalScale(0, most, 3, 1e-9));
    return [720 - right, 720 - beside];
  };
  expect(room(3000)).toEqual([44, 37]);
  expect(room(0.0052)[1]).toBeGreaterThan(6 * "0.00050 t".length);
});
