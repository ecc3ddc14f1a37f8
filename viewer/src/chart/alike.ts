/** Curves that lie upon each other: dashes upon the first one show the colours of all. */

import type { Curve } from "../data/curve";

const NEAR = 1.5; // pixels, within which a curve hides another
const MOSTLY = 0.95; // share of the samples that are so near
const APART = 6; // pixels, past which a curve is seen by itself: dashes would break up its peak
const DASH = 12; // pixels

/** Where a curve stands among those that it lies upon: 0 is the lowest, which is drawn whole. */
export interface Place {
  place: number;
  of: number;
}

/**
 * Groups of curves that look like one, in the order of their first ones; none of a single curve.
 *
 * @param curves - By their index.
 * @param span - Times that are shown [s].
 * @param y - Where a value is on paper [pixels].
 */
export function alike(
  curves: ReadonlyMap<number, Curve>,
  span: readonly [number, number],
  y: (value: number) => number,
): number[][] {
  const groups: number[][] = [];
  for (const [index, curve] of curves) {
    const group = groups.find(([first]) => hides(curve, curves.get(first!)!, span, y));
    if (group) group.push(index);
    else groups.push([index]);
  }
  return groups.filter((group) => group.length > 1);
}

/** Places of the curves of groups, by their index. */
export function placesOf(groups: number[][]): Map<number, Place> {
  return new Map(
    groups.flatMap((group) => group.map((index, place) => [index, { place, of: group.length }] as const)),
  );
}

/** Attributes of the line of a curve that lies upon others. */
export function dashes({ place, of }: Place): Record<string, string | number> {
  if (place === 0) return {};
  return { "stroke-dasharray": `${DASH} ${(of - 1) * DASH}`, "stroke-dashoffset": -place * DASH };
}

function hides(
  curve: Curve,
  other: Curve,
  [begin, end]: readonly [number, number],
  y: (value: number) => number,
): boolean {
  let [near, count] = [0, 0];
  for (const [one, two] of [
    [curve, other],
    [other, curve],
  ] as const)
    for (let place = one.before(begin); place < one.times.length && one.times[place]! <= end; place++) {
      const time = one.times[place]!;
      if (time < begin || Number.isNaN(one.values[place]!)) continue;
      count += 1;
      if (!two.isKnownAt(time)) continue;
      const off = Math.abs(y(one.values[place]!) - y(two.at(time)));
      if (off > APART) return false;
      if (off <= NEAR) near += 1;
    }
  return count > 0 && near >= MOSTLY * count;
}
