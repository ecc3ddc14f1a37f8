/** Supports and structures: boxes that stand in the world, until they are taken away. */

import {
  BufferAttribute,
  BufferGeometry,
  EdgesGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Vector } from "../data/format";
import type { Lift } from "../data/lift";
import type { Palette } from "../theme";

/** Triangles of a box by its corners, z fastest, outwards. */
const FACES = [
  [0, 1, 3, 2],
  [4, 6, 7, 5],
  [0, 4, 5, 1],
  [2, 3, 7, 6],
  [0, 2, 6, 4],
  [1, 5, 7, 3],
].flatMap(([a, b, c, d]) => [a!, b!, c!, a!, c!, d!]);

/** Of what has more boxes, turned against each other since it is round, edges would be all that is seen from afar. */
const MOST_WITH_EDGES = 4;

export class Structures {
  readonly group = new Group();
  private readonly material = new MeshLambertMaterial({
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  private readonly edges = new LineBasicMaterial({ transparent: true, opacity: 0.5 });
  private holders: { holder: Group; removedAt: number | null }[] = [];

  constructor(
    private readonly lift: Lift,
    private readonly origin: readonly [number, number, number],
  ) {
    this.build();
  }

  /** Make what is drawn from what the lift knows now. */
  build(): void {
    const { lift, origin } = this;
    this.group.clear();
    // Those that stand equally long are one thing to draw.
    const times = new Set(lift.header.structures.map((one) => one.removedAt));
    this.holders = [...times].map((removedAt) => {
      const own = lift.header.structures.filter((one) => one.removedAt === removedAt);
      const made = own.map((one) => one.boxes.map((corners) => boxOf(corners, origin)));
      const edged = made.filter((boxes) => boxes.length <= MOST_WITH_EDGES);
      return { holder: this.holder(made.flat(), edged.flat()), removedAt };
    });
    for (const { holder } of this.holders) this.group.add(holder);
  }

  private holder(boxes: BufferGeometry[], edged: BufferGeometry[]): Group {
    const holder = new Group();
    if (boxes.length > 0) holder.add(new Mesh(mergeGeometries(boxes), this.material));
    if (edged.length > 0) {
      const edges = edged.map((box) => new EdgesGeometry(box));
      holder.add(new LineSegments(mergeGeometries(edges), this.edges));
    }
    return holder;
  }

  setPalette(palette: Palette): void {
    this.material.color.set(palette.other);
    this.edges.color.set(palette.edge);
  }

  /** Show what stands at the present time. */
  update(): void {
    for (const { holder, removedAt } of this.holders)
      holder.visible = removedAt === null || this.lift.now < removedAt;
  }
}

function boxOf(corners: readonly Vector[], origin: readonly number[]): BufferGeometry {
  const places = FACES.flatMap((corner) => corners[corner]!.map((value, axis) => value - origin[axis]!));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(places), 3));
  geometry.computeVertexNormals();
  return geometry;
}
