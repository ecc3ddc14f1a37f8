/** What the header of a packed recording holds; `python/gantline/viewer/pack.py` writes it. */

export type Vector = [number, number, number];

export interface Box {
  size: Vector;
  centre: Vector;
}

export type Shape =
  | ({ type: "box" } & Box)
  | { type: "boxes"; boxes: Box[] }
  | { type: "mesh" | "convex"; arrays: string };

export interface Body {
  name: string;
  kind: string;
  shape: Shape | null;
  cog: Vector;
}

export interface Sheave {
  body: number;
  centre: Vector;
  axis: Vector;
  radius: number;
  moves: boolean;
}

export interface Rope {
  name: string;
  label: string;
  /** `sling`, `equalizing`, `outer` (mooring and tag lines) or `rope`. */
  kind: string;
  /** Its points among all points of the path. */
  first: number;
  count: number;
  diameter: number;
  /** Without tension [m]; null where it is not known or changes. */
  length: number | null;
  /** Peak of its minimum breaking force, at its upper end [1]; null where that is not known. */
  used: number | null;
  peak: number;
  peakTime: number;
}

export interface Lug {
  name: string;
  rope: string;
  body: number;
  at: Vector;
  normal: Vector;
}

export interface Contact {
  name: string;
  body: number;
  at: Vector;
}

/** A hinge of a load: the body that turns in it, about its own y, and when it lets go [s]. */
export interface Hinge {
  body: number;
  openedAt: number | null;
}

/** A hole in the ground: from wall to wall along x and y, and its floor [m]. */
export interface Hole {
  x: [number, number];
  y: [number, number];
  floor: number;
}

/** Two things whose distance is watched, what it must not go below [m], and when, where that is not always [s]. */
export interface Pair {
  name: string;
  smallest: number;
  span?: [number, number];
}

/** What stands in the world: the eight corners of each of its boxes, z fastest; when it is taken away [s]. */
export interface Structure {
  name: string;
  kind: "support" | "structure";
  boxes: Vector[][];
  removedAt: number | null;
}

export interface CurveEntry {
  group: string;
  name: string;
  label: string;
  unit: string;
  first: number;
  count: number;
  /** What it belongs to with others of its group; empty if it stands for itself. */
  family: string;
  /** Largest value over all steps and its time [s], where that is known; between samples, so in no curve. */
  peak: [number, number] | null;
}

/** A time in which a step went, or several side by side [s]. */
export interface StepEntry {
  names: string[];
  begin: number;
  end: number;
}

export interface ArrayEntry {
  type: "f8" | "f4" | "u4" | "steps";
  shape: number[];
  step?: number;
  at: number;
}

export interface Header {
  format: number;
  title: string;
  samples: number;
  liftOff: number | null;
  bodies: Body[];
  sheaves: Sheave[];
  ropes: Rope[];
  lugs: Lug[];
  contacts: Contact[];
  hinges: Hinge[];
  /** Level of the ground [m]. */
  ground: number | null;
  holes: Hole[];
  /** Level of the water [m]. */
  water: number | null;
  /** Time in which its waves grow [s]; null where there are none. */
  riseTime: number | null;
  pairs: Pair[];
  structures: Structure[];
  /** Time [s], kind and name. */
  events: [number, string, string][];
  steps: StepEntry[];
  /** Where in its plan the run has ended, in words; null if it came through. */
  unfinished: string | null;
  /** Whether it could not go on there. */
  failed: boolean;
  strokes: Record<string, [number | null, number | null]>;
  curves: CurveEntry[];
  arrays: Record<string, ArrayEntry>;
}
