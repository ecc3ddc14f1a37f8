/** The bar below the drawing: play, time, events, speed. */

import { element, ICONS, icon, set } from "../dom";
import { Pace } from "../pace";
import { type Session, SPEEDS } from "./session";

const READABLE = 60; // ms

export class Bar {
  readonly root = element("div", { class: "gl-bar" });
  private readonly playButton: HTMLButtonElement;
  private readonly slider: HTMLInputElement;
  private readonly clock = element("output", { class: "gl-clock", "aria-live": "off" });
  private readonly speed: HTMLSelectElement;
  private readonly loop: HTMLButtonElement;
  private text = "";
  private readonly pace = new Pace(READABLE);

  constructor(private readonly session: Session) {
    const { lift } = session;
    this.playButton = button("Play (space)", ICONS.play, () => session.toggle());
    this.playButton.classList.add("gl-play");
    const previous = button("Previous event (comma)", ICONS.previous, () => session.jump(false));
    const next = button("Next event (full stop)", ICONS.next, () => session.jump(true));
    this.slider = element("input", {
      type: "range",
      class: "gl-slider",
      min: lift.begin,
      max: lift.end,
      step: "any",
      value: session.time,
      "aria-label": "Time",
    });
    this.slider.addEventListener("input", () => {
      session.pause();
      session.seek(Number(this.slider.value));
    });
    // The keys of the player move the time; those of the slider would move it twice.
    this.slider.addEventListener("keydown", (event) => {
      if (event.key.startsWith("Arrow") || event.key === "Home" || event.key === "End")
        event.preventDefault();
    });
    const speed = "Speed, of real time";
    this.speed = element("select", { class: "gl-select", "aria-label": speed, title: speed });
    for (const speed of SPEEDS) this.speed.append(element("option", { value: speed }, `${speed}×`));
    this.speed.addEventListener("change", () => session.setSpeed(Number(this.speed.value)));
    this.loop = button("Play again and again", ICONS.loop, () => session.setLoop(!session.loop));
    const marks = element("div", { class: "gl-marks", "aria-hidden": "true" });
    marks.append(...this.marks());
    session.on("data", () => {
      marks.replaceChildren(...this.marks());
      set(this.slider, { max: lift.end });
      this.showTime();
    });
    const track = element("div", { class: "gl-track" }, marks, this.slider);
    this.root.append(previous, this.playButton, next, track, this.clock, this.speed, this.loop);
    session.on("time", () => {
      if (!session.playing || this.pace.isDue()) this.showTime();
    });
    session.on("play", () => this.showState());
    this.showTime();
    this.showState();
  }

  /** Steps and events along the slider. */
  private marks(): HTMLElement[] {
    const { lift } = this.session;
    const span = lift.end - lift.begin || 1;
    const marks: HTMLElement[] = [];
    const place = (time: number) => `${(100 * (time - lift.begin)) / span}%`;
    lift.steps.forEach((step, index) => {
      const strip = element("span", {
        class: index % 2 === 0 ? "gl-mark-step" : "gl-mark-step gl-mark-odd",
        title: step.name,
      });
      strip.style.left = place(step.begin);
      strip.style.width = `${(100 * (step.end - step.begin)) / span}%`;
      marks.push(strip);
    });
    // What must not be missed lies upon the rest.
    const events = this.session.notable().sort((one, other) => Number(one.isGrave) - Number(other.isGrave));
    for (const event of events) {
      const kind = event.isGrave ? "gl-mark gl-mark-grave" : "gl-mark";
      const tick = element("span", { class: kind, title: event.text });
      tick.style.left = place(event.time);
      marks.push(tick);
    }
    return marks;
  }

  private showTime(): void {
    const { time, lift } = this.session;
    this.slider.value = String(time);
    const text = `${time.toFixed(2)} s`;
    if (text === this.text) return;
    this.text = text;
    this.clock.textContent = text;
    if (this.session.playing) return; // nobody listens to what changes at every frame
    const step = lift.stepAt(time);
    set(this.slider, { "aria-valuetext": step ? `${text}, ${step.name}` : text });
  }

  private showState(): void {
    const { playing, speed, loop } = this.session;
    const title = playing ? "Pause (space)" : "Play (space)";
    set(this.playButton, { "aria-label": title, title });
    this.text = "";
    this.showTime();
    this.playButton.replaceChildren(icon(playing ? ICONS.pause : ICONS.play) as unknown as Node);
    if (![...this.speed.options].some((option) => Number(option.value) === speed))
      this.speed.append(element("option", { value: speed }, `${speed}×`));
    this.speed.value = String(speed);
    set(this.loop, { "aria-pressed": String(loop) });
  }
}

export function button(title: string, path: string, act: () => void): HTMLButtonElement {
  const made = element("button", { type: "button", class: "gl-button", title, "aria-label": title });
  made.append(icon(path));
  made.addEventListener("click", act);
  return made;
}
