/** Many curves in few colours: one for each family, whose extremes are drawn heavier and named. */

import type { Curve } from "../data/curve";

/** Colours that can be told apart. */
export const COLOURS = 8;
/** Values that differ by less, as a share, are alike: two units in the last place of the numbers that curves have. */
const ROUNDING = 2.4e-7;

/** Which curves of a family count most: those that go highest, lowest, or both. */
export type Extreme = "largest" | "smallest" | "both";

export interface Family {
  /** Empty of curves that stand for themselves. */
  name: string;
  colour: string;
  /** Of its curves, with those that count most first. */
  members: number[];
  extremes: number[];
}

/** Families of curves in the order of their first ones; each curve alone where there are colours for all. */
export function familiesOf(curves: Curve[], extreme: Extreme): Family[] {
  const all = curves.map((_, index) => index);
  if (curves.length <= COLOURS) return all.map((index) => family("", `var(--c${index})`, [index], [index]));
  const names = [...new Set(curves.map((curve) => curve.entry.family))];
  const isTold = names.length <= COLOURS && !names.includes("");
  return (isTold ? names : [""]).map((name, place) => {
    const members = all.filter((index) => !isTold || curves[index]!.entry.family === name);
    const colour = isTold ? `var(--c${place})` : "var(--c-many)";
    return family(name, colour, members, extremesOf(curves, members, extreme));
  });
}

function family(name: string, colour: string, members: number[], extremes: number[]): Family {
  return { name, colour, members, extremes };
}

/** The curve that goes highest, the one that goes lowest, or both, the highest first. */
function extremesOf(curves: Curve[], members: number[], extreme: Extreme): number[] {
  const best = (measure: (curve: Curve) => number) =>
    firstLargest(members, (index) => measure(curves[index]!));
  const highest = best((curve) => curve.top[0]);
  const lowest = best((curve) => -curve.least);
  if (extreme === "largest") return [highest];
  return extreme === "smallest" ? [lowest] : [...new Set([highest, lowest])];
}

/**
 * The item with the largest value: of those alike but for rounding the first, so that checks, tables and curves name
 * the same of two twins.
 */
export function firstLargest<T>(items: readonly T[], measure: (item: T) => number): T {
  const values = items.map(measure);
  const most = values.reduce((one, other) => Math.max(one, other), Number.NEGATIVE_INFINITY);
  const least = most - ROUNDING * Math.max(Math.abs(most), 1);
  return items[
    Math.max(
      0,
      values.findIndex((value) => value >= least),
    )
  ]!;
}

/** Places at least `gap` apart between two bounds, near to what is wanted, in the order of that. */
export function apart(wanted: number[], gap: number, low: number, high: number): number[] {
  const order = wanted.map((_, index) => index).sort((one, other) => wanted[one]! - wanted[other]!);
  const places = [...wanted];
  let least = low;
  for (const index of order) {
    places[index] = Math.max(wanted[index]!, least);
    least = places[index]! + gap;
  }
  let most = high;
  for (const index of order.reverse()) {
    places[index] = Math.min(places[index]!, most);
    most = places[index]! - gap;
  }
  return places;
}
