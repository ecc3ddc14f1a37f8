/** What the pinned rope carries: now, at most, of its strength, and its curve. */

import { Chart } from "../chart/chart";
import { forceText, shown } from "../chart/scale";
import { element, ICONS } from "../dom";
import { button } from "./bar";
import type { Session } from "./session";

export class Pinned {
  readonly root = element("section", { class: "gl-pinned", hidden: true, "aria-label": "Pinned rope" });
  private readonly value = element("strong", { class: "gl-pinned-value" });
  private readonly most = element("span", { class: "gl-quiet" });
  private chart: Chart | null = null;
  private text = "";

  constructor(
    private readonly session: Session,
    /** What takes the keys when it goes; else they would be lost. */
    private readonly heir: HTMLElement,
  ) {
    session.on("pin", () => this.show());
    session.on("time", () => this.showValue());
    session.on("data", () => this.showMost());
  }

  private show(): void {
    const rope = this.session.lift.header.ropes.find((one) => one.name === this.session.pinned);
    const hasKeys = this.root.contains(document.activeElement);
    this.root.hidden = !rope;
    this.chart?.remove();
    this.chart = null;
    this.root.replaceChildren();
    if (hasKeys) this.heir.focus({ preventScroll: true });
    if (!rope) return;
    const lug = this.session.lift.header.lugs.find((one) => one.rope === rope.name);
    const close = button("Let go of this rope", ICONS.close, () => this.session.pin(null));
    const head = element(
      "div",
      { class: "gl-pinned-head" },
      element("span", { class: "gl-pinned-name" }, rope.name, lug ? ` at lug ${lug.name}` : ""),
      this.value,
      this.most,
      close,
    );
    const holder = element("div", { class: "gl-pinned-plot" });
    this.root.append(head, holder);
    const spec = {
      title: `Tension of ${rope.name}`,
      groups: ["tension"],
      only: rope.name,
      unit: "kN",
      height: 150,
    };
    this.chart = new Chart(this.session, spec, holder);
    this.text = "";
    this.showMost();
    this.showValue();
  }

  /** What it carries at most: of a lift that runs, so far. */
  private showMost(): void {
    const rope = this.session.lift.header.ropes.find((one) => one.name === this.session.pinned);
    if (!rope) return;
    const share = rope.used === null ? "" : `, ${shown(100 * rope.used, 1)} % of its minimum breaking force`;
    this.most.textContent = `at most ${forceText(rope.peak, rope.peak, 1)} at ${shown(rope.peakTime, 2)} s${share}`;
  }

  private showValue(): void {
    const { lift, pinned, time } = this.session;
    const curve = lift.group("tension").find((one) => one.entry.name === pinned);
    if (!curve) return;
    // As far as its peak is told; the curve is in kN.
    const { peak } = lift.header.ropes.find((one) => one.name === pinned)!;
    const text = forceText(1e3 * curve.at(time), peak, 1);
    if (text === this.text) return;
    this.text = text;
    this.value.textContent = text;
  }
}
