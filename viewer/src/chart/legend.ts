/** The curves of a plot with their present values; a press switches one off and on. */

import type { Curve } from "../data/curve";
import { element, set } from "../dom";
import { Pace } from "../pace";
import type { Session } from "../player/session";
import { digitsOf, shown } from "./scale";

const MOST_SHOWN = 40;
const READABLE = 120; // ms

export class Legend {
  readonly root: HTMLElement;
  /** Each ends one of its subscriptions. */
  readonly ends: (() => void)[];
  private readonly values: HTMLElement[] = [];
  private readonly buttons: HTMLButtonElement[] = [];
  private readonly texts: string[] = [];
  private readonly pace = new Pace(READABLE);

  constructor(
    private readonly session: Session,
    private readonly curves: Curve[],
    colour: (index: number) => string,
    title: string,
  ) {
    this.root = element("div", { class: "gl-legend", role: "group", "aria-label": `Curves of ${title}` });
    curves.slice(0, MOST_SHOWN).forEach((curve, index) => {
      const value = element("span", { class: "gl-legend-value" });
      const swatch = element("span", { class: "gl-swatch" });
      swatch.style.background = colour(index);
      const button = element(
        "button",
        { type: "button", class: "gl-legend-entry" },
        swatch,
        curve.entry.label,
        value,
      );
      button.addEventListener("click", () => session.toggleHidden(keyOf(curve)));
      this.values.push(value);
      this.buttons.push(button);
      this.root.append(button);
    });
    if (curves.length > MOST_SHOWN)
      this.root.append(element("span", {}, `and ${curves.length - MOST_SHOWN} more`));
    this.ends = (["hidden", "pin"] as const).map((topic) => session.on(topic, () => this.showPressed()));
    this.showPressed();
  }

  /** Values at a time; while the lift plays no more often than they can be read. */
  show(time: number): void {
    if (this.session.playing && !this.pace.isDue()) return;
    this.values.forEach((holder, index) => {
      const { entry } = this.curves[index]!;
      const text = `${shown(this.curves[index]!.at(time), digitsOf(entry.unit))} ${entry.unit}`.trim();
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

function keyOf(curve: Curve): string {
  return `${curve.entry.group}:${curve.entry.name}`;
}
