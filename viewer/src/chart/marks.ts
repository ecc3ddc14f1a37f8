/** What is written upon curves: where the highest point is, and which curves count most. */

import type { Curve } from "../data/curve";
import { svg } from "../dom";
import { apart, type Family, firstLargest } from "./families";
import type { Area, LimitName } from "./frame";
import { shortenedInside, shown, valueText } from "./scale";

const LINE = 12; // pixels from one name to the next
const LETTER = 6.1; // pixels, mean width of a letter
const ASIDE = 7; // pixels from a point to its name
const STRIDE = 2; // pixels from one look at a curve to the next
const NEAR = 60; // pixels from a point to its name behind another name, at most

/** Where a value at a time is on paper. */
export interface Paper {
  area: Area;
  span: readonly [number, number];
  x(time: number): number;
  y(value: number): number;
}

/** Names of the curves that count most, beside their right ends. */
export function endNames(families: Family[], curves: Curve[], paper: Paper): SVGElement[] {
  const { area, span } = paper;
  const named = families.flatMap(({ colour, extremes }) =>
    extremes.map((index) => ({ colour, curve: curves[index]! })),
  );
  const ends = named.map(({ curve }) => paper.y(curve.lastUpTo(span[1])));
  const places = apart(ends, LINE, area.top + 4, area.bottom);
  return named.flatMap(({ colour, curve }, index) => {
    const [from, to] = [ends[index]!, places[index]!];
    const leader = {
      x1: area.right + 1,
      y1: from,
      x2: area.right + 11,
      y2: to,
      stroke: colour,
      class: "gl-leader",
    };
    const place = { x: area.right + 14, y: to + 3.5, color: colour, class: "gl-end-name" };
    return [svg("line", leader), svg("text", place, shortenedInside(curve.entry.label))];
  });
}

/** Room that they take [pixels]. */
export function roomOf(families: Family[], curves: Curve[]): number {
  const longest = families.flatMap(({ extremes }) =>
    extremes.map((index) => shortenedInside(curves[index]!.entry.label).length),
  );
  return 20 + LETTER * Math.max(...longest);
}

/** A dot on the highest point of all with its curve, value and time, where that is in sight. */
export function peakMark(
  curves: Curve[],
  unit: string,
  paper: Paper,
  limits: readonly LimitName[],
): SVGElement[] {
  if (!curves.length) return [];
  const highest = firstLargest(curves, (curve) => curve.top[0]);
  const [value, time] = highest.top;
  const { area, span } = paper;
  if (!(time >= span[0] && time <= span[1]) || value <= 0) return [];
  const [x, y] = [paper.x(time), paper.y(value)];
  const text = `${shortenedInside(highest.entry.label)} ${valueText(value, unit, value)} at ${shown(time, 2)} s`;
  const isCrossed = (box: Box) => curves.some((curve) => crosses(curve, paper, box));
  const place = { ...peakPlace(x, y, LETTER * text.length, area, limits, isCrossed), class: "gl-peak-name" };
  return [svg("circle", { cx: x, cy: y, r: 3, class: "gl-peak" }), svg("text", place, text)];
}

/** A box on paper [pixels]. */
export interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Whether a curve runs through a box. */
export function crosses(curve: Curve, paper: Paper, box: Box): boolean {
  const { area, span } = paper;
  const seconds = (span[1] - span[0]) / (area.right - area.left);
  let before: number | null = null;
  for (let x = box.left; x <= box.right; x += STRIDE) {
    const time = span[0] + (x - area.left) * seconds;
    const y = curve.isKnownAt(time) ? paper.y(curve.at(time)) : Number.NaN;
    if (Number.isNaN(y)) before = null;
    else {
      if (Math.max(y, before ?? y) > box.top && Math.min(y, before ?? y) < box.bottom) return true;
      before = y;
    }
  }
  return false;
}

/**
 * Where the name of a point begins: on its right, else on its left, else behind another name or as far right as there
 * is room; clear of limits, other names and, where that goes, of the curves.
 */
export function peakPlace(
  x: number,
  y: number,
  wide: number,
  area: Area,
  limits: readonly LimitName[],
  isCrossed: (box: Box) => boolean = () => false,
): { x: number; y: number } {
  const [right, left] = [x + ASIDE, x - ASIDE - wide];
  const behind = limits.map((name) => name.right + 4).filter((from) => from > right && from < x + NEAR);
  const sides = [right, left, ...behind].filter((from) => from >= area.left && from + wide <= area.right);
  if (!sides.length) sides.push(Math.max(area.left + 2, area.right - wide));
  const isFree = (from: number, baseline: number) =>
    baseline >= area.top &&
    limits.every(
      ({ line, baseline: other, ...name }) =>
        (line < baseline - LINE || line > baseline + 3) &&
        (Math.abs(other - baseline) >= LINE || from + wide < name.left || from > name.right),
    );
  const near = limits.map(({ line }) => line - 4).filter((line) => Math.abs(line - y) < 2 * LINE);
  const above = [y - 5, ...near, ...near.map((line) => line - LINE)];
  const below = { x: sides[0]!, y: y + LINE + 5 };
  const places = above.flatMap((baseline) => sides.map((from) => ({ x: from, y: baseline })));
  const free = places.filter((place) => isFree(place.x, place.y));
  const box = (place: { x: number; y: number }): Box => ({
    left: place.x,
    right: place.x + wide,
    top: place.y - LINE + 3,
    bottom: place.y + 2,
  });
  return [...free, below].find((place) => !isCrossed(box(place))) ?? free[0] ?? below;
}
