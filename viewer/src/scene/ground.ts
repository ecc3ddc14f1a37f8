/** The ground: a disc with a grid that fades away, and the pit of each hole in it. */

import {
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  FrontSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Plane,
  Vector3,
} from "three";
import type { Header, Hole, Vector } from "../data/format";
import type { Palette } from "../theme";
import { faded, gridGeometry, reachOf } from "./fading";
import type { Extent } from "./world";

/** Pieces of a wall or floor along each side, so that each can fade. */
const PIECES = 16;

export class Ground {
  readonly group = new Group();
  private readonly cell: number;
  private readonly half: number;

  constructor(
    private readonly header: Pick<Header, "ground" | "holes">,
    private readonly extent: Extent,
  ) {
    ({ cell: this.cell, half: this.half } = reachOf(extent));
  }

  /** Lay it in the colours of a palette. */
  lay(palette: Palette): void {
    this.group.clear();
    if (this.header.ground !== null) this.layGround(this.header.ground, palette);
  }

  private layGround(level: number, palette: Palette): void {
    const { holes } = this.header;
    const { size, middle } = this.extent;
    const { cell, half } = this;
    // On whole multiples of the grid, so that its lines are at round numbers.
    const snap = (value: number) => Math.round(value / cell) * cell - value;
    const ground = new Group();
    ground.position.set(snap(middle[0]), snap(middle[1]), level - middle[2]);
    this.group.add(ground);
    const outside = outsideOf(holes, middle);
    const disc = new Mesh(
      faded(new CircleGeometry(half, 48).toNonIndexed(), palette.ground, half, 0.9),
      // With a hole the ground hides what lies under it.
      new MeshBasicMaterial({
        vertexColors: true,
        transparent: true,
        depthWrite: holes.length > 0,
        ...outside,
      }),
    );
    disc.renderOrder = -4;
    disc.position.z = -0.0004 * size;
    const grid = new LineSegments(
      faded(gridGeometry(half, cell), palette.grid, half, 0.9),
      new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false, ...outside }),
    );
    grid.renderOrder = -1;
    ground.add(disc, grid);
    const origin: Vector = [Math.round(middle[0] / cell) * cell, Math.round(middle[1] / cell) * cell, level];
    for (const hole of holes) ground.add(...this.pit(pitOf(hole, level), origin, palette));
  }

  /** Walls, floor and edges of a hole. */
  private pit({ floor, walls, edges }: Pit, origin: Vector, palette: Palette): (Mesh | LineSegments)[] {
    const placed = (places: number[], colour: number) => {
      const moved = places.map((value, at) => value - origin[at % 3]!);
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(new Float32Array(moved), 3));
      return faded(geometry, colour, this.half, 1);
    };
    const sides = [floor, walls].map((places, index) => {
      // Seen from inside alone: the wall towards the viewer lies behind the ground.
      const material = new MeshBasicMaterial({
        vertexColors: true,
        transparent: true,
        depthWrite: false,
        side: FrontSide,
      });
      const mesh = new Mesh(placed(places, palette.pit[index]!), material);
      mesh.renderOrder = -3;
      return mesh;
    });
    const lines = new LineSegments(
      placed(edges, palette.edge),
      new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false }),
    );
    lines.renderOrder = -2;
    return [...sides, lines];
  }
}

/** Faces of a pit as triangles that are seen from within, and its edges as lines, x y z after each other [m]. */
export interface Pit {
  floor: number[];
  walls: number[];
  edges: number[];
}

export function pitOf(hole: Hole, level: number): Pit {
  const [x0, x1] = hole.x;
  const [y0, y1] = hole.y;
  const rim: Vector[] = [
    [x0, y0, level],
    [x1, y0, level],
    [x1, y1, level],
    [x0, y1, level],
  ];
  const feet = rim.map(([x, y]): Vector => [x, y, hole.floor]);
  const floor = patch(feet[0]!, feet[1]!, feet[3]!);
  const walls: number[] = [];
  const edges: number[] = [];
  rim.forEach((corner, side) => {
    const next = (side + 1) % 4;
    walls.push(...patch(feet[next]!, feet[side]!, rim[next]!));
    edges.push(...line(corner, rim[next]!), ...line(feet[side]!, feet[next]!), ...line(feet[side]!, corner));
  });
  return { floor, walls, edges };
}

/** Clipping of materials to what is outside of holes. */
export function outsideOf(holes: readonly Hole[], origin: readonly number[]): Clipping {
  return holes.length > 0 ? { clippingPlanes: sidesOf(holes[0]!, origin, 1), clipIntersection: true } : {};
}

/** Clipping of materials to what is inside of a hole. */
export function insideOf(hole: Hole, origin: readonly number[]): Clipping {
  return { clippingPlanes: sidesOf(hole, origin, -1) };
}

export interface Clipping {
  clippingPlanes?: Plane[];
  clipIntersection?: boolean;
}

/** The four sides of a hole, about an origin; on their positive sides is what is outside (1) or inside (-1). */
function sidesOf(hole: Hole, origin: readonly number[], sign: 1 | -1): Plane[] {
  const [[x0, x1], [y0, y1]] = [hole.x, hole.y];
  const [ox, oy] = [origin[0]!, origin[1]!];
  return [
    new Plane(new Vector3(-sign, 0, 0), sign * (x0 - ox)),
    new Plane(new Vector3(sign, 0, 0), -sign * (x1 - ox)),
    new Plane(new Vector3(0, -sign, 0), sign * (y0 - oy)),
    new Plane(new Vector3(0, sign, 0), -sign * (y1 - oy)),
  ];
}

/** Holes that a room reaches over. */
export function holesUnder(header: Pick<Header, "holes">, low: Vector, high: Vector): Hole[] {
  return header.holes.filter(
    ({ x, y }) => low[0] < x[1] && high[0] > x[0] && low[1] < y[1] && high[1] > y[0],
  );
}

/** A parallelogram from a corner to two others, of many triangles. */
function patch(corner: Vector, one: Vector, other: Vector): number[] {
  const point = (i: number, j: number) =>
    corner.map(
      (value, axis) => value + (i * (one[axis]! - value)) / PIECES + (j * (other[axis]! - value)) / PIECES,
    );
  const places: number[] = [];
  for (let i = 0; i < PIECES; i++)
    for (let j = 0; j < PIECES; j++) {
      const [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
      places.push(...a, ...b, ...c, ...a, ...c, ...d);
    }
  return places;
}

function line(from: Vector, to: Vector): number[] {
  const places: number[] = [];
  for (let piece = 0; piece < PIECES; piece++)
    for (const end of [piece, piece + 1])
      places.push(...from.map((value, axis) => value + (end * (to[axis]! - value)) / PIECES));
  return places;
}
