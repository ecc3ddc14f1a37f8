/** A plot over time, in step with the player and with all other plots of the page. */

import type { Curve } from "../data/curve";
import { element, set, svg } from "../dom";
import type { Session } from "../player/session";
import { alike, dashes, type Place, placesOf } from "./alike";
import { Cursors } from "./cursors";
import { COLOURS, type Family, familiesOf } from "./families";
import {
  type Area,
  areaOf,
  type ChartSpec,
  frameOf,
  liftOffName,
  limitNames,
  names,
  unfinished,
  xOf,
  yOf,
} from "./frame";
import { Legend } from "./legend";
import { type Box, crosses, endNames, type Paper, peakMark, roomOf } from "./marks";
import { type Scale, shown, valueText, verticalScale } from "./scale";

const HEADROOM = 1.1;
const WIDE = 560; // pixels from which there is room for names at the ends of curves
const UPON = 2; // pixels, width of curves that lie upon each other
const MOVED = 6; // pixels from which a press is a drag
let made = 0;

export class Chart {
  readonly curves: Curve[];
  private readonly svg = svg("svg", { tabindex: 0, class: "gl-plot" });
  private readonly frame = svg("g", {});
  private readonly lines = svg("g", { fill: "none" });
  private readonly brush = svg("rect", { class: "gl-brush" });
  private readonly marks = svg("g", {});
  private families: Family[];
  /** Curves that share colours, and with whom; each has one of its own where there are enough. */
  private readonly areMany: boolean;
  private readonly cursors: Cursors;
  private readonly tip = element("div", { class: "gl-tip", hidden: true, "aria-hidden": "true" });
  private readonly clip = `gl-clip-${made++}`;
  private readonly clipBox = svg("rect", {});
  private readonly legend: Legend;
  private scale: Scale = { low: 0, high: 1, ticks: [], digits: 0 };
  private area: Area = areaOf(720, 260, {}, this.scale);
  private width = 0;
  private readonly height: number;
  private press: number | null = null;
  private isOnScreen = true;
  private readonly ends: (() => void)[] = [];

  constructor(
    private readonly session: Session,
    private readonly spec: ChartSpec,
    private readonly root: HTMLElement,
  ) {
    this.height = spec.height ?? 260;
    const every = spec.groups.flatMap((group) => session.lift.group(group));
    this.curves = spec.only === undefined ? every : every.filter((curve) => curve.entry.name === spec.only);
    this.families = this.sorted();
    this.areMany = this.curves.length > COLOURS;
    this.legend = new Legend(session, this.curves, this.families, spec);
    const dots = this.areMany ? [] : this.curves;
    this.cursors = new Cursors(dots.map((_, index) => this.colour(index)));
    set(this.lines, { "clip-path": `url(#${this.clip})` });
    set(this.svg, { role: "img", "aria-label": this.inWords() });
    const clipPath = svg("clipPath", { id: this.clip }, this.clipBox);
    this.svg.append(svg("defs", {}, clipPath), this.frame, this.lines, this.marks, this.brush);
    const drawn = [this.svg, this.cursors.root] as unknown as Node[];
    const plot = element("div", { class: "gl-plot-holder" }, ...drawn, this.tip);
    root.append(plot, this.legend.root);
    this.listen();
    const sizes = new ResizeObserver(() => this.fit());
    // What nobody sees costs nothing while the lift plays.
    const sight = new IntersectionObserver((seen) => {
      this.isOnScreen = seen[seen.length - 1]?.isIntersecting ?? true;
      this.mark();
    });
    sizes.observe(plot);
    sight.observe(plot);
    this.ends.push(
      () => sizes.disconnect(),
      () => sight.disconnect(),
      ...this.legend.ends,
    );
    this.fit();
  }

  /** Take the plot off the page. */
  remove(): void {
    for (const end of this.ends) end();
    this.root.replaceChildren();
  }

  private sorted(): Family[] {
    return familiesOf(this.curves, this.spec.extreme ?? "largest");
  }

  /** More has been recorded: other curves may count most now, and come to more. */
  private takeMore(): void {
    this.families = this.sorted();
    this.legend.tellExtremes(this.families);
    set(this.svg, { "aria-label": this.inWords() });
    this.draw();
  }

  /** What the plot shows, for those who cannot see it. */
  private inWords(): string {
    const unit = this.spec.unit;
    const most = this.curves
      .map((curve) => {
        const [least, largest] = [curve.least, curve.top[0]].map((value) =>
          valueText(value, unit, curve.top[0]),
        );
        return `${curve.entry.label} from ${least} to ${largest}`;
      })
      .slice(0, 12);
    return `${this.spec.title} over time: ${most.join("; ")}. Arrow keys move the time, plus and minus zoom.`;
  }

  private fit(): void {
    const width = Math.max(260, Math.round(this.root.clientWidth || 720));
    if (width === this.width) return; // an observer tells of the first size too
    this.width = width;
    set(this.svg, { viewBox: `0 0 ${width} ${this.height}`, width, height: this.height });
    this.draw();
  }

  private timeAt(x: number): number {
    const [begin, end] = this.session.span;
    const { left, right } = this.area;
    return begin + ((x - left) / (right - left)) * (end - begin);
  }

  private x(time: number): number {
    return xOf(this.area, this.session.span, time);
  }

  private y(value: number): number {
    return yOf(this.area, this.scale, value);
  }

  private colour(index: number): string {
    return this.families.find((family) => family.members.includes(index))!.colour;
  }

  private isShown(curve: Curve): boolean {
    return !this.session.hidden.has(`${curve.entry.group}:${curve.entry.name}`);
  }

  private draw(): void {
    const visible = this.curves.filter((curve) => this.isShown(curve));
    const limits = (this.spec.limits ?? []).map((limit) => limit.value);
    // The name of the highest point stands above it.
    const tops = visible.map((curve) => (this.spec.peak ? HEADROOM * curve.top[0] : curve.largest));
    const values = [
      ...tops,
      ...visible.map((curve) => curve.least),
      ...limits,
      ...(this.spec.zero ? [0] : []),
    ];
    const wanted = this.height > 200 ? 5 : 3;
    this.scale = verticalScale(Math.min(...values), Math.max(...values), wanted, this.spec.smallest ?? 1e-9);
    const names = this.areMany && this.width >= WIDE ? roomOf(this.families, this.curves) : 0;
    this.area = areaOf(this.width, this.height, this.spec, this.scale, names);
    this.cursors.fit(this.width, this.height, this.area);
    set(this.clipBox, {
      x: this.area.left,
      y: this.area.top - 2,
      width: this.area.right - this.area.left,
      height: this.area.bottom - this.area.top + 4,
    });
    this.frame.replaceChildren(...frameOf(this.session, this.spec, this.area, this.scale));
    this.lines.replaceChildren();
    const rank = (index: number) => (this.countsMost(index) ? 1 : 0);
    const order = this.curves.map((_, index) => index);
    if (this.areMany) order.sort((one, other) => rank(one) - rank(other));
    const drawn = order.filter((index) => this.isShown(this.curves[index]!));
    // Of a family that has one colour only those are told apart that count most.
    const told = drawn.filter((index) => !this.areMany || this.countsMost(index));
    const groups = alike(
      new Map(told.map((index) => [index, this.curves[index]!])),
      this.session.span,
      (value) => this.y(value),
    );
    const places = placesOf(groups);
    for (const index of drawn) this.lines.append(this.path(this.curves[index]!, index, places.get(index)));
    this.legend.tellAlike(groups);
    this.write(visible);
    this.mark();
  }

  /** What is written upon the curves. */
  private write(visible: Curve[]): void {
    const { area, session } = this;
    const paper: Paper = { area, span: session.span, x: (time) => this.x(time), y: (value) => this.y(value) };
    const shownOnly = (family: Family): Family => ({
      ...family,
      extremes: family.extremes.filter((index) => this.isShown(this.curves[index]!)),
    });
    const hasRoom = this.areMany && this.width >= WIDE;
    const limits = limitNames(this.spec, area, this.scale);
    const isCrossed = (box: Box) => visible.some((curve) => crosses(curve, paper, box));
    const liftOff = liftOffName(session, area, limits, isCrossed);
    this.marks.replaceChildren(
      ...unfinished(session, area, limits),
      ...names(limits, liftOff),
      ...(hasRoom ? endNames(this.families.map(shownOnly), this.curves, paper) : []),
      ...(this.spec.peak ? peakMark(visible, this.spec.unit, paper, [...limits, ...liftOff]) : []),
    );
  }

  private countsMost(index: number): boolean {
    return this.families.some((family) => family.extremes.includes(index));
  }

  private path(curve: Curve, index: number, upon?: Place): SVGPathElement {
    const [begin, end] = this.session.span;
    const first = Math.max(0, curve.before(begin));
    const last = Math.min(curve.times.length - 1, curve.before(end) + 1);
    let way = "";
    let pen = "M";
    for (let place = first; place <= last; place++) {
      const value = curve.values[place]!;
      if (!Number.isNaN(value))
        way += `${pen}${this.x(curve.times[place]!).toFixed(1)} ${this.y(value).toFixed(1)}`;
      pen = Number.isNaN(value) ? "M" : "L";
    }
    const pinned = this.session.pinned;
    const mine = pinned === curve.entry.name;
    // Curves that lie upon each other: the first is the widest.
    const width = 2.6 - (1.2 * index) / Math.max(1, Math.min(this.curves.length, COLOURS) - 1);
    const among = this.countsMost(index) ? 2 : 0.8;
    const hasPinned = this.curves.some((one) => one.entry.name === pinned);
    return svg("path", {
      d: way,
      stroke: this.colour(index),
      "stroke-width": mine ? 3 : upon ? UPON : this.areMany ? among : width || 1.8,
      ...(upon && !mine ? dashes(upon) : {}),
      "stroke-linejoin": "round",
      opacity: hasPinned && !mine ? 0.25 : this.areMany && among < 1 && !mine ? 0.65 : 1,
    });
  }

  /** Cursors and values at the present time, or under the pointer. */
  private mark(): void {
    if (!this.isOnScreen) return;
    const { hover, time: now } = this.session;
    const [begin, end] = this.session.span;
    const within = (time: number | null) =>
      time !== null && time >= begin && time <= end ? this.x(time) : null;
    this.cursors.place(within(now), within(hover));
    const time = hover ?? now;
    this.legend.show(time);
    if (this.areMany) return;
    const x = within(time);
    this.curves.forEach((curve, index) => {
      const isDrawn = x !== null && this.isShown(curve) && curve.isKnownAt(time);
      this.cursors.placeDot(index, isDrawn ? x : null, isDrawn ? this.y(curve.at(time)) : 0);
    });
  }

  private listen(): void {
    for (const topic of ["time", "hover", "play"] as const)
      this.ends.push(this.session.on(topic, () => this.mark()));
    for (const topic of ["span", "pin", "hidden"] as const)
      this.ends.push(this.session.on(topic, () => this.draw()));
    this.ends.push(this.session.on("data", () => this.takeMore()));
    this.svg.addEventListener("pointermove", (event) => this.onMove(event));
    this.svg.addEventListener("pointerleave", () => this.leave());
    this.svg.addEventListener("pointerdown", (event) => {
      this.press = this.pixel(event);
      if (event.pointerType !== "mouse") this.session.seek(this.timeAt(this.press));
    });
    this.svg.addEventListener("pointerup", (event) => this.onUp(event));
    this.svg.addEventListener("dblclick", () => this.session.showAll());
    this.svg.addEventListener("keydown", (event) => this.onKey(event));
  }

  private pixel(event: PointerEvent): number {
    const box = this.svg.getBoundingClientRect();
    const x = ((event.clientX - box.left) / (box.width || 1)) * this.width;
    return Math.min(this.area.right, Math.max(this.area.left, x));
  }

  private onMove(event: PointerEvent): void {
    const x = this.pixel(event);
    if (event.pointerType !== "mouse") {
      if (this.press !== null) this.session.seek(this.timeAt(x));
      return;
    }
    this.session.pointAt(this.timeAt(x));
    this.showTip(event, x);
    const drags = this.press !== null && Math.abs(x - this.press) > MOVED;
    set(this.brush, { visibility: drags ? undefined : "hidden" });
    if (drags)
      set(this.brush, {
        x: Math.min(x, this.press!),
        y: this.area.top,
        width: Math.abs(x - this.press!),
        height: this.area.bottom - this.area.top,
      });
  }

  private onUp(event: PointerEvent): void {
    const x = this.pixel(event);
    if (this.press !== null && event.pointerType === "mouse") {
      if (Math.abs(x - this.press) > MOVED) this.session.show(this.timeAt(this.press), this.timeAt(x));
      else this.session.seek(this.timeAt(x));
    }
    this.press = null;
    set(this.brush, { visibility: "hidden" });
  }

  private leave(): void {
    this.press = null;
    this.tip.hidden = true;
    set(this.brush, { visibility: "hidden" });
    this.session.pointAt(null);
  }

  /** The curve that is nearest to the pointer, with its value. */
  private showTip(event: PointerEvent, x: number): void {
    const box = this.svg.getBoundingClientRect();
    const y = ((event.clientY - box.top) / (box.height || 1)) * this.height;
    const time = this.timeAt(x);
    const nearest = this.curves
      .filter((curve) => this.isShown(curve) && curve.isKnownAt(time))
      .map((curve) => ({ curve, off: Math.abs(this.y(curve.at(time)) - y) }))
      .sort((a, b) => a.off - b.off)[0];
    this.tip.hidden = !nearest;
    if (!nearest) return;
    const { unit } = this.spec;
    this.tip.replaceChildren(
      element("strong", {}, nearest.curve.entry.label),
      ` ${valueText(nearest.curve.at(time), unit, nearest.curve.top[0])}`,
      element("span", { class: "gl-quiet" }, ` at ${shown(time, 2)} s`),
    );
    const isRight = x > this.width * 0.6;
    this.tip.style.left = isRight ? "" : `${(x / this.width) * box.width + 12}px`;
    this.tip.style.right = isRight ? `${box.width - (x / this.width) * box.width + 12}px` : "";
    this.tip.style.top = `${Math.max(0, (y / this.height) * box.height - 34)}px`;
  }

  private onKey(event: KeyboardEvent): void {
    const [begin, end] = this.session.span;
    const span = end - begin;
    const time = this.session.time;
    const zoom = (factor: number) =>
      this.session.show(time - (time - begin) * factor, time + (end - time) * factor);
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.session.seek(time - span * (event.shiftKey ? 0.1 : 0.01)),
      ArrowRight: () => this.session.seek(time + span * (event.shiftKey ? 0.1 : 0.01)),
      Home: () => this.session.seek(begin),
      End: () => this.session.seek(end),
      "+": () => zoom(0.5),
      "=": () => zoom(0.5),
      "-": () => zoom(2),
      Escape: () => this.session.showAll(),
      " ": () => this.session.toggle(),
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  }
}
