/** Where a camera stands so that what it shows fills the part of the drawing on which nothing lies. */

import { Vector3 } from "three";
import type { Box } from "./settle";

/** A part of a drawing, in shares of half its width and height from its middle, right and up positive. */
export interface Room {
  left: number;
  right: number;
  low: number;
  high: number;
}

export const WHOLE: Room = { left: -1, right: 1, low: -1, high: 1 };

const EDGE = 12; // pixels that stay free at the edges of the drawing, and beside what lies on it
const LEAST = 0.25; // of the drawing along each side, for a room that is worth while
const WIDEST = 0.36; // of the width, for what one goes past at its side

/**
 * Rooms between what lies on a drawing: symmetric from side to side, some wide and low, some narrow and high.
 *
 * A room begins beside one of the boxes and is as high as the boxes over and under it let it be.
 */
export function roomsBetween(boxes: readonly Box[], width: number, height: number): Room[] {
  const lying = boxes.filter((box) => box.width > 0 && box.height > 0);
  const aside = (box: Box) => Math.min(box.x, width - box.x) + box.width / 2 + EDGE;
  const sides = [EDGE, ...lying.filter((box) => box.width < WIDEST * width).map(aside)];
  const rooms: Room[] = [];
  for (const side of sides) {
    let [top, bottom] = [EDGE, height - EDGE];
    for (const box of lying) {
      if (aside(box) <= side) continue;
      if (box.y < height / 2) top = Math.max(top, box.y + box.height / 2 + EDGE);
      else bottom = Math.min(bottom, box.y - box.height / 2 - EDGE);
    }
    if (width - 2 * side < LEAST * width || bottom - top < LEAST * height) continue;
    const half = 1 - (2 * side) / width;
    rooms.push({ left: -half, right: half, low: 1 - (2 * bottom) / height, high: 1 - (2 * top) / height });
  }
  return rooms.length > 0 ? rooms : [WHOLE];
}

/** A camera's axes, and the tangents of half its angles of view across and up. */
export interface Lens {
  right: Vector3;
  up: Vector3;
  back: Vector3;
  across: number;
  above: number;
}

/** The lens of a camera that looks from a way [towards it] on what has z up. */
export function lensFrom(way: Vector3, fov: number, aspect: number): Lens {
  const back = way.clone().normalize();
  const right = new Vector3(0, 0, 1).cross(back).normalize();
  const above = Math.tan((fov * Math.PI) / 360);
  return { right, up: back.clone().cross(right), back, across: above * aspect, above };
}

/**
 * The nearest place from which all points, x y z after each other, are seen within a room.
 *
 * A camera at c sees a point p at the tangent (p_x - c_x)/(c_z - p_z) of its axes. That this is between l and r says
 * p_x + r p_z - r c_z <= c_x <= p_x + l p_z - l c_z: the outermost points alone decide on how far back c_z is,
 * across and up for themselves; where there is room left, they stand in the middle of it. From the nearest point it
 * keeps a distance at least [m].
 */
export function placeFor(points: ArrayLike<number>, lens: Lens, room: Room, distance: number): Vector3 {
  const sides = [
    { axis: lens.right, from: room.left * lens.across, to: room.right * lens.across },
    { axis: lens.up, from: room.low * lens.above, to: room.high * lens.above },
  ].map((side) => ({ ...side, most: -Infinity, least: Infinity }));
  let nearest = -Infinity;
  for (let at = 0; at + 2 < points.length; at += 3) {
    POINT.set(points[at]!, points[at + 1]!, points[at + 2]!);
    const towards = POINT.dot(lens.back);
    nearest = Math.max(nearest, towards);
    for (const side of sides) {
      const out = POINT.dot(side.axis);
      side.most = Math.max(side.most, out + side.to * towards);
      side.least = Math.min(side.least, out + side.from * towards);
    }
  }
  const wanted = sides.map(({ most, least, from, to }) => (most - least) / (to - from));
  const far = Math.max(nearest + distance, ...wanted);
  const place = lens.back.clone().multiplyScalar(far);
  for (const { axis, most, least, from, to } of sides)
    place.addScaledVector(axis, (most + least - (from + to) * far) / 2);
  return place;
}

const POINT = new Vector3();
