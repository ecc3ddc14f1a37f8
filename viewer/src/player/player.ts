/** The player: drawing, bar, pinned rope, keys, and the address that leads to what is shown. */

import { element, ICONS } from "../dom";
import { VIEWS } from "../scene/cameras";
import { parse, type Shown, written } from "./address";
import { Bar, button } from "./bar";
import { Pinned } from "./pinned";
import type { Session } from "./session";
import { Stage } from "./stage";

const SAID = 3000; // ms

export class Player {
  readonly stage: Stage | null;
  private pending = 0;
  /** What came of a press that shows nothing else. */
  private readonly said = element("span", { class: "gl-said", role: "status" });
  private unsaid = 0;

  constructor(
    readonly session: Session,
    private readonly root: HTMLElement,
  ) {
    root.classList.add("gl-player");
    this.stage = this.makeStage();
    const bar = new Bar(session);
    const menu = this.pinMenu();
    bar.root.append(menu);
    bar.root.append(button("Copy a link to what is shown", ICONS.link, () => void this.copyLink()));
    if (this.stage) bar.root.append(button("Save a picture (P)", ICONS.save, () => this.savePicture()));
    // Some phones, and frames in other pages, do not let it.
    if (document.fullscreenEnabled)
      bar.root.append(button("Full screen", ICONS.full, () => this.fullScreen()));
    bar.root.append(this.said);
    root.append(bar.root, new Pinned(session, menu).root);
    root.addEventListener("keydown", (event) => this.onKey(event));
    this.restore(parse(location.hash));
    globalThis.addEventListener("hashchange", () => this.restore(parse(location.hash)));
    for (const topic of ["time", "pin", "play", "span"] as const) session.on(topic, () => this.remember());
    // Whatever moves the camera or changes the view or the speed is one of these, or a key.
    for (const kind of ["click", "pointerup", "wheel", "keyup", "change"])
      root.addEventListener(kind, () => this.remember(), { passive: true });
  }

  private makeStage(): Stage | null {
    try {
      const stage = new Stage(this.session);
      this.root.append(stage.root);
      return stage;
    } catch (problem) {
      const reason = problem instanceof Error ? problem.message : String(problem);
      const text =
        `This browser cannot draw in three dimensions: ${reason.replace(/^(THREE\.\w+: )+/, "")} Switch on ` +
        "graphics acceleration in its settings, or open this page in another one. The plots below work all the same.";
      this.root.append(element("p", { class: "gl-message", role: "status" }, text));
      return null;
    }
  }

  /** The rope to pin, for those who do not click. */
  private pinMenu(): HTMLSelectElement {
    const menu = element("select", { class: "gl-select gl-pin", "aria-label": "Pin a rope" });
    menu.append(element("option", { value: "" }, "pin a rope"));
    for (const rope of this.session.lift.header.ropes)
      menu.append(element("option", { value: rope.name }, rope.name));
    menu.addEventListener("change", () => this.session.pin(menu.value || null));
    this.session.on("pin", () => {
      menu.value = this.session.pinned ?? "";
    });
    return menu;
  }

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target as HTMLElement;
    if (target instanceof HTMLSelectElement) return;
    if (event.key === " " && target instanceof HTMLButtonElement) return;
    const { session } = this;
    const step = (session.lift.end - session.lift.begin) * (event.shiftKey ? 0.05 : 0.005);
    const orbits = target === this.stage?.canvas;
    const turn = (around: number, up: number) => this.stage?.cameras.nudge(around, up, 1);
    const actions: Record<string, () => void> = {
      " ": () => session.toggle(),
      ArrowLeft: () => (orbits && event.shiftKey ? turn(-0.1, 0) : session.seek(session.time - step)),
      ArrowRight: () => (orbits && event.shiftKey ? turn(0.1, 0) : session.seek(session.time + step)),
      ",": () => session.jump(false),
      ".": () => session.jump(true),
      Home: () => session.seek(session.lift.begin),
      End: () => session.seek(session.lift.end),
      Escape: () => session.pin(null),
      p: () => this.savePicture(),
    };
    if (orbits) {
      actions.ArrowUp = () => turn(0, 0.08);
      actions.ArrowDown = () => turn(0, -0.08);
      for (const key of ["+", "="]) actions[key] = () => this.stage?.cameras.nudge(0, 0, 0.87);
      actions["-"] = () => this.stage?.cameras.nudge(0, 0, 1.15);
    }
    // Of a slider people expect that up and down move it too.
    if (target instanceof HTMLInputElement) {
      actions.ArrowUp = actions.ArrowRight!;
      actions.ArrowDown = actions.ArrowLeft!;
    }
    for (const [key, made] of Object.entries(this.stage?.switchOf ?? {})) actions[key] = () => made.click();
    VIEWS.forEach((view, place) => {
      actions[String(place + 1)] = () => this.stage?.showView(view);
    });
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  /** What is shown, as an address has it. */
  shown(): Shown {
    const { session, stage } = this;
    const { lift } = session;
    const isZoomed = session.span[0] > lift.begin || session.span[1] < lift.end;
    return {
      time: session.time,
      speed: session.speed,
      ...(stage ? { view: stage.cameras.view } : {}),
      // Where nobody has moved the camera, it is fitted to whatever the drawing measures there.
      ...(stage?.cameras.isMoved ? { camera: stage.cameras.state() } : {}),
      ...(session.pinned ? { pinned: session.pinned } : {}),
      ...(isZoomed ? { span: session.span } : {}),
    };
  }

  private restore(shown: Shown): void {
    const { session, stage } = this;
    if (shown.speed !== undefined) session.setSpeed(shown.speed);
    // First the time: a camera that follows a body is where the body is then.
    if (shown.time !== undefined) session.seek(shown.time);
    if (shown.view !== undefined) stage?.showView(shown.view);
    if (shown.camera !== undefined) stage?.look(shown.camera);
    if (shown.span !== undefined) session.show(...shown.span);
    if (shown.pinned !== undefined) session.pin(shown.pinned);
  }

  /** Keep the address in step, but not at every frame: browsers count. */
  private remember(): void {
    clearTimeout(this.pending);
    this.pending = setTimeout(() => {
      if (!this.session.playing) this.writeAddress();
    }, 300) as unknown as number;
  }

  private writeAddress(): void {
    try {
      history.replaceState(null, "", written(this.shown()));
    } catch {
      // A page without an address of its own keeps none.
    }
  }

  private async copyLink(): Promise<void> {
    const link = location.href.replace(/#.*$/, "") + written(this.shown());
    this.writeAddress();
    try {
      await navigator.clipboard.writeText(link);
      this.say("link copied");
    } catch {
      // Browsers keep the clipboard from pages that they do not trust.
      this.say("the link is in the address bar");
    }
  }

  private say(text: string): void {
    this.said.textContent = text;
    clearTimeout(this.unsaid);
    this.unsaid = setTimeout(() => this.said.replaceChildren(), SAID) as unknown as number;
  }

  private savePicture(): void {
    if (!this.stage) return;
    const name = `${this.session.lift.header.title.replace(/[^\p{L}\p{N}]+/gu, "_").slice(0, 60) || "lift"}`;
    const download = `${name}_${this.session.time.toFixed(2)}s.png`;
    element("a", { href: this.stage.picture(), download }).click();
  }

  private fullScreen(): void {
    if (document.fullscreenElement) void document.exitFullscreen();
    else void this.root.requestFullscreen().catch(() => {});
  }
}
