/** Cursors and dots of a plot, in a layer of their own: while the lift plays nothing below is painted again. */

import { set, svg } from "../dom";
import type { Area } from "./frame";

export class Cursors {
  readonly root = svg("svg", { class: "gl-cursors", "aria-hidden": "true" });
  private readonly now = new Mark(svg("line", { class: "gl-cursor" }));
  private readonly pointer = new Mark(svg("line", { class: "gl-pointer" }));
  private readonly dots: Mark[];

  constructor(colours: string[]) {
    this.dots = colours.map((fill) => new Mark(svg("circle", { r: 3.2, fill, class: "gl-dot" })));
    this.root.append(...[this.pointer, this.now, ...this.dots].map((mark) => mark.element));
  }

  fit(width: number, height: number, area: Area): void {
    set(this.root, { viewBox: `0 0 ${width} ${height}`, width, height });
    for (const { element } of [this.now, this.pointer]) set(element, { y1: area.top - 6, y2: area.bottom });
  }

  /** Put both lines where they are [pixels]; null hides one. */
  place(now: number | null, pointer: number | null): void {
    this.now.place(now, 0);
    this.pointer.place(pointer, 0);
  }

  /** Put the dot of a curve where it is; `x` null hides it. */
  placeDot(index: number, x: number | null, y: number): void {
    this.dots[index]!.place(x, y);
  }
}

/** Something that only moves: a style, not an attribute, so that nothing is laid out anew. */
class Mark {
  private way = "";

  constructor(readonly element: SVGElement) {
    this.place(null, 0);
  }

  place(x: number | null, y: number): void {
    const way = x === null ? "none" : `translate(${x.toFixed(1)}px,${y.toFixed(1)}px)`;
    if (way === this.way) return;
    this.way = way;
    const { style } = this.element;
    const seen = x === null ? "hidden" : "visible";
    if (style.visibility !== seen) style.visibility = seen;
    if (x !== null) style.transform = way;
  }
}
