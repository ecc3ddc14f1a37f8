/** A recorded lift: where everything is at a time, what every rope carries, what happens when. */

import { Curve, joined, lastNotAfter } from "./curve";
import type { Header, Rope, StepEntry } from "./format";
import { hang } from "./hanging";
import type { Numbers, Unpacked } from "./unpack";

/** A time in which a step went, or several side by side under one name. */
export interface Step extends StepEntry {
  name: string;
}

/** Straight pieces in which a slack span is drawn. */
export const HANGING_PIECES = 14;
/** Spans of a slack rope that hang are at least this share of its longest one. */
const HANGING_FROM = 0.3;

export class Lift {
  readonly header: Header;
  readonly curves: Curve[];
  steps: Step[];
  readonly begin: number;
  end: number;
  /** The present time [s]. */
  now = 0;
  /** Times of the frames [s]. */
  frameTimes: Float64Array;
  /** Pose of each body at the present time: x y z, then w x y z. */
  readonly poses: Float64Array;
  readonly sheaveAngles: Float64Array;
  readonly contactForces: Float64Array;
  /** Where each watched pair is nearest at the present time: a point of each side [m]. */
  readonly nearest: Float64Array;
  /** All points of the recorded paths at the present time [m]. */
  readonly path: Float64Array;
  readonly tensions: Float64Array;
  /** The part of `path` of each rope. */
  private readonly recorded: Float64Array[];
  private readonly arrays: Map<string, Numbers>;
  private readonly tensionCurves: Curve[];
  private readonly clearanceCurves: Curve[];
  private readonly chord = new Float64Array(4096);
  private readonly places: Float64Array;
  private readonly turns: Float64Array;

  constructor({ header, arrays }: Unpacked) {
    this.header = header;
    this.arrays = arrays;
    const time = arrays.get("time") as Float64Array;
    this.begin = time[0] ?? 0;
    this.end = time[time.length - 1] ?? 0;
    this.frameTimes = Float64Array.from(arrays.get("frames") as Uint32Array, (sample) => time[sample]!);
    this.curves = header.curves.map((entry) => new Curve(entry, time, ...kept(arrays)));
    this.steps = stepsOf(header);
    const byName = new Map(this.group("tension").map((curve) => [curve.entry.name, curve]));
    this.tensionCurves = header.ropes.map((rope) => byName.get(rope.name)!);
    const distances = new Map(this.group("clearance").map((curve) => [curve.entry.name, curve]));
    this.clearanceCurves = header.pairs.map((pair) => distances.get(pair.name)!);
    this.poses = new Float64Array(7 * header.bodies.length);
    this.places = new Float64Array(3 * header.bodies.length);
    this.turns = new Float64Array(4 * header.bodies.length);
    this.sheaveAngles = new Float64Array(header.sheaves.length);
    this.contactForces = new Float64Array(header.contacts.length);
    this.nearest = new Float64Array(6 * header.pairs.length);
    this.path = new Float64Array(3 * (header.arrays.path?.shape[1] ?? 0));
    this.recorded = header.ropes.map(({ first, count }) =>
      this.path.subarray(3 * first, 3 * (first + count)),
    );
    this.tensions = new Float64Array(header.ropes.length);
    this.seek(this.begin);
  }

  /** Go on with what was recorded later, of the same lift. */
  append({ header, arrays }: Unpacked): void {
    const time = arrays.get("time") as Float64Array;
    const frames = Float64Array.from(arrays.get("frames") as Uint32Array, (sample) => time[sample]!);
    this.frameTimes = joined(Float64Array, this.frameTimes, frames);
    this.end = time[time.length - 1] ?? this.end;
    for (const [name, about] of Object.entries(this.header.arrays)) {
      const more = arrays.get(name);
      // Shapes of bodies, which do not change, come again.
      if (!more || !MOVING.includes(name)) continue;
      const step = about.step ?? 1;
      const scale = (header.arrays[name]!.step ?? 1) / step;
      const scaled = scale === 1 ? more : Float64Array.from(more, (value) => scale * value);
      this.arrays.set(name, joined(Float64Array, this.arrays.get(name)!, scaled));
    }
    this.curves.forEach((curve, place) => {
      curve.append(header.curves[place]!, time, ...kept(arrays));
    });
    const { samples, liftOff, events, steps, unfinished, failed } = header;
    Object.assign(this.header, { samples, liftOff, events, steps, unfinished, failed });
    for (const list of ["ropes", "structures", "hinges"] as const)
      this.header[list].forEach((one, place) => {
        Object.assign(one, header[list][place]);
      });
    this.steps = stepsOf(this.header);
  }

  /** Curves of a plot. */
  group(name: string): Curve[] {
    return this.curves.filter((curve) => curve.entry.group === name);
  }

  /** The step of the plan that is under way at a time [s]; at the last moment of all the one that goes up to it. */
  stepAt(time: number): Step | undefined {
    const isOn = (one: Step) => time < one.end || (time === this.end && time === one.end);
    return this.steps.find((one) => time >= one.begin && isOn(one));
  }

  /** Whether a body is the pin of a hinge, and one that holds at the present time. */
  pinOf(body: number): "none" | "shut" | "open" {
    const hinge = this.header.hinges.find((one) => one.body === body);
    if (!hinge) return "none";
    return hinge.openedAt === null || this.now < hinge.openedAt ? "shut" : "open";
  }

  array(name: string): Numbers | undefined {
    return this.arrays.get(name);
  }

  /** Largest tension of any rope [N]. */
  get largestTension(): number {
    return this.header.ropes.reduce((most, rope) => Math.max(most, rope.peak), 0);
  }

  /** Put everything where it is at a time: between frames on straight lines. */
  seek(time: number): void {
    this.now = time;
    const frame = lastNotAfter(this.frameTimes, time);
    const next = Math.min(frame + 1, this.frameTimes.length - 1);
    const from = this.frameTimes[frame] ?? 0;
    const span = (this.frameTimes[next] ?? 0) - from;
    const share = span > 0 ? Math.min(1, Math.max(0, (time - from) / span)) : 0;
    this.between("path", frame, next, share, this.path);
    this.between("sheave_angle", frame, next, share, this.sheaveAngles);
    this.between("contact_force", frame, next, share, this.contactForces);
    this.between("clearance_point", frame, next, share, this.nearest);
    const { places, turns, poses } = this;
    this.between("position", frame, next, share, places);
    this.turned(frame, next, share);
    for (let body = 0; body < this.header.bodies.length; body++) {
      const [from3, from4, to] = [3 * body, 4 * body, 7 * body];
      const size = Math.hypot(turns[from4]!, turns[from4 + 1]!, turns[from4 + 2]!, turns[from4 + 3]!) || 1;
      for (let part = 0; part < 3; part++) poses[to + part] = places[from3 + part]!;
      for (let part = 0; part < 4; part++) poses[to + 3 + part] = turns[from4 + part]! / size;
    }
    for (let rope = 0; rope < this.tensions.length; rope++)
      this.tensions[rope] = 1e3 * this.tensionCurves[rope]!.at(time);
  }

  private between(name: string, frame: number, next: number, share: number, out: Float64Array): void {
    const array = this.arrays.get(name);
    if (!array) return;
    const step = this.header.arrays[name]!.step ?? 1;
    const width = out.length;
    for (let place = 0; place < width; place++) {
      const begin = array[frame * width + place]!;
      out[place] = step * (begin + share * (array[next * width + place]! - begin));
    }
  }

  /** Turns between frames, the short way: a quaternion and its opposite are one attitude. */
  private turned(frame: number, next: number, share: number): void {
    const { arrays, turns } = this;
    const array = arrays.get("turn");
    if (!array) return;
    const step = this.header.arrays.turn!.step ?? 1;
    for (let first = 0; first < turns.length; first += 4) {
      const [begin, end] = [frame * turns.length + first, next * turns.length + first];
      let along = 0;
      for (let part = 0; part < 4; part++) along += array[begin + part]! * array[end + part]!;
      const side = along < 0 ? -1 : 1;
      for (let part = 0; part < 4; part++)
        turns[first + part] = step * ((1 - share) * array[begin + part]! + share * side * array[end + part]!);
    }
  }

  /** Distance of a watched pair at the present time [m]: from the skin of a rope, below zero where they overlap. */
  distance(pair: number): number {
    return this.clearanceCurves[pair]!.at(this.now);
  }

  /** Length of the line between a watched pair at the present time [m]; 0 where it has none, or touches. */
  lineOf(pair: number): number {
    const [at, { nearest }] = [6 * pair, this];
    return Math.hypot(
      nearest[at + 3]! - nearest[at]!,
      nearest[at + 4]! - nearest[at + 1]!,
      nearest[at + 5]! - nearest[at + 2]!,
    );
  }

  isTooClose(pair: number): boolean {
    const { smallest, span } = this.header.pairs[pair]!;
    if (span !== undefined && (this.now < span[0] || this.now > span[1])) return false;
    return this.distance(pair) < smallest;
  }

  /** Whether a rope is drawn hanging: it carries nothing and is longer than its way, and it has one, as it is not cut. */
  hangs(index: number): boolean {
    const rope = this.header.ropes[index]!;
    if (rope.length === null || this.tensions[index]! > 0) return false;
    const way = this.lengthOf(rope);
    return way > 0 && rope.length > way * (1 + 1e-6);
  }

  /** Length of a rope's recorded path at the present time [m]. */
  lengthOf(rope: Rope): number {
    let length = 0;
    for (let piece = 0; piece + 1 < rope.count; piece++) length += this.pieceLength(rope.first + piece);
    return length;
  }

  /**
   * The path of a rope as it is drawn at the present time: the recorded one; of a slack rope its long straight
   * spans hang, each by its share of what is too much.
   *
   * @returns Its points, x y z after each other; valid until the next call.
   */
  drawnPath(index: number): Float64Array {
    const rope = this.header.ropes[index]!;
    if (!this.hangs(index)) return this.recorded[index]!;
    let longest = 0;
    for (let piece = 0; piece + 1 < rope.count; piece++)
      longest = Math.max(longest, this.pieceLength(rope.first + piece));
    let hanging = 0;
    for (let piece = 0; piece + 1 < rope.count; piece++) {
      const length = this.pieceLength(rope.first + piece);
      if (length >= HANGING_FROM * longest) hanging += length;
    }
    const factor = 1 + (rope.length! - this.lengthOf(rope)) / hanging;
    const out = this.room(3 * (HANGING_PIECES * rope.count + 1));
    let size = 0;
    for (let piece = 0; piece + 1 < rope.count; piece++) {
      const from = this.point(rope.first + piece);
      const length = this.pieceLength(rope.first + piece);
      const to = this.point(rope.first + piece + 1);
      if (length < HANGING_FROM * longest) {
        out.set(from, size);
        size += 3;
      } else {
        hang(out, size, from, to, factor * length, HANGING_PIECES, Math.min(from[2], to[2]));
        size += 3 * HANGING_PIECES;
      }
    }
    out.set(this.point(rope.first + rope.count - 1), size);
    return out.subarray(0, size + 3);
  }

  private room(size: number): Float64Array {
    return this.chord.length >= size ? this.chord : new Float64Array(size);
  }

  private point(place: number): [number, number, number] {
    return [this.path[3 * place]!, this.path[3 * place + 1]!, this.path[3 * place + 2]!];
  }

  private pieceLength(place: number): number {
    const at = 3 * place;
    return Math.hypot(
      this.path[at + 3]! - this.path[at]!,
      this.path[at + 4]! - this.path[at + 1]!,
      this.path[at + 5]! - this.path[at + 2]!,
    );
  }
}

/** Arrays with a row for each frame. */
const MOVING = ["path", "sheave_angle", "contact_force", "clearance_point", "position", "turn"];

/** Samples and values of all curves. */
function kept(arrays: Map<string, Numbers>): [Uint32Array, Float32Array] {
  const samples = arrays.get("curve_sample") as Uint32Array | undefined;
  const values = arrays.get("curve_value") as Float32Array | undefined;
  return [samples ?? new Uint32Array(), values ?? new Float32Array()];
}

function stepsOf(header: Header): Step[] {
  return header.steps.map((step) => ({ ...step, name: step.names.join(" + ") }));
}
