/** The surface of the water, through which one sees what is below: still, or with the waves that run over it. */

import {
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  Color,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
} from "three";
import type { Lift } from "../data/lift";
import type { Palette } from "../theme";
import { faded, fading, gridGeometry, reachOf } from "./fading";
import type { Extent } from "./world";

/** Lines of the moving surface along each side. */
const LINES = 97;
/** Spacing of its lines in the middle, as a share of what it would be if all were alike: finer where the vessels are. */
const FINE = 0.4;
/** Spaces between lines that a wave has to be long to be drawn, and to be drawn in full. */
const [SHORTEST, WHOLE] = [3, 6];
/** How strong the colour is in the middle. */
const STRENGTH = 0.75;
/** How much lighter or darker the steepest slopes are; low waves beside a long vessel are seen by that alone. */
const SHADE = 0.16;
/** From where light comes, over the water. */
const LIGHT = [-0.45, -0.89] as const;

export class Sea {
  readonly group = new Group();
  private readonly waves: Waves | null;
  private readonly cell: number;
  private readonly half: number;
  private surface: MovingSurface | null = null;
  private drawn = Number.NaN;

  constructor(
    private readonly lift: Pick<Lift, "header" | "array">,
    private readonly extent: Extent,
  ) {
    ({ cell: this.cell, half: this.half } = reachOf(extent));
    const components = lift.array("waves");
    const { riseTime } = lift.header;
    this.waves =
      components && components.length > 0 && riseTime !== null
        ? new Waves(components, riseTime, extent.middle, this.half)
        : null;
  }

  /** Lay it in the colours of a palette. */
  lay(palette: Palette): void {
    this.group.clear();
    const { water, ground } = this.lift.header;
    if (water === null) return;
    this.group.position.z = water - this.extent.middle[2];
    const material = new MeshBasicMaterial({
      vertexColors: true,
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    if (this.waves) {
      this.surface = new MovingSurface(this.waves, palette.water);
      this.add(new Mesh(this.surface.geometry, material));
      this.drawn = Number.NaN;
      return;
    }
    const disc = new CircleGeometry(this.half, 48, 0, 2 * Math.PI).toNonIndexed();
    this.add(new Mesh(faded(disc, palette.water, this.half, STRENGTH), material));
    if (ground !== null) return;
    const lines = new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false });
    this.add(
      new LineSegments(faded(gridGeometry(this.half, this.cell), palette.grid, this.half, 0.6), lines),
    );
  }

  /** Let the waves go on to a time [s]. */
  update(time: number): void {
    if (!this.surface || time === this.drawn) return;
    this.drawn = time;
    this.surface.update(time);
  }

  private add(part: Mesh | LineSegments): void {
    // After all that is solid.
    part.renderOrder = 1;
    // The surface moves, and is about the middle of what is seen in any case.
    part.frustumCulled = this.waves === null;
    this.group.add(part);
  }
}

/** The waves at the crossings of lines along x and y, close to each other in the middle. */
export class Waves {
  /** Where the lines are, from the middle [m]. */
  readonly lines: Float64Array;
  /** Of usual size: root mean square of the slope towards the light, as drawn. */
  readonly slope: number;
  /** η at the crossings, x running faster [m]. */
  readonly heights = new Float64Array(LINES * LINES);
  /** Re and Im of exp(i k x) over the lines, for each wave, along x and along y. */
  private readonly along: [Float64Array, Float64Array];
  private readonly row = new Float64Array(2 * LINES);

  constructor(
    /** ω, k along x and y, amplitude and phase of each wave, of world axes. */
    private readonly components: ArrayLike<number>,
    private readonly riseTime: number,
    middle: readonly number[],
    readonly half: number,
  ) {
    this.lines = Float64Array.from({ length: LINES }, (_, line) => {
      const share = (2 * line) / (LINES - 1) - 1;
      return half * (FINE * share + (1 - FINE) * share ** 3);
    });
    this.along = [this.turns(1, middle[0]!), this.turns(2, middle[1]!)];
    let square = 0;
    for (let at = 0; at < components.length; at += 5) {
      const towards = LIGHT[0] * components[at + 1]! + LIGHT[1] * components[at + 2]!;
      const shown = this.share(components[at + 1]!, LINES >> 1) * this.share(components[at + 2]!, LINES >> 1);
      square += (components[at + 3]! * towards * shown) ** 2 / 2;
    }
    this.slope = Math.sqrt(square);
  }

  /** Find the heights at a time [s]. */
  update(time: number): void {
    const { components, heights, row } = this;
    const [alongX, alongY] = this.along;
    heights.fill(0);
    const risen = Math.min(Math.max(time / this.riseTime, 0), 1);
    const growth = risen ** 3 * (10 - risen * (15 - 6 * risen));
    for (let at = 0, first = 0; at < components.length; at += 5, first += 2 * LINES) {
      const angle = components[at + 4]! - components[at]! * time;
      const [re, im] = [
        growth * components[at + 3]! * Math.cos(angle),
        growth * components[at + 3]! * Math.sin(angle),
      ];
      for (let x = 0; x < 2 * LINES; x += 2) {
        const [c, s] = [alongX[first + x]!, alongX[first + x + 1]!];
        row[x] = re * c - im * s;
        row[x + 1] = re * s + im * c;
      }
      for (let y = 0, place = 0; y < 2 * LINES; y += 2) {
        const [c, s] = [alongY[first + y]!, alongY[first + y + 1]!];
        for (let x = 0; x < 2 * LINES; x += 2, place++) heights[place]! += row[x]! * c - row[x + 1]! * s;
      }
    }
  }

  /** exp(i k x) over the lines, less where they are too far apart for the wave. */
  private turns(which: 1 | 2, middle: number): Float64Array {
    const { components, lines } = this;
    const turns = new Float64Array((components.length / 5) * 2 * LINES);
    for (let at = 0, place = 0; at < components.length; at += 5) {
      const number = components[at + which]!;
      for (let line = 0; line < LINES; line++) {
        const share = this.share(number, line);
        turns[place++] = share * Math.cos(number * (lines[line]! + middle));
        turns[place++] = share * Math.sin(number * (lines[line]! + middle));
      }
    }
    return turns;
  }

  /** How much of a wave with this wave number can be drawn at a line. */
  private share(number: number, line: number): number {
    const [before, after] = [Math.max(line - 1, 0), Math.min(line + 1, LINES - 1)];
    const space = (this.lines[after]! - this.lines[before]!) / (after - before);
    const spaces = (2 * Math.PI) / Math.max(Math.abs(number), 1e-9) / space;
    return Math.min(Math.max((spaces - SHORTEST) / (WHOLE - SHORTEST), 0), 1);
  }
}

/** A geometry that follows the waves, lighter on the slopes towards the light. */
class MovingSurface {
  readonly geometry = new BufferGeometry();
  private readonly places = new Float32Array(3 * LINES * LINES);
  private readonly colours = new Float32Array(4 * LINES * LINES);
  private readonly base: Color;

  constructor(
    private readonly waves: Waves,
    colour: number,
  ) {
    this.base = new Color(colour);
    const { lines, half } = waves;
    const faces: number[] = [];
    for (let y = 0, place = 0; y < LINES; y++)
      for (let x = 0; x < LINES; x++, place++) {
        this.places.set([lines[x]!, lines[y]!, 0], 3 * place);
        this.colours[4 * place + 3] = fading(Math.hypot(lines[x]!, lines[y]!) / half, STRENGTH);
        if (x + 1 < LINES && y + 1 < LINES)
          faces.push(place, place + 1, place + LINES + 1, place, place + LINES + 1, place + LINES);
      }
    this.geometry.setIndex(faces);
    for (const [name, values, size] of [
      ["position", this.places, 3],
      ["color", this.colours, 4],
    ] as const)
      this.geometry.setAttribute(name, new BufferAttribute(values, size).setUsage(DynamicDrawUsage));
  }

  update(time: number): void {
    const { waves, places, colours, base } = this;
    waves.update(time);
    const { heights, lines } = waves;
    const gain = waves.slope > 0 ? 0.5 / waves.slope : 0;
    for (let y = 0, place = 0; y < LINES; y++) {
      const [south, north] = [Math.max(y - 1, 0), Math.min(y + 1, LINES - 1)];
      for (let x = 0; x < LINES; x++, place++) {
        const [west, east] = [Math.max(x - 1, 0), Math.min(x + 1, LINES - 1)];
        const acrossX =
          (heights[y * LINES + east]! - heights[y * LINES + west]!) / (lines[east]! - lines[west]!);
        const acrossY =
          (heights[north * LINES + x]! - heights[south * LINES + x]!) / (lines[north]! - lines[south]!);
        // What falls towards the light faces it.
        const towards = LIGHT[0] * acrossX + LIGHT[1] * acrossY;
        const light = 1 - SHADE * Math.tanh(gain * towards);
        places[3 * place + 2] = heights[place]!;
        colours[4 * place] = Math.min(base.r * light, 1);
        colours[4 * place + 1] = Math.min(base.g * light, 1);
        colours[4 * place + 2] = Math.min(base.b * light, 1);
      }
    }
    this.geometry.attributes.position!.needsUpdate = true;
    this.geometry.attributes.color!.needsUpdate = true;
  }
}
