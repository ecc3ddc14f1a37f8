/** Light or dark, and the colours of each for what is drawn by the graphics card. */

export interface Palette {
  /**
   * From no tension to the largest: a quarter of it makes a difference to people who see no red, no green or no blue,
   * and all of it stands out from ground and sky. On light paper it darkens throughout, so that it can be printed in
   * grey; `gantline/plot/panels.py` draws with the same.
   */
  ramp: readonly [number, number, number][];
  slack: [number, number, number];
  load: number;
  frame: number;
  sheave: number;
  /** Cranes, supports, plain bodies. */
  other: number;
  hook: number;
  hull: number;
  edge: number;
  ground: number;
  /** Floor and walls of a hole in the ground. */
  pit: [number, number];
  water: number;
  grid: number;
  contact: number;
  /** Distances of watched pairs, and those that are too small. */
  clearance: number;
  tooClose: number;
  shadow: number;
  pinned: number;
  lug: number;
  /** Strength of light from all sides, and from the sun. */
  light: [number, number];
}

const LIGHT: Palette = {
  ramp: [
    [0.18, 0.52, 0.91],
    [0.42, 0.34, 0.92],
    [0.61, 0.12, 0.52],
    [0.62, 0.02, 0.3],
    [0.59, 0.0, 0.04],
  ],
  slack: [0.49, 0.51, 0.53],
  load: 0xdfe5ea,
  frame: 0xf2c14e,
  sheave: 0x8d9aa6,
  other: 0xc3ccd4,
  hook: 0xe2a72e,
  hull: 0x8ea4b5,
  edge: 0x4a5866,
  ground: 0xf1f3f0,
  pit: [0xd5dbd9, 0xbcc5c6],
  grid: 0xc2cbd2,
  contact: 0x12805c,
  clearance: 0x0b7285,
  tooClose: 0xd6221f,
  water: 0x8fbcd8,
  shadow: 0x22303c,
  pinned: 0x111820,
  lug: 0x5d6b78,
  light: [2.0, 1.5],
};

const DARK: Palette = {
  ramp: [
    [0.42, 0.83, 0.9],
    [0.5, 0.68, 0.99],
    [0.57, 0.46, 0.92],
    [1.0, 0.38, 0.6],
    [0.98, 0.71, 0.2],
  ],
  slack: [0.47, 0.48, 0.46],
  load: 0x55636f,
  frame: 0xb08a2c,
  sheave: 0x75828e,
  other: 0x46535f,
  hook: 0xb9882a,
  hull: 0x3d5263,
  edge: 0xa9b7c3,
  ground: 0x1b232b,
  pit: [0x131920, 0x0c1116],
  grid: 0x3b4853,
  contact: 0x3fcf9b,
  clearance: 0x4fd3e8,
  tooClose: 0xff6b5e,
  water: 0x1f5f86,
  shadow: 0x05080b,
  pinned: 0xffffff,
  lug: 0xa5b2bd,
  light: [1.9, 1.5],
};

const THEMES = ["light", "dark"] as const;
export type Theme = (typeof THEMES)[number];

/** The theme that is shown: what the reader has chosen, else what the system prefers. */
export function currentTheme(): Theme {
  const chosen = document.documentElement.dataset.theme;
  if (chosen === "light" || chosen === "dark") return chosen;
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

export function paletteOf(theme: Theme): Palette {
  return theme === "dark" ? DARK : LIGHT;
}

/** Call back now and whenever the theme changes. */
export function onTheme(callback: (theme: Theme) => void): void {
  const tell = () => callback(currentTheme());
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", tell);
  new MutationObserver(tell).observe(document.documentElement, { attributeFilter: ["data-theme"] });
  tell();
}

/** Colour of a share from 0 to 1 of the largest tension, into three numbers of `out` from `at`. */
export function rampInto(palette: Palette, share: number, out: Float32Array, at: number): void {
  const last = palette.ramp.length - 1;
  const place = Math.min(1, Math.max(0, share)) * last;
  const below = Math.min(last - 1, Math.floor(place));
  const part = place - below;
  const from = palette.ramp[below]!;
  const to = palette.ramp[below + 1]!;
  for (let channel = 0; channel < 3; channel++)
    out[at + channel] = from[channel]! + part * (to[channel]! - from[channel]!);
}

/** The ramp as a gradient of CSS, from left to right. */
export function rampGradient(palette: Palette): string {
  return `linear-gradient(to right, ${palette.ramp.map(cssColour).join(", ")})`;
}

/** A colour of three parts from 0 to 1, as CSS has it. */
export function cssColour(colour: readonly number[]): string {
  return `rgb(${colour.map((part) => Math.round(255 * part)).join(" ")})`;
}
