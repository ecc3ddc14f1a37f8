/** Which rope or lug is under the pointer: the nearest on the screen, not in space. */

import type { Lift } from "../data/lift";
import type { World } from "./world";

const NEAR = 11; // pixels
const LUG_NEAR = 14;

/** Name of the rope there, or of the rope that is made fast to the lug there; null where there is none. */
export function ropeAt(
  world: World,
  lift: Lift,
  x: number,
  y: number,
  width: number,
  height: number,
): string | null {
  let best = NEAR;
  let found: string | null = null;
  lift.header.ropes.forEach((rope, index) => {
    const path = lift.drawnPath(index);
    const isLug = lift.header.lugs.some((lug) => lug.rope === rope.name);
    let from: [number, number] | null = null;
    for (let at = 0; at < path.length; at += 3) {
      const to = world.project(path[at]!, path[at + 1]!, path[at + 2]!, width, height);
      if (from && to) {
        const off = distanceToPiece(x, y, from, to);
        if (off < best) [best, found] = [off, rope.name];
      }
      // A lug is easier to meet than the thin rope that ends there.
      if (isLug && to && at + 3 >= path.length) {
        const off = (Math.hypot(to[0] - x, to[1] - y) * NEAR) / LUG_NEAR / 2;
        if (off < best) [best, found] = [off, rope.name];
      }
      from = to;
    }
  });
  return found;
}

/** Distance of a point to a straight piece on the screen. */
export function distanceToPiece(x: number, y: number, from: [number, number], to: [number, number]): number {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const square = dx * dx + dy * dy;
  const share = square > 0 ? ((x - from[0]) * dx + (y - from[1]) * dy) / square : 0;
  const bounded = Math.min(1, Math.max(0, share));
  return Math.hypot(x - from[0] - bounded * dx, y - from[1] - bounded * dy);
}
