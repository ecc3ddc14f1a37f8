/** The curves of a plot with their present values; a press switches one off and on. */

import type { Curve } from "../data/curve";
import { element, set } from "../dom";
import { Pace } from "../pace";
import type { Session } from "../player/session";
import { COLOURS, type Family } from "./families";
import type { ChartSpec } from "./frame";
import { shown, valueText } from "./scale";

const MOST_SHOWN = 100;
const READABLE = 120; // ms

export class Legend {
  readonly root: HTMLElement;
  /** Each ends one of its subscriptions. */
  readonly ends: (() => void)[];
  private readonly values: HTMLElement[] = [];
  private readonly buttons: HTMLButtonElement[] = [];
  private readonly texts: string[] = [];
  /** Of each family in a row of its own what its curves come to. */
  private readonly abouts: HTMLElement[] = [];
  private readonly pace = new Pace(READABLE);
  private readonly upon = element("span", { class: "gl-legend-family gl-quiet" });

  constructor(
    private readonly session: Session,
    private readonly curves: Curve[],
    families: Family[],
    private readonly spec: ChartSpec,
  ) {
    this.root = element("div", {
      class: "gl-legend",
      role: "group",
      "aria-label": `Curves of ${spec.title}`,
    });
    const areMany = curves.length > COLOURS;
    for (const { name, colour, members } of families) {
      const row = areMany ? element("div", { class: "gl-legend-family" }, swatch(colour)) : this.root;
      if (areMany) {
        const about = element("span", { class: "gl-quiet" });
        this.abouts.push(about);
        row.append(element("strong", {}, name), about);
        this.root.append(row);
      }
      // Of a family each curve has its colour, so that its name alone stands for it.
      for (const index of members.filter((one) => one < MOST_SHOWN))
        row.append(this.entry(index, ...(areMany ? [] : [swatch(colour)])));
    }
    if (curves.length > MOST_SHOWN)
      this.root.append(
        element("span", { class: "gl-legend-family" }, `and ${curves.length - MOST_SHOWN} more`),
      );
    this.root.append(this.upon);
    this.tellExtremes(families);
    this.ends = (["hidden", "pin"] as const).map((topic) => session.on(topic, () => this.showPressed()));
    this.showPressed();
  }

  /** What the curves of each family come to; families as in the constructor. */
  tellExtremes(families: Family[]): void {
    this.abouts.forEach((about, place) => {
      const { extremes } = families[place]!;
      about.textContent = extremes.map((index, rank) => this.extreme(this.curves[index]!, rank)).join(", ");
    });
  }

  /** Which curves lie upon each other, by the indices of each group. */
  tellAlike(groups: number[][]): void {
    const names = groups.map((group) => group.map((index) => this.curves[index]!.entry.label).join(", "));
    this.upon.hidden = names.length === 0;
    this.upon.textContent = names.length ? `upon each other, in dashes: ${names.join("; ")}` : "";
  }

  /** What the curve that counts most comes to, and when. */
  private extreme(curve: Curve, place: number): string {
    const { spec } = this;
    const isLargest = spec.extreme !== "smallest" && place === 0;
    const [value, time] = isLargest ? curve.top : [curve.least, curve.leastTime];
    const number = valueText(value, spec.unit, curve.top[0]);
    return `${isLargest ? "largest" : "smallest"} ${curve.entry.label} ${number} at ${shown(time, 1)} s`;
  }

  private entry(index: number, ...sign: Node[]): HTMLButtonElement {
    const curve = this.curves[index]!;
    const value = element("span", { class: "gl-legend-value" });
    const content = [...sign, curve.entry.label, value];
    const button = element("button", { type: "button", class: "gl-legend-entry" }, ...content);
    button.addEventListener("click", () => this.session.toggleHidden(keyOf(curve)));
    this.values[index] = value;
    this.buttons[index] = button;
    return button;
  }

  /** Values at a time; while the lift plays no more often than they can be read. */
  show(time: number): void {
    if (this.session.playing && !this.pace.isDue()) return;
    this.values.forEach((holder, index) => {
      const curve = this.curves[index]!;
      const { unit } = curve.entry;
      const text = curve.isKnownAt(time) ? valueText(curve.at(time), unit, curve.top[0]) : "–";
      if (this.texts[index] === text) return;
      this.texts[index] = text;
      holder.textContent = text;
    });
  }

  private showPressed(): void {
    this.buttons.forEach((button, index) => {
      const curve = this.curves[index]!;
      set(button, {
        "aria-pressed": String(!this.session.hidden.has(keyOf(curve))),
        "data-pinned": this.session.pinned === curve.entry.name ? "" : undefined,
      });
    });
  }
}

function swatch(colour: string): HTMLElement {
  const made = element("span", { class: "gl-swatch" });
  made.style.background = colour;
  return made;
}

function keyOf(curve: Curve): string {
  return `${curve.entry.group}:${curve.entry.name}`;
}
