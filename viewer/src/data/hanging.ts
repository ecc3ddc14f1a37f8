/**
 * How a slack rope hangs between two points: a catenary of the rope's own length.
 *
 * With horizontal distance h, rise v and length s of the rope, the parameter a of z = a cosh(x/a) follows from
 * sqrt(s² − v²) = 2 a sinh(h / 2a) (Irvine 1981, "Cable Structures", 1.2).
 */

const SHORTEST = 1e-9;

/** h/2a of a rope that is longer than its chord. */
export function catenaryParameter(horizontal: number, rise: number, length: number): number {
  const ratio = Math.sqrt(length * length - rise * rise) / horizontal; // sinh(u)/u
  // Series near 1, logarithm far from it; then Newton on sinh(u) − ratio u, which is convex.
  let u = ratio < 3 ? Math.sqrt(6 * (ratio - 1)) : Math.log(2 * ratio) + Math.log(Math.log(2 * ratio));
  for (let round = 0; round < 50; round++) {
    const change = (Math.sinh(u) - ratio * u) / (Math.cosh(u) - ratio);
    u -= change;
    if (Math.abs(change) < 1e-12 * u) break;
  }
  return u;
}

/**
 * Points of a hanging rope, ends included.
 *
 * @param out Where they go, x y z after each other.
 * @param at Index of the first number in `out`.
 * @param from One end [m].
 * @param to The other end [m].
 * @param length Of the rope [m], more than the distance of its ends.
 * @param pieces How many straight pieces are drawn.
 * @param floor Where it lies down instead of hanging through [m].
 */
export function hang(
  out: Float64Array,
  at: number,
  from: readonly [number, number, number],
  to: readonly [number, number, number],
  length: number,
  pieces: number,
  floor: number,
): void {
  const dx = to[0] - from[0];
  const dy = to[1] - from[1];
  const rise = to[2] - from[2];
  const horizontal = Math.hypot(dx, dy);
  const chord = Math.hypot(horizontal, rise);
  const straight = length <= chord * (1 + SHORTEST) || horizontal < 1e-3 * length;
  const u = straight ? 0 : catenaryParameter(horizontal, rise, length);
  const a = horizontal / (2 * u);
  // Lowest point: the mean slope is that of the chord.
  const lowest = horizontal / 2 - a * Math.asinh(rise / (2 * a * Math.sinh(u)));
  const base = a * Math.cosh(-lowest / a);
  for (let piece = 0; piece <= pieces; piece++) {
    const share = piece / pieces;
    const place = at + 3 * piece;
    const along = share * horizontal;
    const height = straight ? share * rise : a * Math.cosh((along - lowest) / a) - base;
    out[place] = from[0] + share * dx;
    out[place + 1] = from[1] + share * dy;
    out[place + 2] = Math.max(from[2] + height, Math.min(floor, from[2], to[2]));
  }
}
