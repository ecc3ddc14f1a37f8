/** Names beside what they name, as text above the drawing. */

import type { Lift } from "../data/lift";
import { element } from "../dom";
import type { World } from "./world";

/** Slings up to which each has its name; more of them would hide the lift. */
const MOST_SLINGS = 24;
const MOST_WITH_VALUES = 8;
const MOST_BODIES = 20;

interface Label {
  root: HTMLElement;
  value: HTMLElement;
  rope: number;
  body: number;
  text: string;
}

export class Labels {
  readonly root = element("div", { class: "gl-labels", "aria-hidden": "true" });
  private readonly labels: Label[] = [];
  private readonly slings: number;

  constructor(
    private readonly lift: Lift,
    private readonly world: World,
  ) {
    const { ropes, bodies } = lift.header;
    this.slings = ropes.filter((rope) => rope.kind === "sling").length;
    ropes.forEach((rope, index) => {
      if (rope.kind === "sling" && rope.count > 1 && this.slings <= MOST_SLINGS)
        this.add(rope.label, index, -1);
    });
    bodies.forEach((body, index) => {
      if (["load", "hook", "frame"].includes(body.kind) && this.labels.length < MOST_SLINGS + MOST_BODIES)
        this.add(body.name, -1, index);
    });
  }

  private add(name: string, rope: number, body: number): void {
    const value = element("span", { class: "gl-label-value" });
    const root = element("div", { class: rope >= 0 ? "gl-label" : "gl-label gl-label-body" }, name, value);
    this.labels.push({ root, value, rope, body, text: "" });
    this.root.append(root);
  }

  update(width: number, height: number, withValues: boolean): void {
    if (this.root.hidden) return;
    const placed: [number, number][] = [];
    const hasValues = withValues && this.slings <= MOST_WITH_VALUES;
    for (const label of this.labels) {
      const place = this.placeOf(label, width, height);
      label.root.hidden = place === null;
      if (!place) continue;
      const isFree = dodge(place, placed, label.rope < 0 ? 70 : hasValues ? 84 : 30);
      label.root.hidden = label.rope >= 0 && !isFree;
      if (label.root.hidden) continue;
      placed.push(place);
      label.root.style.transform = `translate(${place[0].toFixed(1)}px, ${place[1].toFixed(1)}px) translate(-50%, -50%)`;
      const tension = label.rope >= 0 ? this.lift.tensions[label.rope]! : -1;
      const text =
        hasValues && tension >= 0 ? (tension > 0 ? ` ${Math.round(tension / 1e3)} kN` : " slack") : "";
      if (text !== label.text) {
        label.text = text;
        label.value.textContent = text;
      }
    }
  }

  private placeOf(label: Label, width: number, height: number): [number, number] | null {
    if (label.body >= 0) {
      const at = 7 * label.body;
      const { poses } = this.lift;
      const place = this.world.project(poses[at]!, poses[at + 1]!, poses[at + 2]!, width, height);
      // A hook's name stands beside it.
      if (place && this.lift.header.bodies[label.body]!.kind === "hook") place[0] += 52;
      return place;
    }
    // Slings side by side: each label at another height, so that they do not lie upon each other.
    const rope = this.lift.header.ropes[label.rope]!;
    const place = (rope.count - 1) * (0.36 + 0.13 * (label.rope % 4));
    const piece = Math.min(rope.count - 2, Math.floor(place));
    const at = 3 * (rope.first + piece);
    const { path } = this.lift;
    const point = [0, 1, 2].map(
      (axis) => path[at + axis]! + (place - piece) * (path[at + 3 + axis]! - path[at + axis]!),
    );
    return this.world.project(point[0]!, point[1]!, point[2]!, width, height);
  }
}

const LINE = 18; // pixels

/** Move a place down until it is free of those that are taken; false where that would be too far. */
function dodge(place: [number, number], taken: readonly [number, number][], wide: number): boolean {
  for (let round = 0; round < 3; round++) {
    const other = taken.find(
      (one) => Math.abs(one[0] - place[0]) < wide && Math.abs(one[1] - place[1]) < LINE,
    );
    if (!other) return true;
    place[1] = other[1] + LINE;
  }
  return false;
}
