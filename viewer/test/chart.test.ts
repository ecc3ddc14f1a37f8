import { describe, expect, it } from "vitest";
import { alike, dashes, placesOf } from "../src/chart/alike";
import { apart, familiesOf, firstLargest } from "../src/chart/families";
import { Curve } from "../src/data/curve";

/** A curve from 0 to a height and back to a depth. */
function curve(name: string, family: string, most: number, least = 0): Curve {
  const entry = { group: "g", name, label: name, unit: "kN", first: 0, count: 3, family, peak: null };
  return new Curve(entry, Float64Array.of(0, 1, 2), Uint32Array.of(0, 1, 2), Float32Array.of(0, most, least));
}

const slings = [5, 9, 7, 6, 4].map((most, index) => curve(`a${index}`, "slings of A", most, -most));
const falls = [1, 3, 2, 2, 1].map((most, index) => curve(`b${index}`, "falls", most));

describe("families of curves", () => {
  it("gives each its colour where there are enough", () => {
    const few = familiesOf(slings, "largest");
    expect(new Set(few.map((family) => family.colour)).size).toBe(5);
    expect(few.map((family) => family.members)).toEqual([[0], [1], [2], [3], [4]]);
  });

  it("gives each family one colour and knows which of it counts most", () => {
    const [one, other] = familiesOf([...slings, ...falls], "largest");
    expect([one!.name, other!.name]).toEqual(["slings of A", "falls"]);
    expect(one!.colour).not.toBe(other!.colour);
    expect([one!.extremes, other!.extremes]).toEqual([[1], [6]]);
    expect(familiesOf([...slings, ...falls], "both")[0]!.extremes).toEqual([1]);
    const mixed = [...slings, curve("low", "slings of A", 1, -20), ...falls];
    expect(familiesOf(mixed, "both")[0]!.extremes).toEqual([1, 5]);
    expect(familiesOf(mixed, "smallest")[0]!.extremes).toEqual([5]);
  });

  // Of twins such as the bow lines of `floating_crane`, which differ by 1e-14 of what they carry, the plot named the
  // starboard one and the first page the port one; so with luffing ropes, falls and slings.
  it("names the first of those that are alike but for rounding", () => {
    const twins = [220222.21, 207863.2, 220222.21 * (1 + 1e-13), 220222.21 * (1 + 1e-7)];
    expect(firstLargest([0, 1, 2, 3], (index) => twins[index]!)).toBe(0);
    expect(firstLargest([0, 1], (index) => [500, 500.01][index]!)).toBe(1);
    expect(firstLargest([0, 1], () => Number.NEGATIVE_INFINITY)).toBe(0);
  });

  it("has one colour for curves that nobody has put into families", () => {
    const all = familiesOf(
      Array.from({ length: 9 }, (_, index) => curve(`c${index}`, "", index)),
      "largest",
    );
    expect(all.map((family) => [family.members.length, family.extremes])).toEqual([[9, [8]]]);
  });
});

describe("names beside each other", () => {
  it("stand apart, between their bounds, in the order of what they name", () => {
    expect(apart([50, 10, 51], 12, 0, 100)).toEqual([50, 10, 62]);
    expect(apart([99, 98, 97], 12, 0, 100)).toEqual([100, 88, 76]);
  });
});

describe("curves that lie upon each other", () => {
  const [high, same, low] = [curve("a", "", 100), curve("b", "", 100.5), curve("c", "", 50)] as const;
  const all = new Map([
    [0, high],
    [1, low],
    [2, same],
  ]);
  const asPixels = (value: number) => 2 * value;

  it("are found by what is seen, one pixel apart, not fifty", () => {
    expect(alike(all, [0, 2], asPixels)).toEqual([[0, 2]]);
    expect(alike(all, [0, 2], (value) => 10 * value)).toEqual([]);
  });

  it("are looked at where they are shown", () => {
    const parts = new Map([
      [0, curve("a", "", 100, 0)],
      [1, curve("b", "", 100, 80)],
    ]);
    expect(alike(parts, [0, 2], asPixels)).toEqual([]);
    expect(alike(parts, [0, 1], asPixels)).toEqual([[0, 1]]);
  });

  it("part where one of them has a peak of its own, which dashes would break up", () => {
    const time = Float64Array.from({ length: 101 }, (_, sample) => sample);
    const samples = Uint32Array.from(time);
    const made = (name: string, values: Float32Array) =>
      new Curve({ ...high.entry, name, first: 0, count: 101 }, time, samples, values);
    const flat = new Float32Array(101).fill(100);
    const peaked = Float32Array.from(flat, (value, sample) => (sample === 40 ? 120 : value));
    const bumped = Float32Array.from(flat, (value, sample) => (sample === 40 ? 102 : value));
    const both = (other: Float32Array) =>
      new Map([
        [0, made("a", flat)],
        [1, made("b", other)],
      ]);
    expect(alike(both(peaked), [0, 100], asPixels)).toEqual([]);
    // Where they come apart by no more than their lines are wide, they still look like one.
    expect(alike(both(bumped), [0, 100], asPixels)).toEqual([[0, 1]]);
    expect(alike(both(peaked), [50, 100], asPixels)).toEqual([[0, 1]]);
  });

  it("show all their colours: the first is whole, the others have their places on it", () => {
    const places = placesOf([[4, 5, 7]]);
    expect(dashes(places.get(4)!)).toEqual({});
    expect(dashes(places.get(5)!)).toEqual({ "stroke-dasharray": "12 24", "stroke-dashoffset": -12 });
    expect(dashes(places.get(7)!)).toEqual({ "stroke-dasharray": "12 24", "stroke-dashoffset": -24 });
    expect(places.get(6)).toBe(undefined);
  });
});
