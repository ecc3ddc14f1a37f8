/** One series over time, decimated so that its peaks are there; no number is where a gap begins. */

import type { CurveEntry } from "./format";

export class Curve {
  times = new Float64Array();
  values = new Float32Array();
  least = Number.POSITIVE_INFINITY;
  largest = Number.NEGATIVE_INFINITY;
  /** When it was so [s]. */
  leastTime = Number.NaN;
  largestTime = Number.NaN;
  private peak: [number, number] | null = null;

  constructor(
    readonly entry: CurveEntry,
    time: Float64Array,
    samples: Uint32Array,
    values: Float32Array,
  ) {
    this.append(entry, time, samples, values);
  }

  /** Go on with what was recorded later; arguments as those of the constructor. */
  append(
    { first, count, peak }: CurveEntry,
    time: Float64Array,
    samples: Uint32Array,
    values: Float32Array,
  ): void {
    const times = Float64Array.from(samples.subarray(first, first + count), (sample) => time[sample]!);
    const more = values.subarray(first, first + count);
    this.times = joined(Float64Array, this.times, times);
    this.values = joined(Float32Array, this.values, more);
    more.forEach((value, place) => {
      if (value < this.least) [this.least, this.leastTime] = [value, times[place]!];
      if (value > this.largest) [this.largest, this.largestTime] = [value, times[place]!];
    });
    this.peak = peak ?? null;
  }

  /** Largest value of all steps where that is known, else of all samples; and its time [s]. */
  get top(): [number, number] {
    return this.peak ?? [this.largest, this.largestTime];
  }

  /** Index of the last kept sample that is not after a time; the first one before the start. */
  before(time: number): number {
    return lastNotAfter(this.times, time);
  }

  /** Whether it has a value at a time: a spread has none while the load stands, a distance none once its rope has parted. */
  isKnownAt(time: number): boolean {
    const isWithin = time >= this.times[0]! && time <= this.times[this.times.length - 1]!;
    return isWithin && !Number.isNaN(this.at(time));
  }

  /** The last value up to a time, beyond a gap too; no number before the first one. */
  lastUpTo(time: number): number {
    if (this.isKnownAt(time)) return this.at(time);
    let place = this.before(time);
    while (place > 0 && Number.isNaN(this.values[place]!)) place -= 1;
    return this.values[place] ?? Number.NaN;
  }

  /** Value at a time, by straight lines; constant beyond the ends, no number in a gap. */
  at(time: number): number {
    const place = this.before(time);
    const begin = this.values[place] ?? Number.NaN;
    if (place + 1 >= this.times.length) return begin;
    const from = this.times[place]!;
    const share = (time - from) / (this.times[place + 1]! - from);
    return share <= 0 ? begin : begin + share * (this.values[place + 1]! - begin);
  }
}

/** One array after another. */
export function joined<Numbers extends Float64Array | Float32Array>(
  Kind: new (size: number) => Numbers,
  one: ArrayLike<number>,
  other: ArrayLike<number>,
): Numbers {
  const all = new Kind(one.length + other.length);
  all.set(one);
  all.set(other, one.length);
  return all;
}

/** Index of the last of increasing numbers that is not above a bound; 0 if all are. */
export function lastNotAfter(numbers: ArrayLike<number>, bound: number): number {
  let low = 0;
  let high = numbers.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (numbers[middle]! <= bound) low = middle;
    else high = middle - 1;
  }
  return low;
}
