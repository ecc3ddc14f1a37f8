/** What stands around the curves of a plot: steps of the plan, axes, limits; and where it is. */

import { svg } from "../dom";
import type { Session } from "../player/session";
import type { Extreme } from "./families";
import type { Box } from "./marks";
import { type Scale, shown, ticksOf } from "./scale";

export interface Limit {
  value: number;
  label: string;
}

export interface ChartSpec {
  title: string;
  groups: string[];
  unit: string;
  /** Of a low plot beside others. */
  height?: number;
  /** Positive is drawn downwards. */
  inverted?: boolean;
  /** Only the curve of this name. */
  only?: string;
  limits?: Limit[];
  /** Least span of the vertical axis, so that rounding errors do not look like motion. */
  smallest?: number;
  /** Which of many curves count most. */
  extreme?: Extreme;
  /** Whether the highest point is marked. */
  peak?: boolean;
  /** Whether zero is in sight whatever the values. */
  zero?: boolean;
}

/** Where the curves are drawn [pixels]. */
export interface Area {
  left: number;
  right: number;
  top: number;
  bottom: number;
  inverted: boolean;
  /** Where the numbers of an axis on the right stand. */
  beside: number;
}

const TONNE_FORCE = 9.81; // kN
const LETTER = 6.1; // pixels, mean width of a letter
const LINE = 11; // pixels, height of small letters with room
const BESIDE = 7; // pixels from the plot to the numbers of an axis on the right
const MARGIN = 12; // pixels at the right that a number of the time axis may take

/** `names`: room for names at the ends of the curves; an axis in tonne-force has as much as its numbers need. */
export function areaOf(
  width: number,
  height: number,
  spec: { unit?: string; inverted?: boolean },
  scale: Scale,
  names = 0,
): Area {
  const [top, bottom] = [24, height - 26];
  const numbers = spec.unit === "kN" ? tonnesOf(scale, bottom - top).map(({ text }) => text.length) : [];
  const room = spec.unit === "kN" ? Math.max(44, BESIDE + LETTER * Math.max(...numbers)) : 14;
  const right = width - room - names;
  return { left: 52, right, top, bottom, inverted: spec.inverted ?? false, beside: right + BESIDE + names };
}

export function xOf(area: Area, [begin, end]: readonly [number, number], time: number): number {
  return area.left + ((time - begin) / (end - begin || 1)) * (area.right - area.left);
}

export function yOf(area: Area, scale: Scale, value: number): number {
  const share = (value - scale.low) / (scale.high - scale.low || 1);
  const room = area.bottom - area.top;
  return area.inverted ? area.top + share * room : area.bottom - share * room;
}

/** All of it, to be drawn below the curves. */
export function frameOf(session: Session, spec: ChartSpec, area: Area, scale: Scale): SVGElement[] {
  const kilonewtons = spec.unit === "kN" ? tonnes(area, scale) : [];
  return [
    ...strip(session, area),
    ...vertical(area, scale),
    ...horizontal(session, area),
    ...kilonewtons,
    ...liftOff(session, area),
    ...limits(spec, area, scale),
  ];
}

/** Steps of the plan above the plot. */
function strip(session: Session, area: Area): SVGElement[] {
  const [begin, end] = session.span;
  return session.lift.steps.flatMap((step, index) => {
    const from = xOf(area, session.span, Math.max(step.begin, begin));
    const to = xOf(area, session.span, Math.min(step.end, end));
    if (to - from < 1) return [];
    const box = svg("rect", {
      x: from,
      y: 2,
      width: Math.max(0.5, to - from - 1),
      height: 15,
      class: index % 2 === 0 ? "gl-step" : "gl-step gl-step-odd",
    });
    box.append(svg("title", {}, step.name));
    const place = { x: (from + to) / 2, y: 13, "text-anchor": "middle", class: "gl-step-name" };
    const text = [step.name, `${step.names[0]} + ${step.names.length - 1} more`].find(
      (words, index) => (index === 0 || step.names.length > 1) && LETTER * words.length < to - from - 4,
    );
    return text === undefined ? [box] : [box, svg("text", place, text)];
  });
}

function vertical(area: Area, scale: Scale): SVGElement[] {
  return scale.ticks.flatMap((tick) => {
    const y = yOf(area, scale, tick);
    const line = { x1: area.left, x2: area.right, y1: y, y2: y, class: tick === 0 ? "gl-zero" : "gl-grid" };
    const text = { x: area.left - 7, y: y + 3.5, "text-anchor": "end", class: "gl-tick" };
    return [svg("line", line), svg("text", text, shown(tick, scale.digits))];
  });
}

function horizontal(session: Session, area: Area): SVGElement[] {
  const { left, right, bottom } = area;
  const { ticks, digits } = ticksOf(...session.span, Math.max(3, Math.round((right - left) / 100)));
  const marks = ticks.flatMap((tick, index) => {
    const x = xOf(area, session.span, tick);
    const text = `${shown(tick, digits)}${index === ticks.length - 1 ? " s" : ""}`;
    const isAtEnd = x + (LETTER * text.length) / 2 > right + MARGIN;
    const place = { x: isAtEnd ? right + MARGIN : x, y: bottom + 16 };
    return [
      svg("line", { x1: x, x2: x, y1: bottom, y2: bottom + 4, class: "gl-axis" }),
      svg("text", { ...place, "text-anchor": isAtEnd ? "end" : "middle", class: "gl-tick" }, text),
    ];
  });
  return [...marks, svg("line", { x1: left, x2: right, y1: bottom, y2: bottom, class: "gl-axis" })];
}

/** The same axis in tonne-force, on the right. */
function tonnes(area: Area, scale: Scale): SVGElement[] {
  return tonnesOf(scale, area.bottom - area.top).map(({ force, text }) => {
    const y = yOf(area, scale, force) + 3.5;
    return svg("text", { x: area.beside, y, class: "gl-tick gl-quiet" }, text);
  });
}

/** Numbers of that axis, of a height [pixels], and the forces at which they stand [kN]. */
function tonnesOf(scale: Scale, height: number): { force: number; text: string }[] {
  const wanted = height > 150 ? 5 : 3;
  const { ticks, digits } = ticksOf(scale.low / TONNE_FORCE, scale.high / TONNE_FORCE, wanted);
  return ticks.map((tick, index) => ({
    force: tick * TONNE_FORCE,
    text: `${shown(tick, digits)}${index === ticks.length - 1 ? " t" : ""}`,
  }));
}

/** Where the load lifts off; null where that is out of sight. */
function liftOffAt(session: Session, area: Area): number | null {
  const time = session.lift.header.liftOff;
  const [begin, end] = session.span;
  return time === null || time < begin || time > end ? null : xOf(area, session.span, time);
}

function liftOff(session: Session, area: Area): SVGElement[] {
  const x = liftOffAt(session, area);
  if (x === null) return [];
  return [svg("line", { x1: x, x2: x, y1: area.top - 2, y2: area.bottom, class: "gl-lift-off" })];
}

/**
 * The room of its name, which belongs to no line across the plot: at the top, below the names of limits there, else
 * on the other side of its line or at the bottom, where no curve runs through it.
 */
export function liftOffName(
  session: Session,
  area: Area,
  limits: readonly LimitName[],
  isCrossed: (box: Box) => boolean = () => false,
): LimitName[] {
  const x = liftOffAt(session, area);
  if (x === null) return [];
  const text = "lift-off";
  const wide = LETTER * text.length;
  const [after, before] = [x + 4, x - 4 - wide];
  const isLate = x > area.left + 0.8 * (area.right - area.left);
  const sides = isLate ? [before] : [after, ...(before >= area.left ? [before] : [])];
  let top = area.top + 8;
  const lines = limits.map(({ line }) => line).sort((one, other) => one - other);
  for (const line of lines) if (isThrough(line, top)) top = line + LINE;
  const bottom = area.bottom - 6;
  const isTaken = limits.some(
    ({ line, baseline }) => isThrough(line, bottom) || Math.abs(baseline - bottom) < LINE,
  );
  const places = [top, ...(isTaken ? [] : [bottom])].flatMap((baseline) =>
    sides.map((left) => ({ text, left, right: left + wide, baseline, line: Number.NEGATIVE_INFINITY })),
  );
  const isFree = ({ left, right, baseline }: LimitName) =>
    !isCrossed({ left, right, top: baseline - LINE + 3, bottom: baseline + 2 });
  return [places.find(isFree) ?? places[0]!];
}

/** Where the run has failed, or ended before its plan; to be drawn upon the curves. */
export function unfinished(session: Session, area: Area, limits: readonly LimitName[]): SVGElement[] {
  const { header, end } = session.lift;
  if (!header.unfinished || end > session.span[1]) return [];
  const x = xOf(area, session.span, end);
  // Above the names of limits, which stand at the right too.
  const isTaken = (y: number) => limits.some(({ baseline }) => Math.abs(baseline - y) < LINE);
  let y = area.bottom - 6;
  while (isTaken(y) && y > area.top + LINE) y -= LINE;
  const failed = header.failed ? " gl-failed" : "";
  const place = { x: x - 4, y, "text-anchor": "end", class: `gl-note gl-unfinished-name${failed}` };
  return [
    svg("line", { x1: x, x2: x, y1: 2, y2: area.bottom, class: `gl-unfinished${failed}` }),
    svg("text", place, header.unfinished),
  ];
}

function limits(spec: ChartSpec, area: Area, scale: Scale): SVGElement[] {
  return (spec.limits ?? []).map((limit) => {
    const y = yOf(area, scale, limit.value);
    return svg("line", { x1: area.left, x2: area.right, y1: y, y2: y, class: "gl-limit" });
  });
}

/** The name of a limit, which ends at `right`, with the line that it belongs to [pixels]. */
export interface LimitName {
  text: string;
  left: number;
  right: number;
  baseline: number;
  line: number;
}

/** Where the names of limits stand. */
export function limitNames(spec: ChartSpec, area: Area, scale: Scale): LimitName[] {
  const taken: LimitName[] = [];
  const all = (spec.limits ?? []).map(({ value }) => yOf(area, scale, value));
  for (const [index, { value, label }] of (spec.limits ?? []).entries()) {
    const line = all[index]!;
    const hasRoom = line + LINE < area.bottom;
    const isBelow = line - 4 - LINE < area.top || (hasRoom && area.inverted && value > 0);
    const baseline = unstruck(isBelow ? line + LINE : line - 4, all, area);
    // Names of limits that are near to each other stand side by side.
    const beside = taken.filter((one) => Math.abs(one.baseline - baseline) < LINE).map((one) => one.left);
    const right = Math.min(area.right - 4, ...beside);
    taken.push({ text: label, left: right - LETTER * label.length - 8, right, baseline, line });
  }
  return taken;
}

/** Whether a line strikes out what stands on a baseline. */
function isThrough(line: number, baseline: number): boolean {
  return line > baseline - LINE + 2 && line < baseline + 2;
}

/** A baseline, or one above the lines of limits that would strike out what stands on it. */
function unstruck(wanted: number, lines: readonly number[], area: Area): number {
  let baseline = wanted;
  const through = () => lines.find((line) => isThrough(line, baseline));
  for (let line = through(); line !== undefined; line = through()) baseline = line - 4;
  return baseline - LINE < area.top ? wanted : baseline;
}

/** Lift-off and the limits by name; to be drawn upon the curves. */
export function names(limits: readonly LimitName[], liftOff: readonly LimitName[]): SVGElement[] {
  return [
    ...limits.map(({ text, right, baseline }) =>
      svg("text", { x: right, y: baseline, "text-anchor": "end", class: "gl-limit-name" }, text),
    ),
    ...liftOff.map(({ text, left, baseline }) =>
      svg("text", { x: left, y: baseline, class: "gl-note" }, text),
    ),
  ];
}
