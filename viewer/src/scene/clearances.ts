/** Smallest distances of watched pairs: a line from each side to the other, in a warning colour where it is too short. */

import { Color } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { Lift } from "../data/lift";
import type { Palette } from "../theme";

/** Shorter lines cannot be seen [m]: the pair touches, or there is no distance any more. */
export const TOUCHING = 1e-3;

const WIDTH = 1.8; // pixels

export class Clearances {
  readonly lines: LineSegments2;
  private readonly places: Float32Array;
  private readonly colours: Float32Array;

  constructor(
    private readonly lift: Lift,
    private readonly origin: readonly [number, number, number],
  ) {
    // A geometry without any piece has no middle.
    this.places = new Float32Array(Math.max(6, lift.nearest.length));
    this.colours = new Float32Array(this.places.length);
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(this.places);
    geometry.setColors(this.colours);
    geometry.instanceCount = lift.nearest.length / 6;
    // It is seen through what it is the distance of.
    const material = new LineMaterial({
      linewidth: WIDTH,
      vertexColors: true,
      depthTest: false,
      transparent: true,
    });
    this.lines = new LineSegments2(geometry, material);
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
    for (const name of ["instanceStart", "instanceColorStart"])
      this.lines.geometry.attributes[name]!.needsUpdate = true;
  }
}

const COLOUR = new Color();
