/** Loads, frames, hooks, sheaves and whatever else has a shape, put where the lift has them. */

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  EdgesGeometry,
  EqualStencilFunc,
  Group,
  IncrementStencilOp,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type Object3D,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import type { Body } from "../data/format";
import type { Lift } from "../data/lift";
import type { Palette } from "../theme";
import { type Clipping, insideOf, outsideOf } from "./ground";
import {
  geometryOf,
  hingeGeometry,
  hookGeometry,
  hullOf,
  PIN,
  plainSheaveGeometry,
  SIGN,
  sheaveGeometry,
} from "./solids";

const MANY_LUGS = 40; // from which each is drawn with few triangles
const CREASE = 25; // degrees between faces from which an edge is drawn
const Z = new Vector3(0, 0, 1);

/** Frames are seen through: ropes and sheaves run inside. */
const OPACITY: Record<string, number> = { frame: 0.45 };

export class Bodies {
  readonly group = new Group();
  /** One for each body, whose frame is that of the body at its centre of gravity. */
  readonly holders: Object3D[];
  private readonly materials = new Map<string, MeshLambertMaterial>();
  /** Of the marks of hinges, which are seen through the loads that they hold. */
  private readonly pins = new MeshBasicMaterial({ depthTest: false, transparent: true });
  private readonly edges = new LineBasicMaterial({ transparent: true, opacity: 0.75 });
  /** Of the shadows on the ground, and on the floor of each hole, with their levels. */
  private readonly shadowOn: { material: MeshBasicMaterial; level: number }[];
  private readonly shadows: Shadow[] = [];
  private readonly sheaves: InstancedMesh | null;
  private readonly sheaveShapes: Choice;
  /** Each sheave in the frame of its body, before it has turned. */
  private readonly upright: Matrix4[];

  constructor(
    private readonly lift: Lift,
    private readonly origin: readonly [number, number, number],
    private readonly size: number,
  ) {
    const { ground, holes } = lift.header;
    this.shadowOn = ground === null ? [] : [shadowOn(ground, outsideOf(holes, origin))];
    for (const hole of holes) this.shadowOn.push(shadowOn(hole.floor, insideOf(hole, origin)));
    this.holders = lift.header.bodies.map((body, index) => this.holder(body, index));
    const { sheaves } = lift.header;
    this.sheaveShapes = [sheaveGeometry(), plainSheaveGeometry()];
    this.sheaves =
      sheaves.length > 0
        ? new InstancedMesh(this.sheaveShapes[0], this.material("sheave"), sheaves.length)
        : null;
    this.upright = sheaves.map((sheave) => {
      const { cog } = lift.header.bodies[sheave.body]!;
      PLACE.set(sheave.centre[0] - cog[0], sheave.centre[1] - cog[1], sheave.centre[2] - cog[2]);
      TURN.setFromUnitVectors(Z, AXIS.fromArray(sheave.axis).normalize());
      return new Matrix4().compose(PLACE, TURN, SCALE.setScalar(sheave.radius));
    });
    if (this.sheaves) {
      this.sheaves.frustumCulled = false;
      this.group.add(this.sheaves);
    }
    this.addLugs();
    // A holder is put in place at every frame; what it holds stays where it is in it.
    for (const holder of this.holders) {
      holder.matrixAutoUpdate = false;
      for (const part of holder.children) {
        part.updateMatrix();
        part.matrixAutoUpdate = false;
      }
      if (holder.children.length > 0) this.group.add(holder);
    }
  }

  private material(kind: string): MeshLambertMaterial {
    let found = this.materials.get(kind);
    if (!found) {
      const opacity = OPACITY[kind] ?? 1;
      found = new MeshLambertMaterial({
        opacity,
        transparent: opacity < 1,
        depthWrite: opacity === 1,
        side: DoubleSide,
        polygonOffset: true,
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 1,
      });
      this.materials.set(kind, found);
    }
    return found;
  }

  private holder(body: Body, index: number): Object3D {
    const holder = new Group();
    const [x, y, z] = body.cog;
    const geometry = this.shapeOf(body, index);
    if (geometry) {
      geometry.translate(-x, -y, -z);
      const isPin = this.lift.pinOf(index) !== "none";
      const mesh = new Mesh(geometry, isPin ? this.pins : this.material(kindOf(body)));
      if (isPin) mesh.renderOrder = 2;
      holder.add(mesh);
      if (!isPin) holder.add(new LineSegments(new EdgesGeometry(geometry, CREASE), this.edges));
      if (body.kind === "load") this.addShadows(geometry, index);
    }
    if (body.kind === "frame" && body.shape?.type === "box") holder.add(this.hangers(body));
    return holder;
  }

  private addShadows(geometry: BufferGeometry, body: number): void {
    const shapes: Shadow["shapes"] = [geometry, null];
    for (const { material, level } of this.shadowOn) {
      const mesh = new Mesh(geometry, material);
      mesh.matrixAutoUpdate = false;
      mesh.frustumCulled = false;
      this.shadows.push({ mesh, body, level, shapes });
      this.group.add(mesh);
    }
  }

  private shapeOf(body: Body, index: number): BufferGeometry | null {
    if (body.shape) return geometryOf(body.shape, this.lift);
    if (this.lift.pinOf(index) !== "none") return hingeGeometry().scale(...cube(PIN * this.size));
    if (body.kind === "hook") return hookGeometry().scale(...cube(SIGN * this.size));
    const hasSheave = this.lift.header.sheaves.some(
      (sheave) => this.lift.header.bodies[sheave.body] === body,
    );
    return hasSheave ? null : new SphereGeometry(0.008 * this.size, 16, 10);
  }

  /** Lines from the bearing of its hook to the upper edge of a frame. */
  private hangers(body: Body): LineSegments {
    const shape = body.shape as { size: number[]; centre: number[] };
    const top = shape.centre[2]! + shape.size[2]! / 2;
    const points: number[] = [];
    for (const end of [-0.36, 0.36])
      points.push(0, 0, 0, shape.centre[0]! + end * shape.size[0]!, shape.centre[1]!, top);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
    geometry.translate(-body.cog[0], -body.cog[1], -body.cog[2]);
    return new LineSegments(geometry, this.edges);
  }

  private addLugs(): void {
    const { lugs, bodies } = this.lift.header;
    const [around, up] = lugs.length > MANY_LUGS ? [6, 4] : [12, 8];
    const geometry = new SphereGeometry(0.0055 * this.size, around, up);
    for (const body of new Set(lugs.map((lug) => lug.body))) {
      const own = lugs.filter((lug) => lug.body === body);
      const mesh = new InstancedMesh(geometry, this.material("lug"), own.length);
      const { cog } = bodies[body]!;
      own.forEach(({ at }, index) => {
        mesh.setMatrixAt(index, LOCAL.makeTranslation(at[0] - cog[0], at[1] - cog[1], at[2] - cog[2]));
      });
      mesh.frustumCulled = false;
      this.holders[body]!.add(mesh);
    }
  }

  setPalette(palette: Palette): void {
    for (const [kind, material] of this.materials)
      material.color.set((palette as unknown as Record<string, number>)[kind] ?? palette.load);
    this.edges.color.set(palette.edge);
    this.pins.color.set(palette.pinned);
    for (const { material } of this.shadowOn) material.color.set(palette.shadow);
  }

  /** Cheap: sheaves without holes, shadows of convex outlines, edges that hide what is behind them. */
  setCheap(isCheap: boolean): void {
    this.edges.opacity = isCheap ? 1 : 0.75;
    this.edges.transparent = !isCheap;
    const which = isCheap ? 1 : 0;
    if (this.sheaves) this.sheaves.geometry = this.sheaveShapes[which];
    for (const { mesh, shapes } of this.shadows) {
      if (isCheap) shapes[1] ??= hullOf(shapes[0]);
      mesh.geometry = shapes[which] ?? shapes[0];
    }
  }

  update(): void {
    const poses = this.lift.poses;
    const [ox, oy, oz] = this.origin;
    for (let body = 0; body < this.holders.length; body++) {
      const at = 7 * body;
      const holder = this.holders[body]!;
      holder.position.set(poses[at]! - ox, poses[at + 1]! - oy, poses[at + 2]! - oz);
      holder.quaternion.set(poses[at + 4]!, poses[at + 5]!, poses[at + 6]!, poses[at + 3]!);
      holder.updateMatrix();
      holder.matrixWorldNeedsUpdate = true;
    }
    for (const { body } of this.lift.header.hinges)
      this.holders[body]!.visible = this.lift.pinOf(body) === "shut";
    this.turnSheaves();
    for (const { mesh, body, level } of this.shadows) {
      FLAT.makeScale(1, 1, 0).setPosition(0, 0, level - oz + 0.0008 * this.size);
      mesh.matrix.multiplyMatrices(FLAT, this.holders[body]!.matrix);
      mesh.matrixWorldNeedsUpdate = true;
    }
  }

  private turnSheaves(): void {
    if (!this.sheaves) return;
    const { sheaves } = this.lift.header;
    for (let index = 0; index < sheaves.length; index++) {
      LOCAL.makeRotationZ(this.lift.sheaveAngles[index]!).premultiply(this.upright[index]!);
      LOCAL.premultiply(this.holders[sheaves[index]!.body]!.matrix);
      this.sheaves.setMatrixAt(index, LOCAL);
    }
    this.sheaves.instanceMatrix.needsUpdate = true;
  }
}

/** Two geometries of one thing: the usual one, and that of the cheap style. */
type Choice = [BufferGeometry, BufferGeometry];

interface Shadow {
  mesh: Mesh;
  body: number;
  level: number;
  /** As in `Choice`; the second is made when it is first needed. */
  shapes: [BufferGeometry, BufferGeometry | null];
}

const FLAT = new Matrix4();
const LOCAL = new Matrix4();
const PLACE = new Vector3();
const AXIS = new Vector3();
const SCALE = new Vector3();
const TURN = new Quaternion();

/** A shadow is as dark where several faces of a load lie over each other as where there is one. */
function shadowOn(level: number, clipping: Clipping): { material: MeshBasicMaterial; level: number } {
  const material = new MeshBasicMaterial({
    transparent: true,
    opacity: 0.13,
    depthWrite: false,
    side: DoubleSide,
    stencilWrite: true,
    stencilFunc: EqualStencilFunc,
    stencilRef: 0,
    stencilZPass: IncrementStencilOp,
    ...clipping,
  });
  return { material, level };
}

function kindOf(body: Body): string {
  return ["load", "frame", "hook", "hull"].includes(body.kind) ? body.kind : "other";
}

function cube(size: number): [number, number, number] {
  return [size, size, size];
}
