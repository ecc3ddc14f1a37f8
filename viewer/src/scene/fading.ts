/** Ground and water have no end: they fade away. */

import { BufferAttribute, BufferGeometry, Color } from "three";
import type { Extent } from "./world";

/** How far ground and water reach about the middle [m], and the cells of their grid. */
export function reachOf({ size, low, high }: Extent): { cell: number; half: number } {
  const cell = niceCell(size / 12);
  const wide = Math.max(high[0] - low[0], high[1] - low[1], 0.8 * size);
  return { cell, half: Math.ceil(wide / cell) * cell * 1.3 };
}

/** Lines over a square, cut where they cross, so that each part can fade. */
export function gridGeometry(half: number, cell: number): BufferGeometry {
  const places: number[] = [];
  const count = Math.floor(half / cell);
  for (let line = -count; line <= count; line++) {
    for (let part = -count; part < count; part++) {
      places.push(line * cell, part * cell, 0, line * cell, (part + 1) * cell, 0);
      places.push(part * cell, line * cell, 0, (part + 1) * cell, line * cell, 0);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(places), 3));
  return geometry;
}

/** A flat geometry in one colour that fades away from the middle. */
export function faded(
  geometry: BufferGeometry,
  colour: number,
  radius: number,
  strength: number,
): BufferGeometry {
  const places = geometry.attributes.position!;
  const colours = new Float32Array(4 * places.count);
  const { r, g, b } = new Color(colour);
  for (let at = 0; at < places.count; at++) {
    const out = Math.hypot(places.getX(at), places.getY(at)) / radius;
    colours.set([r, g, b, fading(out, strength)], 4 * at);
  }
  geometry.setAttribute("color", new BufferAttribute(colours, 4));
  return geometry;
}

/** How strong a colour is still at a share of the way out. */
export function fading(out: number, strength: number): number {
  return strength * Math.max(0, 1 - out) ** 0.8;
}

/** What is a round number of metres near a size. */
export function niceCell(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  const share = size / power;
  return power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
}
