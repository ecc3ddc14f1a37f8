/** Views of the lift: freely turned, from the side, from above, at the hook, at the load. */

import { type PerspectiveCamera, Quaternion, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Lift } from "../data/lift";
import { lensFrom, placeFor, type Room, WHOLE } from "./fit";
import { cornersOf, SIGN_HIGH } from "./solids";
import type { World } from "./world";

export const VIEWS = ["orbit", "side", "top", "hook", "load"] as const;
export type View = (typeof VIEWS)[number];

const NEAREST = 0.05; // of the size of the scene, which every view stays away

/** From where each looks, towards the camera. */
const WAYS: Record<View, Vector3> = {
  orbit: new Vector3(-0.62, -1, 0.3),
  side: new Vector3(0, -1, 0.0001),
  top: new Vector3(0, -0.0001, 1),
  hook: new Vector3(-0.6, -1, 0.12),
  load: new Vector3(-0.6, -1, 0.45),
};

export function isView(text: string): text is View {
  return (VIEWS as readonly string[]).includes(text);
}

export class Cameras {
  view: View = "orbit";
  /** Whether the camera is no longer where its view puts it. */
  isMoved = false;
  private isHeld = false;
  private readonly controls: OrbitControls;
  private readonly camera: PerspectiveCamera;
  private readonly followed = new Vector3();

  constructor(
    private readonly world: World,
    private readonly lift: Lift,
    element: HTMLElement,
    onChange: () => void,
  ) {
    this.camera = world.camera;
    this.controls = new OrbitControls(world.camera, element);
    this.controls.enableDamping = false;
    this.controls.zoomSpeed = 0.8;
    this.controls.addEventListener("start", () => (this.isHeld = true));
    this.controls.addEventListener("end", () => (this.isHeld = false));
    this.controls.addEventListener("change", () => {
      this.isMoved ||= this.isHeld;
      onChange();
    });
    // A page must scroll under a wheel or a finger that only passes by.
    this.controls.enableZoom = false;
    element.addEventListener("focusin", () => (this.controls.enableZoom = true));
    element.addEventListener("pointerdown", () => (this.controls.enableZoom = true));
    element.addEventListener("pointerleave", () => (this.controls.enableZoom = false));
    element.style.touchAction = ""; // as the style sheet has it
  }

  /** Which views this lift has. */
  available(): View[] {
    return VIEWS.filter((view) => (view === "hook" || view === "load" ? this.bodyOf(view) >= 0 : true));
  }

  /** Show a view, as large as the rooms of the drawing let it be. */
  show(view: View, rooms: readonly Room[] = [WHOLE]): void {
    this.view = this.available().includes(view) ? view : "orbit";
    this.isMoved = false;
    const target = new Vector3();
    const body = this.bodyOf(this.view);
    if (body >= 0) this.followed.copy(this.place(body, target));
    const lens = lensFrom(WAYS[this.view], this.camera.fov, this.camera.aspect);
    const points = this.pointsOf(this.view, body);
    // The nearest of the places that the rooms lead to has the largest picture.
    const places = rooms.map((room) => placeFor(points, lens, room, NEAREST * this.world.extent.size));
    const out = (place: Vector3) => place.clone().sub(target).dot(lens.back);
    const place = places.reduce((best, one) => (out(one) < out(best) ? one : best));
    this.camera.position.copy(place);
    // It turns about what it looks at.
    this.controls.target.copy(place).addScaledVector(lens.back, -out(place));
    this.controls.update();
  }

  /** What a view has to hold, x y z after each other, about the middle of the scene. */
  private pointsOf(view: View, body: number): ArrayLike<number> {
    const { size } = this.world.extent;
    if (body < 0) return this.world.outermost;
    const { x, y, z } = this.followed;
    const around = (low: number, wide: number, high: number) =>
      [-1, 1].flatMap((side) => [
        ...[x + side * wide * size, y, z + low * size],
        ...[x, y + side * wide * size, z + high * size],
      ]);
    // A hook with what hangs from it, a load with its lugs.
    if (view === "hook") return around(-0.22, 0.1, SIGN_HIGH);
    const { shape, cog } = this.lift.header.bodies[body]!;
    const corners = shape ? cornersOf(shape, this.lift) : [];
    const [, , , w, i, j, k] = this.lift.poses.subarray(7 * body, 7 * body + 7);
    const turn = new Quaternion(i, j, k, w);
    const middle = new Vector3(...cog);
    const held = around(-0.1, 0.1, 0.1);
    for (let at = 0; at < corners.length; at += 3)
      held.push(...CORNER.fromArray(corners, at).sub(middle).applyQuaternion(turn).add(this.followed));
    return held;
  }

  /** Move along with the body that is looked at. */
  follow(): void {
    const body = this.bodyOf(this.view);
    if (body < 0) return;
    const now = this.place(body, new Vector3());
    const moved = now.clone().sub(this.followed);
    this.followed.copy(now);
    this.controls.target.add(moved);
    this.camera.position.add(moved);
    this.camera.lookAt(this.controls.target);
  }

  /** Turn, or come nearer, by keys. */
  nudge(turn: number, lift: number, zoom: number): void {
    this.isMoved = true;
    const out = this.camera.position.clone().sub(this.controls.target);
    const reach = out.length() * zoom;
    const around = Math.atan2(out.y, out.x) + turn;
    const up = Math.min(1.55, Math.max(-1.55, Math.asin(out.z / out.length()) + lift));
    out
      .set(Math.cos(up) * Math.cos(around), Math.cos(up) * Math.sin(around), Math.sin(up))
      .multiplyScalar(reach);
    this.camera.position.copy(this.controls.target).add(out);
    this.controls.update();
  }

  /** Where the camera is and looks, for the address of the page; rounded to centimetres. */
  state(): number[] {
    const parts = [...this.camera.position.toArray(), ...this.controls.target.toArray()];
    return parts.map((part) => Math.round(100 * part) / 100);
  }

  restore(state: number[]): void {
    if (state.length !== 6 || state.some((part) => !Number.isFinite(part))) return;
    this.isMoved = true;
    const body = this.bodyOf(this.view);
    if (body >= 0) this.place(body, this.followed);
    this.camera.position.fromArray(state, 0);
    this.controls.target.fromArray(state, 3);
    this.controls.update();
  }

  private bodyOf(view: View): number {
    if (view !== "hook" && view !== "load") return -1;
    return this.lift.header.bodies.findIndex((body) => body.kind === view);
  }

  private place(body: number, out: Vector3): Vector3 {
    const [ox, oy, oz] = this.world.extent.middle;
    const at = 7 * body;
    return out.set(this.lift.poses[at]! - ox, this.lift.poses[at + 1]! - oy, this.lift.poses[at + 2]! - oz);
  }
}

const CORNER = new Vector3();
