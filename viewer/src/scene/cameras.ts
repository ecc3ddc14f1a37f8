/** Views of the lift: freely turned, from the side, from above, at the hook, at the load. */

import { type PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Lift } from "../data/lift";
import type { World } from "./world";

export const VIEWS = ["orbit", "side", "top", "hook", "load"] as const;
export type View = (typeof VIEWS)[number];

export function isView(text: string): text is View {
  return (VIEWS as readonly string[]).includes(text);
}

export class Cameras {
  view: View = "orbit";
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
    this.controls.addEventListener("change", onChange);
    // A page must scroll under a wheel or a finger that only passes by.
    this.controls.enableZoom = false;
    element.addEventListener("focusin", () => (this.controls.enableZoom = true));
    element.addEventListener("pointerdown", () => (this.controls.enableZoom = true));
    element.addEventListener("pointerleave", () => (this.controls.enableZoom = false));
    element.style.touchAction = "pan-y";
  }

  /** Which views this lift has. */
  available(): View[] {
    return VIEWS.filter((view) => (view === "hook" || view === "load" ? this.bodyOf(view) >= 0 : true));
  }

  show(view: View): void {
    this.view = this.available().includes(view) ? view : "orbit";
    const { size, low, high } = this.world.extent;
    const target = new Vector3();
    const way = new Vector3();
    let reach = size;
    const body = this.bodyOf(this.view);
    if (body >= 0) {
      this.place(body, target);
      this.followed.copy(target);
      way.set(-0.6, -1, this.view === "hook" ? 0.12 : 0.45);
      reach = this.view === "hook" ? 0.5 * size : 0.75 * size;
      if (this.view === "hook") target.z -= 0.12 * size;
    } else if (this.view === "side") way.set(0, -1, 0.0001);
    else if (this.view === "top") way.set(0, -0.0001, 1);
    else way.set(-0.62, -1, 0.3);
    if (body < 0) {
      const spans = [high[0] - low[0], high[1] - low[1], high[2] - low[2]] as const;
      const wide =
        this.view === "side" ? spans[0] : this.view === "top" ? spans[0] : Math.hypot(spans[0], spans[1]);
      const tall = this.view === "top" ? spans[1] : this.view === "side" ? spans[2] : spans[2] + 0.25 * wide;
      const half = Math.tan((this.camera.fov * Math.PI) / 360);
      const deep = this.view === "top" ? spans[2] / 2 : spans[1] / 2;
      // A narrow drawing has its buttons above the lift, not beside it.
      const room = this.camera.aspect < 1 ? 1.4 : 1.04;
      reach = room * Math.max(tall / 2 / half, wide / 2 / half / this.camera.aspect) + deep;
      target.set(0, 0, 0);
    }
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(way.normalize(), reach);
    this.controls.update();
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
