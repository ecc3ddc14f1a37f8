/** Where a name goes so that it covers no other, nor the buttons, and none of it is cut off. */

/** A box by its middle [pixels]. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** How far a name may go from what it names, down and up [pixels]. */
const FAR = { 1: 54, [-1]: 20 } as const;
const GAP = 2; // pixels

/**
 * Move a box to the nearest free place below its own, or else above; false where that would be too far.
 *
 * It stays within the drawing; what lies outside has no name.
 */
export function settle(box: Box, taken: readonly Box[], width: number, height: number): boolean {
  if (box.x < 0 || box.x > width || box.y < 0 || box.y > height) return false;
  const within = (place: number, size: number, room: number) =>
    Math.max(size / 2, Math.min(room - size / 2, place));
  box.x = within(box.x, box.width, width);
  const start = within(box.y, box.height, height);
  for (const way of [1, -1] as const) {
    box.y = start;
    while (Math.abs(box.y - start) <= FAR[way] && box.y === within(box.y, box.height, height)) {
      const other = taken.find((one) => overlap(one, box));
      if (!other) return true;
      box.y = other.y + way * ((other.height + box.height) / 2 + GAP);
    }
  }
  return false;
}

function overlap(one: Box, other: Box): boolean {
  return (
    Math.abs(one.x - other.x) < (one.width + other.width) / 2 &&
    Math.abs(one.y - other.y) < (one.height + other.height) / 2
  );
}
