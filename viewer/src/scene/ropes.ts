/** Ropes in few draw calls: wide lines of screen width, or thin ones where drawing is slow. */

import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineSegments,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { HANGING_PIECES, type Lift } from "../data/lift";
import { type Palette, rampInto } from "../theme";

type Point = readonly [number, number, number];

/** Widths on the screen [pixels]: falls of a reeved hook hang too close together for wide lines. */
const WIDTH = 2.6;
const WIDTH_OF_FALLS = 1.2;
const WIDTH_OF_PINNED = 7;

export class Ropes {
  readonly group = new Group();
  private readonly bundles: Bundle[];
  private readonly pinned: Pieces;
  private readonly pinnedMaterial = new LineMaterial({
    linewidth: WIDTH_OF_PINNED,
    transparent: true,
    opacity: 0.28,
  });

  constructor(
    private readonly lift: Lift,
    private readonly origin: Point,
  ) {
    const { ropes } = lift.header;
    const all = ropes.map((_, index) => index);
    const isFall = (index: number) => ropes[index]!.kind === "rope" && ropes[index]!.count > 40;
    this.bundles = [
      new Bundle(
        lift,
        all.filter((index) => !isFall(index)),
        WIDTH,
      ),
      new Bundle(lift, all.filter(isFall), WIDTH_OF_FALLS),
    ];
    this.pinned = new Pieces(Math.max(1, ...ropes.map((rope) => roomOf(rope))));
    const halo = new LineSegments2(this.pinned.wide, this.pinnedMaterial);
    halo.frustumCulled = false;
    this.group.add(...this.bundles.map((bundle) => bundle.group), halo);
  }

  setThin(isThin: boolean): void {
    for (const bundle of this.bundles) bundle.setThin(isThin);
  }

  setPalette(palette: Palette): void {
    this.pinnedMaterial.color.set(palette.pinned);
  }

  /** Draw the ropes as they are at the lift's present time. */
  update(palette: Palette, largest: number, pinned: string | null): void {
    for (const bundle of this.bundles) bundle.update(palette, largest, this.origin);
    this.pinned.size = 0;
    const index = this.lift.header.ropes.findIndex((rope) => rope.name === pinned);
    if (index >= 0) this.pinned.add(this.lift.drawnPath(index), this.origin);
    this.pinned.finish();
  }
}

/** Ropes of one width. */
class Bundle {
  readonly group = new Group();
  private readonly pieces: Pieces;
  private readonly thin: LineSegments;
  private readonly wide: LineSegments2;

  constructor(
    private readonly lift: Lift,
    private readonly ropes: number[],
    width: number,
  ) {
    this.pieces = new Pieces(ropes.reduce((sum, index) => sum + roomOf(lift.header.ropes[index]!), 0));
    this.thin = new LineSegments(this.pieces.thin, new LineBasicMaterial({ vertexColors: true }));
    this.wide = new LineSegments2(
      this.pieces.wide,
      new LineMaterial({ linewidth: width, vertexColors: true }),
    );
    this.thin.frustumCulled = false;
    this.wide.frustumCulled = false;
    this.group.add(this.thin, this.wide);
    this.setThin(false);
  }

  setThin(isThin: boolean): void {
    this.thin.visible = isThin;
    this.wide.visible = !isThin;
  }

  update(palette: Palette, largest: number, origin: Point): void {
    this.pieces.size = 0;
    for (const index of this.ropes) {
      const tension = this.lift.tensions[index]!;
      if (tension > 0) rampInto(palette, tension / largest, COLOUR, 0);
      else COLOUR.set(palette.slack);
      this.pieces.add(this.lift.drawnPath(index), origin, COLOUR);
    }
    this.pieces.finish();
  }
}

const COLOUR = new Float32Array(3);

/** Straight pieces with their ends and colours, in buffers that wide and thin lines share. */
class Pieces {
  /** Numbers in use: six for each piece. */
  size = 0;
  readonly wide = new LineSegmentsGeometry();
  readonly thin = new BufferGeometry();
  private readonly places: Float32Array;
  private readonly colours: Float32Array;

  constructor(count: number) {
    this.places = new Float32Array(6 * Math.max(1, count));
    this.colours = new Float32Array(this.places.length);
    this.wide.setPositions(this.places);
    this.wide.setColors(this.colours);
    this.thin.setAttribute("position", new BufferAttribute(this.places, 3).setUsage(DynamicDrawUsage));
    this.thin.setAttribute("color", new BufferAttribute(this.colours, 3).setUsage(DynamicDrawUsage));
  }

  /** Add a path in one colour, from an origin near it. */
  add(path: Float64Array, [x, y, z]: Point, colour?: Float32Array): void {
    for (let at = 0; at + 5 < path.length && this.size + 5 < this.places.length; at += 3) {
      for (let end = 0; end < 2; end++) {
        const from = at + 3 * end;
        const to = this.size + 3 * end;
        this.places[to] = path[from]! - x;
        this.places[to + 1] = path[from + 1]! - y;
        this.places[to + 2] = path[from + 2]! - z;
        if (colour) this.colours.set(colour, to);
      }
      this.size += 6;
    }
  }

  /** Hand what was added to the graphics card. */
  finish(): void {
    this.wide.instanceCount = this.size / 6;
    this.thin.setDrawRange(0, this.size / 3);
    for (const name of ["instanceStart", "instanceColorStart"])
      this.wide.attributes[name]!.needsUpdate = true;
    for (const name of ["position", "color"]) this.thin.attributes[name]!.needsUpdate = true;
  }
}

/** Most pieces in which a rope is drawn: many where it may hang slack. */
function roomOf(rope: { count: number; length: number | null }): number {
  return (rope.count - 1) * (rope.length === null ? 1 : HANGING_PIECES);
}
