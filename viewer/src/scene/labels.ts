/** Names beside what they name, as text above the drawing. */

import { forceText, shortenedInside, shown } from "../chart/scale";
import type { Lift } from "../data/lift";
import { element, set } from "../dom";
import { TOUCHING } from "./clearances";
import { type Box, settle } from "./settle";
import { cornersOf, PIN, SIGN_WIDE } from "./solids";
import type { World } from "./world";

/** Slings up to which each has its name; more of them would hide the lift. */
const MOST_SLINGS = 24;
const MOST_WITH_VALUES = 8;
const MOST_BODIES = 20;
const MOST_PAIRS = 8;
const LINE = 16; // pixels, as `.gl-label` has it
const PADDING = 10; // pixels, left and right together
const MOST_WIDE = 190; // pixels, from which a name is cut short
const BESIDE = 4; // pixels from a hook or hinge to its name
/** Slings of which less is seen have no name: it would cover them [pixels]. */
const SHORT = 48;

interface Label {
  root: HTMLElement;
  value: HTMLElement;
  name: string;
  rope: number;
  body: number;
  pair: number;
  /** From the middle of a hook or hinge to its side [m]. */
  aside: number;
  text: string;
  /** Where it is, as a style; empty while it is hidden. */
  way: string;
}

export class Labels {
  readonly root = element("div", { class: "gl-labels", "aria-hidden": "true" });
  private readonly labels: Label[] = [];
  private readonly slings: number;
  /** Measures text without a layout of the page. */
  private readonly ruler = document.createElement("canvas").getContext("2d");
  private knowsFont = false;

  constructor(
    private readonly lift: Lift,
    private readonly world: World,
  ) {
    const { ropes, bodies, pairs, hinges } = lift.header;
    this.slings = ropes.filter((rope) => rope.kind === "sling").length;
    // Where there is no room for all, the first ones have it.
    for (const kind of ["load", "hook", "frame"])
      bodies.forEach((body, index) => {
        if (body.kind === kind && this.labels.length < MOST_BODIES)
          this.add(shortenedInside(body.name), "gl-label gl-label-body", { body: index });
      });
    for (const { body } of hinges)
      this.add(shortenedInside(bodies[body]!.name), "gl-label gl-label-body", { body });
    pairs.slice(0, MOST_PAIRS).forEach((_, pair) => {
      this.add("", "gl-label gl-label-pair", { pair });
    });
    ropes.forEach((rope, index) => {
      if (rope.kind === "sling" && rope.count > 1 && this.slings <= MOST_SLINGS)
        this.add(shortenedInside(rope.label), "gl-label", { rope: index });
    });
  }

  private add(name: string, kind: string, of: Partial<Pick<Label, "rope" | "body" | "pair">>): void {
    const value = element("span", { class: "gl-label-value" });
    const root = element("div", { class: kind }, name, value);
    const aside = this.asideOf(of.body ?? -1);
    this.labels.push({ root, value, name, rope: -1, body: -1, pair: -1, aside, text: "", way: "", ...of });
    root.hidden = true;
    this.root.append(root);
  }

  private asideOf(index: number): number {
    if (this.lift.pinOf(index) !== "none") return PIN * this.world.extent.size;
    const body = this.lift.header.bodies[index];
    if (body?.kind !== "hook") return 0;
    if (!body.shape) return SIGN_WIDE * this.world.extent.size;
    const corners = cornersOf(body.shape, this.lift);
    return Math.hypot(corners[21]! - corners[0]!, corners[22]! - corners[1]!) / 2;
  }

  /** Put every name where it belongs now; `reserved` is taken by buttons and legend. */
  update(width: number, height: number, withValues: boolean, reserved: readonly Box[]): void {
    if (this.root.hidden) return;
    const taken = [...reserved];
    const hasValues = withValues && this.slings <= MOST_WITH_VALUES;
    if (this.ruler && !this.knowsFont) {
      this.ruler.font = `600 11px ${getComputedStyle(this.root).fontFamily}`;
      this.knowsFont = this.root.isConnected;
    }
    for (const label of this.labels) {
      const text = this.textOf(label, hasValues);
      const box = this.boxOf(label, text, width, height);
      if (!box || !settle(box, taken, width, height)) {
        if (label.way) label.root.hidden = true;
        label.way = "";
        continue;
      }
      taken.push(box);
      // On whole pixels: letters stay sharp, and what hardly moves costs nothing.
      const way = `translate(${Math.round(box.x)}px, ${Math.round(box.y)}px) translate(-50%, -50%)`;
      if (!label.way) label.root.hidden = false;
      if (way !== label.way) label.root.style.transform = way;
      label.way = way;
      if (text !== label.text) {
        label.text = text;
        label.value.textContent = text;
      }
    }
  }

  /** The room that a name takes at the place that it would have alone; null where it has none. */
  private boxOf(label: Label, text: string, width: number, height: number): Box | null {
    const place = this.placeOf(label, width, height);
    if (!place) return null;
    const wide = PADDING + (this.ruler?.measureText(label.name + text).width ?? 0);
    const box = { x: place[0], y: place[1], width: Math.min(MOST_WIDE, wide), height: LINE };
    if (label.aside > 0) {
      const at = 7 * label.body;
      const [x, y, z] = this.lift.poses.subarray(at, at + 3);
      const aside = BESIDE + label.aside * this.world.scaleAt(x!, y!, z!, height) + box.width / 2;
      box.x += box.x + aside + box.width / 2 < width ? aside : -aside;
    }
    return box;
  }

  private textOf(label: Label, hasValues: boolean): string {
    if (label.pair >= 0) {
      const isTooClose = this.lift.isTooClose(label.pair);
      set(label.root, { "data-close": isTooClose ? "" : undefined });
      const distance = this.lift.distance(label.pair);
      // Its colour alone would not tell everybody.
      return isTooClose
        ? tooClose(distance, this.lift.header.pairs[label.pair]!.smallest)
        : `${shown(distance, 2)} m`;
    }
    const tension = label.rope >= 0 ? this.lift.tensions[label.rope]! : -1;
    if (!hasValues || tension < 0) return "";
    return tension > 0 ? ` ${forceText(tension, this.lift.largestTension)}` : " slack";
  }

  private pointOf(index: number, width: number, height: number): [number, number] | null {
    const { path } = this.lift;
    const at = 3 * index;
    return this.world.project(path[at]!, path[at + 1]!, path[at + 2]!, width, height);
  }

  private placeOf(label: Label, width: number, height: number): [number, number] | null {
    if (label.pair >= 0) {
      const { nearest } = this.lift;
      const at = 6 * label.pair;
      if (!this.world.clearances.lines.visible || this.lift.lineOf(label.pair) < TOUCHING) return null;
      const middle = (axis: number) => (nearest[at + axis]! + nearest[at + 3 + axis]!) / 2;
      return this.world.project(middle(0), middle(1), middle(2), width, height);
    }
    if (label.body >= 0) {
      if (this.lift.pinOf(label.body) === "open") return null;
      const at = 7 * label.body;
      const { poses } = this.lift;
      return this.world.project(poses[at]!, poses[at + 1]!, poses[at + 2]!, width, height);
    }
    // Slings side by side: each label at another height, so that they do not lie upon each other.
    const rope = this.lift.header.ropes[label.rope]!;
    const place = (rope.count - 1) * (0.36 + 0.13 * (label.rope % 4));
    const [upper, lower] = [0, rope.count - 1].map((end) => this.pointOf(rope.first + end, width, height));
    if (!upper || !lower || Math.hypot(upper[0] - lower[0], upper[1] - lower[1]) < SHORT) return null;
    const piece = Math.min(rope.count - 2, Math.floor(place));
    const at = 3 * (rope.first + piece);
    const { path } = this.lift;
    const point = [0, 1, 2].map(
      (axis) => path[at + axis]! + (place - piece) * (path[at + 3 + axis]! - path[at + axis]!),
    );
    return this.world.project(point[0]!, point[1]!, point[2]!, width, height);
  }
}

/** A distance that is below the smallest one [m], with as many decimals as show that it is: two, or up to six. */
export function tooClose(distance: number, smallest: number): string {
  let digits = 2;
  while (digits < 6 && Number(distance.toFixed(digits)) >= smallest) digits += 1;
  return `${shown(distance, digits)} m < ${smallest} m`;
}
