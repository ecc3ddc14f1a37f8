/** Smallest distances of watched pairs: a line from each side to the other, in a warning colour where it is too short. */

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  LineBasicMaterial,
  LineSegments,
} from "three";
import type { Lift } from "../data/lift";
import type { Palette } from "../theme";

/** Shorter lines cannot be seen [m]: the pair touches, or there is no distance any more. */
export const TOUCHING = 1e-3;

export class Clearances {
  readonly lines: LineSegments;
  private readonly places: Float32Array;
  private readonly colours: Float32Array;

  constructor(
    private readonly lift: Lift,
    private readonly origin: readonly [number, number, number],
  ) {
    this.places = new Float32Array(lift.nearest.length);
    this.colours = new Float32Array(lift.nearest.length);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(this.places, 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("color", new BufferAttribute(this.colours, 3).setUsage(DynamicDrawUsage));
    // It is seen through what it is the distance of.
    const material = new LineBasicMaterial({ vertexColors: true, depthTest: false, transparent: true });
    this.lines = new LineSegments(geometry, material);
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 2;
  }

  update(palette: Palette): void {
    const { nearest, header } = this.lift;
    for (let place = 0; place < nearest.length; place++)
      this.places[place] = nearest[place]! - this.origin[place % 3]!;
    for (let pair = 0; pair < header.pairs.length; pair++) {
      COLOUR.set(this.lift.isTooClose(pair) ? palette.tooClose : palette.clearance);
      for (let end = 0; end < 2; end++) COLOUR.toArray(this.colours, 6 * pair + 3 * end);
    }
    for (const name of ["position", "color"]) this.lines.geometry.attributes[name]!.needsUpdate = true;
  }
}

const COLOUR = new Color();
