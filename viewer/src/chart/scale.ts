/** Axes: round ticks, and numbers as people read them. */

export interface Scale {
  low: number;
  high: number;
  ticks: number[];
  digits: number;
}

/** Round ticks over a span, about as many as wanted, and the step from one to the next. */
export function ticksOf(
  low: number,
  high: number,
  wanted: number,
): { ticks: number[]; digits: number; step: number } {
  const span = high - low;
  if (!(span > 0) || !Number.isFinite(span)) return { ticks: [low], digits: 0, step: span };
  const rough = span / Math.max(1, wanted);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 2.5, 5, 10].find((factor) => factor * power >= rough * 0.999) ?? 10);
  // 10 ** -4 is a little less than 0.0001.
  const isQuarter = Math.abs(step / power - 2.5) < 1e-9;
  const digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9) + (isQuarter ? 1 : 0));
  const ticks: number[] = [];
  for (let index = Math.ceil(low / step - 1e-9) + 0; index * step <= high + 1e-9 * span; index++)
    ticks.push(index * step);
  return { ticks, digits: Math.min(digits, 6), step };
}

/** A vertical axis that holds all values and ends at round numbers. */
export function verticalScale(least: number, largest: number, wanted: number, smallest: number): Scale {
  let [low, high] = [least, largest];
  if (!(low <= high)) [low, high] = [0, 1];
  if (low > 0 && low < 0.6 * high) low = 0;
  if (high < 0 && high > 0.6 * low) high = 0;
  const middle = (low + high) / 2;
  if (high - low < smallest) [low, high] = [middle - smallest / 2, middle + smallest / 2];
  const { digits, step } = ticksOf(low, high, wanted);
  const bottom = Math.floor(low / step + 1e-9) * step;
  const top = Math.ceil(high / step - 1e-9) * step;
  return { low: bottom, high: top, ticks: ticksOf(bottom, top, wanted).ticks, digits };
}

/** A number with so many decimals, a proper minus, and never "-0". */
export function shown(value: number, digits: number): string {
  if (!Number.isFinite(value)) return "–";
  const text = Math.abs(value).toFixed(digits);
  return value < 0 && Number(text) !== 0 ? `−${text}` : text;
}

/**
 * A value with its unit as people read it: with the decimals of the unit, and of forces with three digits of the
 * largest one; in N where that is less than 1 kN, of which 0.005 kN would be one digit.
 */
export function valueText(value: number, unit: string, largest: number): string {
  const most = Math.abs(largest);
  if (unit === "kN" && most < 1) return forceText(1e3 * value, 1e3 * most);
  const small = unit === "kN" && most < 10 ? 1 : 0;
  return `${shown(value, (DIGITS[unit] ?? 2) + small)} ${unit}`.trim();
}

/** Decimals with which values of a unit are read. */
const DIGITS: Record<string, number> = { kN: 1, m: 3, deg: 2, "%": 1, MJ: 3, "": 2 };

/**
 * A force as people read it, with its unit: in N where the largest one [N] is less than 1 kN, with three digits of the
 * largest, or more.
 */
export function forceText(force: number, largest: number, more = 0): string {
  const unit = largest < 1e3 ? 1 : 1e3;
  const digits = largest < 10 * unit ? 2 : largest < 100 * unit ? 1 : 0;
  return `${shown(force / unit, digits + more)} ${unit === 1 ? "N" : "kN"}`;
}

/** Characters of a name, as in pictures: of a longer one nothing else would have room beside it. */
const MOST_OF_A_NAME = 21;

/** A name on paper or in the drawing: of a long one both ends, in which names of one kind differ. */
export function shortenedInside(name: string): string {
  const half = (MOST_OF_A_NAME - 1) / 2;
  return name.length <= MOST_OF_A_NAME ? name : `${name.slice(0, half)}…${name.slice(-half)}`;
}
