/** The drawing with what lies on it: views, legend, names, switches; it draws when something has changed. */

import { forceText, shown } from "../chart/scale";
import { element, set } from "../dom";
import { Pace } from "../pace";
import { Cameras, type View } from "../scene/cameras";
import { type Room, roomsBetween } from "../scene/fit";
import { Labels } from "../scene/labels";
import { ropeAt } from "../scene/picking";
import type { Box } from "../scene/settle";
import { World } from "../scene/world";
import { cssColour, currentTheme, onTheme, paletteOf, rampGradient, type Theme } from "../theme";
import { onPaper } from "./paper";
import type { Session } from "./session";

const SLOW = 60; // ms between frames from which ropes are drawn in the cheap style
const VERY_SLOW = 90; // ms between frames of the cheap style from which it has fewer pixels
const READABLE = 50; // ms between frames in which names move along, as long as only the lift moves
const STILL = 250; // ms without a change from which nothing moves
const TITLES: Record<View, string> = {
  orbit: "Whole lift (1)",
  side: "From the side (2)",
  top: "From above (3)",
  hook: "At the hook (4)",
  load: "At the load (5)",
};

export class Stage {
  readonly root = element("div", { class: "gl-stage" });
  readonly canvas = element("canvas", {
    class: "gl-canvas",
    role: "img",
    "aria-label":
      "The lift, drawn to scale. Up, down and Shift with left, right turn it, plus and minus zoom, 1 to 5 change the view.",
  });
  readonly world: World;
  readonly cameras: Cameras;
  private readonly labels: Labels;
  private readonly views = new Map<View, HTMLButtonElement>();
  private readonly ramp = element("div", { class: "gl-ramp" });
  private readonly slack = element("span", { class: "gl-slack-line" });
  private readonly step = element("div", { class: "gl-step-now" });
  private readonly cheapSign: HTMLButtonElement;
  /** The switches by their keys. */
  readonly switchOf: Record<string, HTMLButtonElement> = {};
  private needsDrawing = true;
  private readonly pace = new Pace(READABLE);
  private needsLabels = true;
  private withValues = true;
  /** What lies on the drawing, so that names keep off it. */
  private readonly overlays: HTMLElement[];
  private reserved: Box[] = [];
  private width = 640;
  private height = 360;
  private lastFrame = 0;
  private drawnAt = 0;
  /** Whether what is shown was drawn while something moved. */
  private isRough = true;
  private frameTimes: number[] = [];
  /** Frames drawn so far, and the mean time between the last ones while playing [ms]. */
  readonly measured = { count: 0, frame: 0 };

  constructor(private readonly session: Session) {
    const { lift } = session;
    this.root.append(this.canvas);
    this.world = new World(lift, this.canvas, paletteOf("light"));
    this.cameras = new Cameras(this.world, lift, this.canvas, () => this.redraw());
    this.labels = new Labels(lift, this.world);
    this.cheapSign = this.toggle(
      "Thin ropes",
      "Thin ropes while something moves, faster to draw",
      this.world.isCheap,
      (on) => this.setCheap(on),
    );
    this.overlays = [this.viewButtons(), this.legend(), this.step, this.switches()];
    const paint = (theme: Theme) => {
      this.world.setPalette(paletteOf(theme));
      this.ramp.style.background = rampGradient(paletteOf(theme));
      this.slack.style.borderColor = cssColour(paletteOf(theme).slack);
      this.redraw();
    };
    const copy = onPaper(this.canvas, {
      before: () => {
        paint("light");
        this.drawForPaper();
      },
      after: () => paint(currentTheme()),
    });
    this.root.append(copy, this.labels.root, ...this.overlays);
    set(this.canvas, { tabindex: 0 });
    onTheme(paint);
    new ResizeObserver(() => this.fit()).observe(this.root);
    this.showView("orbit");
    this.listen();
    requestAnimationFrame((now) => this.tick(now));
  }

  redraw(): void {
    this.needsDrawing = true;
    this.needsLabels = true;
  }

  showView(view: View): void {
    // Views follow bodies, which are where they are at the time that is shown.
    this.session.lift.seek(this.session.time);
    this.cameras.show(view, this.rooms());
    for (const [name, button] of this.views)
      set(button, { "aria-pressed": String(name === this.cameras.view) });
    this.redraw();
  }

  /** Look from where somebody else has looked, at the time that is shown. */
  look(camera: number[]): void {
    this.session.lift.seek(this.session.time);
    this.cameras.restore(camera);
  }

  /** What is free of the drawing. */
  private rooms(): Room[] {
    const boxes = this.reserved.map((box, index) =>
      // The name of a step may become long.
      this.overlays[index] === this.step ? { ...box, x: this.width / 2, width: this.width } : box,
    );
    return roomsBetween(boxes, this.width, this.height);
  }

  /** A picture of what is drawn now, as PNG. */
  picture(): string {
    this.world.setStill(true);
    this.draw();
    return this.canvas.toDataURL("image/png");
  }

  /** Finely, and with the time, which the bar has on the screen. */
  private drawForPaper(): void {
    this.world.setStill(true);
    this.draw();
    this.step.dataset.time = `${shown(this.session.time, 2)} s`;
  }

  private viewButtons(): HTMLElement {
    const holder = element("div", { class: "gl-views", role: "group", "aria-label": "Views" });
    for (const view of this.cameras.available()) {
      const made = element("button", { type: "button", class: "gl-chip", title: TITLES[view] }, view);
      made.addEventListener("click", () => this.showView(view));
      this.views.set(view, made);
      holder.append(made);
    }
    return holder;
  }

  private legend(): HTMLElement {
    const half = element("span", {});
    const whole = element("span", {});
    const show = () => {
      const most = this.session.lift.largestTension;
      half.textContent = forceText(most / 2, most).replace(/ .*/, "");
      whole.textContent = forceText(most, most);
    };
    show();
    this.session.on("data", show);
    const slack = element("div", { class: "gl-slack" }, this.slack, "slack");
    return element(
      "div",
      { class: "gl-ramp-box" },
      element("div", { class: "gl-ramp-title" }, "Rope tension"),
      element(
        "div",
        { class: "gl-ramp-strip" },
        this.ramp,
        element("div", { class: "gl-scale" }, "0", half, whole),
      ),
      slack,
    );
  }

  private switches(): HTMLElement {
    const holder = element("div", { class: "gl-switches", role: "group", "aria-label": "What is shown" });
    const names = this.toggle("Names", "Names of slings, hooks, hinges and loads (N)", true, (on) => {
      this.labels.root.hidden = !on;
    });
    const arrows = this.toggle("Forces", "Arrows of tensions and of support forces (F)", true, (on) => {
      this.world.arrows.mesh.visible = on;
    });
    const distances = this.toggle("Distances", "Smallest distances of watched pairs (D)", true, (on) => {
      this.world.clearances.lines.visible = on;
    });
    distances.hidden = this.session.lift.header.pairs.length === 0;
    holder.append(names, arrows, distances, this.cheapSign);
    Object.assign(this.switchOf, { n: names, f: arrows, d: distances });
    return holder;
  }

  private toggle(text: string, title: string, isOn: boolean, act: (on: boolean) => void): HTMLButtonElement {
    const made = element(
      "button",
      { type: "button", class: "gl-chip", title, "aria-pressed": String(isOn) },
      text,
    );
    made.addEventListener("click", () => {
      const on = made.getAttribute("aria-pressed") !== "true";
      set(made, { "aria-pressed": String(on) });
      act(on);
      this.redraw();
    });
    return made;
  }

  private setCheap(isCheap: boolean): void {
    this.world.setCheap(isCheap);
    set(this.cheapSign, { "aria-pressed": String(isCheap) });
    this.redraw();
  }

  private fit(): void {
    const { clientWidth, clientHeight } = this.root;
    // It has no size before it is in the page, nor where it is hidden.
    if (clientWidth === 0 || clientHeight === 0) return;
    [this.width, this.height] = [clientWidth, clientHeight];
    // Names with values need room.
    this.withValues = this.width >= 560;
    this.world.resize(this.width, this.height);
    this.reserve();
    if (this.cameras.isMoved) this.redraw();
    else this.showView(this.cameras.view);
  }

  private reserve(): void {
    this.reserved = this.overlays.map((one) => ({
      x: one.offsetLeft + one.offsetWidth / 2,
      y: one.offsetTop + one.offsetHeight / 2,
      width: one.offsetWidth,
      height: one.offsetHeight,
    }));
  }

  private listen(): void {
    this.session.on("time", () => {
      this.needsDrawing = true;
    });
    this.session.on("play", () => this.redraw());
    this.session.on("data", () => {
      this.world.takeMore();
      this.redraw();
    });
    this.session.on("pin", () => this.redraw());
    // Browsers take the graphics card away, from pages behind others for one, and give it back empty.
    this.canvas.addEventListener("webglcontextrestored", () => this.redraw());
    let pressed: [number, number] | null = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      // A second finger zooms; whichever is lifted first has pressed nothing.
      pressed = event.isPrimary ? [event.clientX, event.clientY] : null;
    });
    this.canvas.addEventListener("pointerup", (event) => {
      const isClick = pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 5;
      pressed = null;
      if (isClick) this.session.pin(this.ropeUnder(event));
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (event.buttons === 0) this.canvas.style.cursor = this.ropeUnder(event) ? "pointer" : "grab";
    });
  }

  private ropeUnder(event: PointerEvent): string | null {
    const box = this.canvas.getBoundingClientRect();
    return ropeAt(
      this.world,
      this.session.lift,
      event.clientX - box.left,
      event.clientY - box.top,
      this.width,
      this.height,
    );
  }

  /** One frame of the browser: go on, and draw if anything has changed. */
  private tick(now: number): void {
    requestAnimationFrame((next) => this.tick(next));
    this.session.advance(now);
    if (!this.needsDrawing) {
      if (!this.session.playing && now - this.drawnAt > STILL && this.isRough) this.drawStill();
      return;
    }
    this.needsDrawing = false;
    this.drawnAt = now;
    this.isRough = true;
    this.world.setStill(false);
    this.draw();
    if (this.session.playing) this.measure(now);
    else this.lastFrame = 0;
  }

  /** Once more, finely, where what moved was drawn in the cheap style. */
  private drawStill(): void {
    this.isRough = false;
    if (!this.world.isCheap) return;
    this.world.setStill(true);
    this.draw();
  }

  private draw(): void {
    const { lift, time } = this.session;
    lift.seek(time);
    this.cameras.follow();
    this.world.draw(this.session.pinned);
    const isDue = this.pace.isDue();
    if (this.session.playing && !this.needsLabels && !isDue) return;
    this.needsLabels = false;
    const text = lift.stepAt(time)?.name ?? "";
    if (this.step.textContent !== text) {
      this.step.textContent = text;
      this.reserve();
    }
    this.labels.update(this.width, this.height, this.withValues, this.reserved);
  }

  /** Where frames come slowly, ropes become thin lines; where they still do, pixels become coarse. */
  private measure(now: number): void {
    this.measured.count += 1;
    if (this.lastFrame > 0 && now - this.lastFrame < 1000) this.frameTimes.push(now - this.lastFrame);
    this.lastFrame = now;
    if (this.frameTimes.length < 12) return;
    this.measured.frame = this.frameTimes.reduce((sum, one) => sum + one, 0) / this.frameTimes.length;
    this.frameTimes = [];
    if (this.measured.frame > SLOW && !this.world.isCheap) this.setCheap(true);
    else if (this.measured.frame > VERY_SLOW && this.world.isCheap) this.world.setCoarse(true);
  }
}
