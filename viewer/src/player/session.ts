/** What the player and all plots of a page share: time, playing, the pinned rope, the span that is shown. */

import type { Lift } from "../data/lift";
import type { Unpacked } from "../data/unpack";

/** `data`: more has been recorded, of a lift that runs. */
export type Topic = "time" | "play" | "pin" | "span" | "hover" | "hidden" | "data";

/** Speeds that can be chosen, of real time. */
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20] as const;

/** Events that a reader must not miss. */
const GRAVE = [
  "cut",
  "broken",
  "off_support",
  "too_close",
  "flooding",
  "capsized",
  "overload",
  "hook_too_high",
  "tipping",
  "emergency_stop",
];

/** Contacts that lift nothing off: fenders bear and let go in every wave, along guides a load bounces. */
const BESIDE = /^(fender|guide)\./;

/** Events between which one steps; the rest comes too often to be of use. */
const NOTABLE = [
  ...GRAVE,
  "step_begin",
  "lift_off",
  "set_down",
  "detached",
  "attached",
  "support_removed",
  "hinge_opened",
  "stop_hit",
  "pin_pulled",
  "pin_put_in",
  "drum_slips",
  "pump_stopped",
];

/** An event that comes again so soon belongs to a row, of which the first and the last are told [s]. */
const SOON = 10;

/** How much of a run that did not get through its lift a page shows first [s]. */
const LAST = 5;

/** What happened at one time. */
export interface Notable {
  time: number;
  text: string;
  isGrave: boolean;
}

export class Session {
  time: number;
  playing = false;
  speed = 1;
  loop = false;
  pinned: string | null = null;
  /** Time under the pointer in a plot [s]. */
  hover: number | null = null;
  span: [number, number];
  /** Curves that are switched off, by plot and name. */
  readonly hidden = new Set<string>();
  private readonly listeners = new Map<Topic, (() => void)[]>();
  private last: number | null = null;

  constructor(readonly lift: Lift) {
    this.time = opensAt(lift);
    this.span = [lift.begin, lift.end];
    this.speed = usualSpeed(lift.end - lift.begin);
  }

  /** Call back after every change of a topic; what is returned ends that. */
  on(topic: Topic, listener: () => void): () => void {
    this.listeners.set(topic, [...(this.listeners.get(topic) ?? []), listener]);
    return () =>
      this.listeners.set(
        topic,
        this.listeners.get(topic)!.filter((one) => one !== listener),
      );
  }

  private tell(topic: Topic): void {
    for (const listener of this.listeners.get(topic) ?? []) listener();
  }

  /** Go on with what was recorded later; who looks at the end goes on doing so. */
  append(more: Unpacked): void {
    const { end } = this.lift;
    this.lift.append(more);
    if (this.span[1] >= end) this.span = [this.span[0], this.lift.end];
    this.tell("data");
    if (this.time >= end && !this.playing) this.seek(this.lift.end);
  }

  seek(time: number): void {
    const bounded = Math.min(this.lift.end, Math.max(this.lift.begin, time));
    if (bounded === this.time || !Number.isFinite(bounded)) return;
    this.time = bounded;
    this.tell("time");
  }

  play(): void {
    if (this.playing || this.lift.end <= this.lift.begin) return;
    if (this.time >= this.lift.end) this.seek(this.lift.begin);
    this.playing = true;
    this.last = null;
    this.tell("play");
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    this.tell("play");
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Go on by what has passed since the last call [ms of the browser's clock]. */
  advance(now: number): void {
    if (!this.playing) return;
    // After a pause of the browser the lift goes on from where it was.
    const passed = this.last === null ? 0 : Math.min(0.25, (now - this.last) / 1000);
    this.last = now;
    const next = this.time + this.speed * passed;
    if (next < this.lift.end) this.seek(next);
    else if (this.loop) this.seek(this.lift.begin);
    else {
      this.seek(this.lift.end);
      this.pause();
    }
  }

  setSpeed(speed: number): void {
    if (!(speed > 0) || !Number.isFinite(speed)) return;
    this.speed = speed;
    this.tell("play");
  }

  setLoop(loop: boolean): void {
    this.loop = loop;
    this.tell("play");
  }

  pin(name: string | null): void {
    const known = this.lift.header.ropes.some((rope) => rope.name === name);
    this.pinned = known ? name : null;
    this.tell("pin");
  }

  pointAt(time: number | null): void {
    this.hover = time;
    this.tell("hover");
  }

  show(begin: number, end: number): void {
    const low = Math.max(this.lift.begin, Math.min(begin, end));
    const high = Math.min(this.lift.end, Math.max(begin, end));
    if (!(high - low > 1e-6 * (this.lift.end - this.lift.begin))) return;
    this.span = [low, high];
    this.tell("span");
  }

  showAll(): void {
    this.show(this.lift.begin, this.lift.end);
  }

  toggleHidden(key: string): void {
    if (!this.hidden.delete(key)) this.hidden.add(key);
    this.tell("hidden");
  }

  /** Times of notable events, each once; of what comes again and again, as in waves, the ends of each row. */
  notable(): Notable[] {
    const { begin, end, header } = this.lift;
    const times = new Map<string, number[]>();
    for (const [time, kind, name] of header.events)
      if (NOTABLE.includes(kind) && !BESIDE.test(name) && time >= begin && time <= end) {
        const key = `${kind} ${name}`;
        if (!times.get(key)?.push(time)) times.set(key, [time]);
      }
    const found = new Map<number, Notable>();
    for (const [time, kind, name] of header.events) {
      const same = times.get(`${kind} ${name}`) ?? [];
      const place = same.indexOf(time);
      const isWithin = time - same[place - 1]! <= SOON && same[place + 1]! - time <= SOON;
      if (place < 0 || (isWithin && kind !== "step_begin")) continue;
      const before = found.get(time);
      const text = kind === "step_begin" ? name : `${words(kind)} ${name}`;
      found.set(time, {
        time,
        text: before ? `${before.text}, ${text}` : text,
        isGrave: GRAVE.includes(kind) || (before?.isGrave ?? false),
      });
    }
    // Where a run fails, or ends before its plan, it is looked for.
    if (header.unfinished !== null) {
      const before = found.get(end);
      const text = before ? `${before.text}, ${header.unfinished}` : header.unfinished;
      found.set(end, { time: end, text, isGrave: true });
    }
    return [...found.values()].sort((one, other) => one.time - other.time);
  }

  /** Go to the next or the last notable event. */
  jump(forward: boolean): void {
    const times = this.notable().map((event) => event.time);
    const slack = 1e-6 * (this.lift.end - this.lift.begin);
    const next = forward
      ? times.find((time) => time > this.time + slack)
      : times.reverse().find((time) => time < this.time - slack);
    this.seek(next ?? (forward ? this.lift.end : this.lift.begin));
  }
}

/** When a page opens [s]: at the start; of a run that did not get through its lift in its last seconds. */
export function opensAt({ begin, end, header }: Lift): number {
  return header.unfinished === null ? begin : end - Math.min(LAST, 0.25 * (end - begin));
}

/** A kind of event in words. */
export function words(kind: string): string {
  return kind.replaceAll("_", " ");
}

/** The slowest speed at which a lift takes no more than a minute. */
export function usualSpeed(duration: number): number {
  return SPEEDS.find((speed) => speed >= 1 && duration / speed <= 60) ?? SPEEDS[SPEEDS.length - 1]!;
}
