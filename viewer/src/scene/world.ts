/** The drawn lift: bodies, ropes, arrows, ground, light; one call draws it as it is at a time. */

import {
  AmbientLight,
  ColorManagement,
  DirectionalLight,
  LinearSRGBColorSpace,
  PerspectiveCamera,
  Quaternion,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import type { Lift } from "../data/lift";
import type { Palette } from "../theme";
import { Arrows } from "./arrows";
import { Bodies } from "./bodies";
import { Clearances } from "./clearances";
import { Ground, holesUnder } from "./ground";
import { Ropes } from "./ropes";
import { Sea } from "./sea";
import { cornersOf, SIGN_HIGH } from "./solids";
import { Structures } from "./structures";

/** Pixels of the drawing for one of the page, along each side, while something moves and each costs much. */
const COARSE = 0.7;

/** Sizes of the largest load that count as the size of the scene for arrows, at most. */
const ROOM_OF_ARROWS = 4;

export interface Extent {
  middle: [number, number, number];
  size: number;
  low: [number, number, number];
  high: [number, number, number];
  /** Outermost places of what is drawn, x y z after each other, about the middle. */
  points: Float32Array;
}

export class World {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(32, 1, 0.1, 4000);
  readonly extent: Extent;
  /** Places that a view of all has to hold, x y z after each other, about the middle. */
  readonly outermost: Float32Array;
  readonly bodies: Bodies;
  readonly arrows: Arrows;
  readonly clearances: Clearances;
  readonly isSoftware: boolean;
  private readonly renderer: WebGLRenderer;
  private readonly ropes: Ropes;
  private readonly ambient = new AmbientLight();
  private readonly sun = new DirectionalLight();
  private readonly ground: Ground;
  private readonly sea: Sea;
  private readonly structures: Structures;
  private palette: Palette;
  private cheap = false;
  private coarse = false;
  private still = false;
  private width = 640;
  private height = 360;
  /** Whether edges are smoothed by the graphics card; software does without while much moves. */
  private readonly antialias: boolean;

  /** Throws where the browser cannot draw in three dimensions. */
  constructor(
    private readonly lift: Lift,
    canvas: HTMLCanvasElement,
    palette: Palette,
  ) {
    this.isSoftware = rendersInSoftware();
    this.antialias = !this.isSoftware;
    this.renderer = new WebGLRenderer({ canvas, antialias: this.antialias, alpha: true, stencil: true });
    // Colours are those of the page, and shall look like them.
    ColorManagement.enabled = false;
    this.renderer.localClippingEnabled = lift.header.holes.length > 0;
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.palette = palette;
    this.extent = extentOf(lift);
    const { middle, size } = this.extent;
    this.bodies = new Bodies(lift, middle, size);
    this.ropes = new Ropes(lift, middle);
    this.arrows = new Arrows(lift, middle, Math.min(size, ROOM_OF_ARROWS * sizeOfLoads(lift)));
    this.outermost = withTails(this.extent.points, lift, this.arrows);
    this.clearances = new Clearances(lift, middle);
    this.ground = new Ground(lift.header, this.extent);
    this.sea = new Sea(lift, this.extent);
    this.structures = new Structures(lift, middle);
    this.camera.up.set(0, 0, 1);
    this.camera.near = size / 500;
    this.camera.far = size * 40;
    this.sun.position.set(-0.5, -1, 1.6);
    this.scene.add(
      this.bodies.group,
      this.ropes.group,
      this.arrows.mesh,
      this.clearances.lines,
      this.ground.group,
      this.sea.group,
      this.structures.group,
      this.ambient,
      this.sun,
    );
    this.setPalette(palette);
    this.setCheap(this.isSoftware);
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.bodies.setPalette(palette);
    this.ropes.setPalette(palette);
    [this.ambient.intensity, this.sun.intensity] = palette.light;
    this.structures.setPalette(palette);
    this.ground.lay(palette);
    this.sea.lay(palette);
  }

  /** More has been recorded: supports may have been taken away meanwhile. */
  takeMore(): void {
    this.structures.build();
  }

  get isCheap(): boolean {
    return this.cheap;
  }

  /** The cheap style, which holds while something moves. */
  setCheap(isCheap: boolean): void {
    this.cheap = isCheap;
    this.style();
  }

  /** Fewer pixels as well, while something moves. */
  setCoarse(isCoarse: boolean): void {
    this.coarse = isCoarse;
    this.style();
  }

  /** Whether nothing moves for the moment: then even slow machines have time for a fine drawing. */
  setStill(isStill: boolean): void {
    if (isStill === this.still) return;
    this.still = isStill;
    if (this.cheap) this.style();
  }

  private style(): void {
    const isPlain = this.cheap && !this.still;
    this.ropes.setThin(isPlain);
    this.bodies.setCheap(isPlain);
    this.resize(this.width, this.height);
  }

  resize(width: number, height: number): void {
    [this.width, this.height] = [width, height];
    const fine = Math.min(2, globalThis.devicePixelRatio || 1);
    // Where edges are not smoothed, twice the pixels smooth them.
    const rough = this.coarse ? COARSE : 1;
    const ratio = this.cheap && !this.still ? rough : this.antialias ? fine : 2;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /** Draw the lift at its present time. */
  draw(pinned: string | null): void {
    const largest = this.lift.largestTension || 1;
    this.bodies.update();
    this.structures.update();
    this.sea.update(this.lift.now);
    this.ropes.update(this.palette, largest, pinned);
    if (this.arrows.mesh.visible) this.arrows.update(this.palette, largest);
    if (this.clearances.lines.visible) this.clearances.update(this.palette);
    this.renderer.render(this.scene, this.camera);
  }

  /** Where a point of the lift is on the canvas, in pixels of the page; null behind the camera. */
  project(x: number, y: number, z: number, width: number, height: number): [number, number] | null {
    const [ox, oy, oz] = this.extent.middle;
    POINT.set(x - ox, y - oy, z - oz).project(this.camera);
    if (POINT.z > 1) return null;
    return [((POINT.x + 1) / 2) * width, ((1 - POINT.y) / 2) * height];
  }

  /** Pixels that a metre across takes at a place. */
  scaleAt(x: number, y: number, z: number, height: number): number {
    const [ox, oy, oz] = this.extent.middle;
    const { z: away } = POINT.set(x - ox, y - oy, z - oz).applyMatrix4(this.camera.matrixWorldInverse);
    return height / 2 / Math.tan((this.camera.fov * Math.PI) / 360) / Math.max(-away, this.camera.near);
  }
}

const POINT = new Vector3();
const TURN = new Quaternion();

/** The room that the lift takes over all its frames. */
export function extentOf(lift: Lift): Extent {
  const low: [number, number, number] = [1e9, 1e9, 1e9];
  const high: [number, number, number] = [-1e9, -1e9, -1e9];
  const held: number[] = [];
  const hooks: number[] = [];
  const hold = (x: number, y: number, z: number) => {
    const point = [x, y, z];
    held.push(x, y, z);
    for (let axis = 0; axis < 3; axis++) {
      low[axis] = Math.min(low[axis]!, point[axis]!);
      high[axis] = Math.max(high[axis]!, point[axis]!);
    }
  };
  const corners = lift.header.bodies.map((body) => (body.shape ? cornersOf(body.shape, lift) : body.cog));
  atLooks(lift, () => {
    for (const { kind, first, count } of lift.header.ropes) {
      if (kind === "outer") continue; // they go far beyond what is lifted
      for (let at = 3 * first; at < 3 * (first + count); at += 3)
        hold(lift.path[at]!, lift.path[at + 1]!, lift.path[at + 2]!);
    }
    corners.forEach((points, index) => {
      const { cog } = lift.header.bodies[index]!;
      const pose = lift.poses.subarray(7 * index, 7 * index + 7);
      TURN.set(pose[4]!, pose[5]!, pose[6]!, pose[3]!);
      for (let at = 0; at < points.length; at += 3) {
        POINT.set(points[at]! - cog[0], points[at + 1]! - cog[1], points[at + 2]! - cog[2]).applyQuaternion(
          TURN,
        );
        hold(POINT.x + pose[0]!, POINT.y + pose[1]!, POINT.z + pose[2]!);
      }
      const { kind, shape } = lift.header.bodies[index]!;
      if (kind === "hook" && !shape) hooks.push(pose[0]!, pose[1]!, pose[2]!);
    });
  });
  if (low[0] > high[0]) {
    const points = new Float32Array([-5, -5, -5, 5, 5, 5]);
    return { middle: [0, 0, 0], size: 10, low: [-5, -5, -5], high: [5, 5, 5], points };
  }
  if (lift.header.water !== null) low[2] = Math.min(low[2], lift.header.water);
  else if (lift.header.ground !== null) {
    low[2] = Math.max(low[2], lift.header.ground);
    for (const hole of holesUnder(lift.header, low, high)) low[2] = Math.min(low[2], hole.floor);
  }
  const middle = low.map((value, axis) => (value + high[axis]!) / 2) as [number, number, number];
  const size = Math.max(Math.hypot(...low.map((value, axis) => high[axis]! - value)), 1);
  // Hooks without a size are drawn as signs, which stand higher than where they bear.
  for (let at = 0; at < hooks.length; at += 3)
    held.push(hooks[at]!, hooks[at + 1]!, hooks[at + 2]! + SIGN_HIGH * size);
  const points = Float32Array.from(
    held,
    (value, place) => (place % 3 === 2 ? Math.max(value, low[2]) : value) - middle[place % 3]!,
  );
  return { middle, size, low, high, points };
}

/** Look at a lift a few times from its start to its end, and leave it at its start. */
function atLooks(lift: Lift, look: () => void): void {
  const count = lift.frameTimes.length;
  for (let part = 0; part <= 8; part++) {
    lift.seek(lift.frameTimes[Math.round((part / 8) * (count - 1))] ?? 0);
    look();
  }
  lift.seek(lift.begin);
}

/** Places with where arrows of pushes begin: below the ground, where else nothing is that a view would hold. */
function withTails(points: Float32Array, lift: Lift, arrows: Arrows): Float32Array {
  const tails: number[] = [];
  atLooks(lift, () => tails.push(...arrows.tails()));
  const all = new Float32Array(points.length + tails.length);
  all.set(points);
  all.set(tails, points.length);
  return all;
}

/** The longest side of any load [m]; without end where none has a shape. */
function sizeOfLoads(lift: Lift): number {
  const sides = lift.header.bodies.flatMap(({ kind, shape }) => {
    if (kind !== "load" || !shape) return [];
    const corners = cornersOf(shape, lift);
    return [0, 1, 2].map((axis) => corners[21 + axis]! - corners[axis]!);
  });
  return sides.length > 0 ? Math.max(...sides) : Number.POSITIVE_INFINITY;
}

function rendersInSoftware(): boolean {
  const context = document.createElement("canvas").getContext("webgl");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  const name = String(context?.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : context.RENDERER));
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}
