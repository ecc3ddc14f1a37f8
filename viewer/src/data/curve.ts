/** One series over time, decimated so that its peaks are there. */

import type { CurveEntry } from "./format";

export class Curve {
  readonly times: Float64Array;
  readonly values: Float32Array;
  readonly least: number;
  readonly largest: number;

  constructor(
    readonly entry: CurveEntry,
    time: Float64Array,
    samples: Uint32Array,
    values: Float32Array,
  ) {
    const { first, count } = entry;
    this.times = Float64Array.from(samples.subarray(first, first + count), (sample) => time[sample]!);
    this.values = values.subarray(first, first + count);
    let least = Number.POSITIVE_INFINITY;
    let largest = Number.NEGATIVE_INFINITY;
    for (const value of this.values) {
      least = Math.min(least, value);
      largest = Math.max(largest, value);
    }
    this.least = least;
    this.largest = largest;
  }

  /** Index of the last kept sample that is not after a time; the first one before the start. */
  before(time: number): number {
    return lastNotAfter(this.times, time);
  }

  /** Value at a time, by straight lines; constant beyond the ends. */
  at(time: number): number {
    const place = this.before(time);
    const begin = this.values[place] ?? Number.NaN;
    if (place + 1 >= this.times.length) return begin;
    const from = this.times[place]!;
    const share = (time - from) / (this.times[place + 1]! - from);
    return share <= 0 ? begin : begin + share * (this.values[place + 1]! - begin);
  }
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
