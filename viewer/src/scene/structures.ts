/** Supports, structures and the surface of water: boxes that stand in the world, until they are taken away. */

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
import type { Structure, Vector } from "../data/format";
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

export class Structures {
  readonly group = new Group();
  private readonly material = new MeshLambertMaterial({
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  /** What lies under it shows through. */
  private readonly water = new MeshLambertMaterial({
    transparent: true,
    opacity: 0.55,
    depthWrite: false,
  });
  private readonly edges = new LineBasicMaterial({ transparent: true, opacity: 0.5 });
  private readonly holders: { holder: Group; removedAt: number | null }[];

  constructor(
    private readonly lift: Lift,
    origin: readonly [number, number, number],
  ) {
    this.holders = lift.header.structures.map((one) => ({
      holder: this.holder(one, origin),
      removedAt: one.removedAt,
    }));
    for (const { holder } of this.holders) this.group.add(holder);
  }

  private holder(structure: Structure, origin: readonly [number, number, number]): Group {
    const holder = new Group();
    for (const corners of structure.boxes) {
      const geometry = boxOf(corners, origin);
      holder.add(
        new Mesh(geometry, structure.kind === "water" ? this.water : this.material),
        new LineSegments(new EdgesGeometry(geometry), this.edges),
      );
    }
    return holder;
  }

  setPalette(palette: Palette): void {
    this.material.color.set(palette.other);
    this.water.color.set(palette.water);
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
