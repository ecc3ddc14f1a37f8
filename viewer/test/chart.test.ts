import { describe, expect, it } from "vitest";
import { apart, familiesOf } from "../src/chart/families";
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
