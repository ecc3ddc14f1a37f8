import { deflateSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import { Curve, lastNotAfter } from "../src/data/curve";
import type { Header } from "../src/data/format";
import { catenaryParameter, hang } from "../src/data/hanging";
import { Lift } from "../src/data/lift";
import { inflate, summed, type Unpacked, unpack } from "../src/data/unpack";

describe("packed arrays", () => {
  it("sums changes from their four planes of bytes, negative ones too", () => {
    // Rows [5, -300], [4, 70000]: changes 5, -300, -1, 70300 as int32.
    const changes = new Uint8Array(Int32Array.of(5, -300, -1, 70300).buffer);
    const planes = new Uint8Array(16);
    for (let value = 0; value < 4; value++)
      for (let byte = 0; byte < 4; byte++) planes[4 * byte + value] = changes[4 * value + byte]!;
    expect([...summed(planes, 2, 4)]).toEqual([5, -300, 4, 70000]);
  });

  it("reads what zlib has written", async () => {
    const bytes = Uint8Array.from(deflateSync(Buffer.from([1, 2, 3, 250])));
    expect([...new Uint8Array(await inflate(bytes))]).toEqual([1, 2, 3, 250]);
  });

  it("refuses a format that it does not know", async () => {
    await expect(unpack('{"format": 2}', "")).rejects.toThrow("format 2");
  });
});

describe("a curve", () => {
  const entry = {
    group: "tension",
    name: "a",
    label: "a",
    unit: "kN",
    first: 1,
    count: 3,
    family: "",
    peak: null,
  };
  const time = Float64Array.of(0, 1, 2, 3, 4);
  const curve = new Curve(entry, time, Uint32Array.of(9, 0, 1, 4), Float32Array.of(9, 2, 4, 1));

  it("goes on straight lines between kept samples and stays at its ends", () => {
    expect(curve.at(0.5)).toBe(3);
    expect(curve.at(2.5)).toBe(2.5);
    expect(curve.at(-1)).toBe(2);
    expect(curve.at(9)).toBe(1);
    expect([curve.least, curve.largest]).toEqual([1, 4]);
    expect([curve.isKnownAt(-1), curve.isKnownAt(0), curve.isKnownAt(9)]).toEqual([false, true, false]);
  });

  it("has no value in a gap, which no number begins, and goes on behind it", () => {
    const samples = Uint32Array.of(0, 1, 2, 4);
    const values = Float32Array.of(2, 4, Number.NaN, 1);
    const broken = new Curve({ ...entry, first: 0, count: 4 }, time, samples, values);
    const known = [0.5, 1, 1.5, 2, 3.9, 4].map((when) => broken.isKnownAt(when));
    expect(known).toEqual([true, true, false, false, false, true]);
    expect([broken.at(0.5), broken.at(1), broken.at(4)]).toEqual([3, 4, 1]);
    expect([broken.lastUpTo(0.5), broken.lastUpTo(3), broken.lastUpTo(4)]).toEqual([3, 4, 1]);
    expect([broken.least, broken.largest]).toEqual([1, 4]);
  });

  it("is highest where all steps say so, else where its samples do", () => {
    expect(curve.top).toEqual([4, 1]);
    const finer = { ...entry, peak: [4.5, 0.7] as [number, number] };
    expect(new Curve(finer, time, Uint32Array.of(9, 0, 1, 4), Float32Array.of(9, 2, 4, 1)).top).toEqual([
      4.5, 0.7,
    ]);
  });

  it("finds the last number that is not above a bound", () => {
    expect(lastNotAfter([0, 1, 1, 2], 1)).toBe(2);
    expect(lastNotAfter([0, 1, 2], -5)).toBe(0);
    expect(lastNotAfter([0, 1, 2], 5)).toBe(2);
  });
});

function lengthOf(points: Float64Array): number {
  let length = 0;
  for (let at = 0; at + 5 < points.length; at += 3)
    length += Math.hypot(
      points[at + 3]! - points[at]!,
      points[at + 4]! - points[at + 1]!,
      points[at + 5]! - points[at + 2]!,
    );
  return length;
}

describe("a hanging rope", () => {
  it("solves sinh(u)/u = sqrt(s² − v²)/h for little and much slack", () => {
    for (const [h, v, s] of [
      [10, 0, 10.01],
      [10, 3, 12],
      [2, -20, 26],
      [1, 1, 80],
    ] as const) {
      const u = catenaryParameter(h, v, s);
      expect(Math.sinh(u) / u).toBeCloseTo(Math.sqrt(s * s - v * v) / h, 9);
    }
  });

  it("keeps its length and its ends", () => {
    const out = new Float64Array(3 * 2001);
    hang(out, 0, [1, 2, 3], [5, 5, 6], 9, 2000, -100);
    expect([...out.subarray(0, 3)]).toEqual([1, 2, 3]);
    expect([...out.subarray(6000)].map((part) => Number(part.toFixed(9)))).toEqual([5, 5, 6]);
    // 2000 straight pieces of a smooth curve: short by the square of a piece's share, far below 1e-5.
    expect(lengthOf(out)).toBeCloseTo(9, 5);
  });

  it("lies down where it would hang through what it is made fast to", () => {
    const out = new Float64Array(3 * 51);
    hang(out, 0, [0, 0, 10], [3, 0, 0], 16, 50, 0);
    let lowest = 99;
    for (let at = 2; at < out.length; at += 3) lowest = Math.min(lowest, out[at]!);
    expect(lowest).toBe(0);
  });

  it("is straight where it is no longer than its way", () => {
    const out = new Float64Array(9);
    hang(out, 0, [0, 0, 0], [4, 0, 2], 1, 2, -9);
    expect([...out]).toEqual([0, 0, 0, 2, 0, 1, 4, 0, 2]);
  });
});

function smallLift(tension: number[]): Lift {
  return new Lift(smallUnpacked(tension));
}

function smallUnpacked(tension: number[]): Unpacked {
  const plain = {
    group: "tension",
    name: "r",
    label: "r",
    unit: "kN",
    first: 0,
    count: 2,
    family: "",
    peak: null,
  };
  const rope = { name: "r", label: "r", kind: "sling", first: 0, count: 2, diameter: 0, length: 5 };
  const header = {
    format: 1,
    title: "",
    samples: 2,
    liftOff: null,
    bodies: [{ name: "b", kind: "load", shape: null, cog: [0, 0, 0] }],
    sheaves: [],
    ropes: [{ ...rope, used: null, peak: 1000, peakTime: 1 }],
    lugs: [],
    contacts: [],
    hinges: [],
    ground: null,
    holes: [],
    water: null,
    riseTime: null,
    pairs: [{ name: "b - wall", smallest: 1 }],
    structures: [],
    events: [],
    steps: [
      { names: ["hoist"], begin: 0, end: 1 },
      { names: ["hold"], begin: 1, end: 2 },
    ],
    unfinished: null,
    failed: false,
    strokes: {},
    curves: [plain, { ...plain, group: "clearance", name: "b - wall", unit: "m", first: 2 }],
    arrays: {
      path: { type: "steps", shape: [2, 2, 3], step: 0.5, at: 0 },
      position: { type: "steps", shape: [2, 1, 3], step: 1, at: 0 },
      turn: { type: "steps", shape: [2, 1, 4], step: 1, at: 0 },
      clearance_point: { type: "steps", shape: [2, 1, 2, 3], step: 0.25, at: 0 },
    },
  } as unknown as Header;
  const arrays = new Map<string, Float64Array | Float32Array | Uint32Array | Int32Array>([
    ["time", Float64Array.of(0, 2)],
    ["frames", Uint32Array.of(0, 1)],
    ["curve_sample", Uint32Array.of(0, 1, 0, 1)],
    ["curve_value", Float32Array.from([...tension, 2, 0.5])],
    ["clearance_point", Int32Array.of(0, 0, 0, 8, 0, 0, 0, 0, 4, 2, 0, 4)],
    ["path", Int32Array.of(0, 0, 8, 6, 0, 8, 0, 0, 8, 8, 0, 8)],
    ["position", Int32Array.of(0, 0, 0, 2, 0, 4)],
    ["turn", Int32Array.of(1, 0, 0, 0, 0, 0, 0, 1)],
  ]);
  return { header, arrays };
}

describe("a lift", () => {
  it("stands between frames on straight lines, with unit quaternions", () => {
    const lift = smallLift([1, 1]);
    lift.seek(1);
    expect([...lift.poses.subarray(0, 3)]).toEqual([1, 0, 2]);
    expect(Math.hypot(...lift.poses.subarray(3, 7))).toBeCloseTo(1, 12);
    expect([...lift.drawnPath(0)]).toEqual([0, 0, 4, 3.5, 0, 4]);
  });

  it("turns the short way between an attitude and its opposite quaternion", () => {
    const unpacked = smallUnpacked([1, 1]);
    unpacked.arrays.set("turn", Int32Array.of(0, 5, 0, 0, -3, -4, 0, 0));
    const lift = new Lift(unpacked);
    lift.seek(1);
    const size = Math.hypot(3, 9);
    for (const [part, value] of [3 / size, 9 / size, 0, 0].entries())
      expect(lift.poses[3 + part]).toBeCloseTo(value, 12);
  });

  it("draws a slack rope hanging, a taut one as it was recorded", () => {
    const slack = smallLift([0, 0]);
    const path = slack.drawnPath(0);
    expect(path.length).toBeGreaterThan(6);
    expect([...path.subarray(0, 3)]).toEqual([0, 0, 4]);
    expect([...path.subarray(path.length - 3)]).toEqual([3, 0, 4]);
    expect(smallLift([1, 1]).drawnPath(0).length).toBe(6);
  });

  it("draws nothing of a rope that is cut, whose path is one point", () => {
    const unpacked = smallUnpacked([0, 0]);
    unpacked.arrays.set("path", Int32Array.of(0, 0, 8, 0, 0, 8, 0, 0, 8, 0, 0, 8));
    // 5 m of it that hung in 0 m: places that were no numbers, and an error in the console of the browser.
    expect([...new Lift(unpacked).drawnPath(0)]).toEqual([0, 0, 4, 0, 0, 4]);
  });

  it("knows where watched pairs are nearest, and whether they are too close", () => {
    const lift = smallLift([1, 1]);
    lift.seek(1);
    expect([...lift.nearest]).toEqual([0, 0, 0.5, 1.25, 0, 0.5]);
    expect(lift.lineOf(0)).toBe(1.25);
    expect(lift.distance(0)).toBe(lift.group("clearance")[0]!.at(1)); // that to a rope is less than to its middle
    expect(lift.isTooClose(0)).toBe(false);
    lift.seek(2);
    expect(lift.isTooClose(0)).toBe(true);
    lift.header.pairs[0]!.span = [0, 1];
    expect(lift.isTooClose(0)).toBe(false);
  });

  it("goes on with what is recorded later, whatever its steps", () => {
    const lift = smallLift([1, 1]);
    const more = smallUnpacked([3, 5]);
    more.arrays.set("time", Float64Array.of(3, 4));
    more.header.arrays.position!.step = 10;
    more.header.samples = 4;
    more.header.ropes[0]!.peak = 5000;
    more.header.steps = [
      { names: ["hoist"], begin: 0, end: 1 },
      { names: ["hold"], begin: 1, end: 3.5 },
      { names: ["lower", "traverse"], begin: 3.5, end: 4 },
    ];
    lift.append(more);
    expect([lift.begin, lift.end, lift.header.samples, lift.largestTension]).toEqual([0, 4, 4, 5000]);
    lift.seek(2.5); // halfway from where it was to where the second part begins
    expect(lift.poses[0]).toBe(1);
    expect(lift.tensions[0]).toBe(2000);
    lift.seek(4);
    expect([...lift.poses.subarray(0, 3)]).toEqual([20, 0, 40]);
    expect(lift.group("tension")[0]!.largest).toBe(5);
    expect(lift.steps.map((step) => [step.name, step.end])).toEqual([
      ["hoist", 1],
      ["hold", 3.5],
      ["lower + traverse", 4],
    ]);
  });

  it("knows the steps of its plan", () => {
    expect(smallLift([1, 1]).steps).toEqual([
      { name: "hoist", names: ["hoist"], begin: 0, end: 1 },
      { name: "hold", names: ["hold"], begin: 1, end: 2 },
    ]);
  });

  // At the end of a lift, where a page of one that runs always is, nothing was said to be under way.
  it("knows which is under way, at the last moment too, and none after the plan", () => {
    const lift = smallLift([1, 1]);
    expect(lift.end).toBe(2);
    const at = (time: number) => lift.stepAt(time)?.name;
    expect([at(0), at(1), at(2)]).toEqual(["hoist", "hold", "hold"]);
    lift.steps.pop(); // a plan that is over before the run
    expect([at(1), at(2)]).toEqual([undefined, undefined]);
  });
});
