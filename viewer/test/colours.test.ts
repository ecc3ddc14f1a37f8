import { describe, expect, it } from "vitest";
import { paletteOf, rampInto } from "../src/theme";

type Colour = number[];

/** sRGB to linear light, IEC 61966-2-1. */
function linear(colour: Colour): Colour {
  return colour.map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
}

function times(matrix: number[][], colour: Colour): Colour {
  return matrix.map((row) => row.reduce((sum, part, place) => sum + part * colour[place]!, 0));
}

/** What people without one kind of cones see: Machado, Oliveira and Fernandes 2009, table 1, severity 1.0. */
const SIGHTS: Record<string, number[][]> = {
  usual: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritanopia: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

/** CIE 1976 L*a*b* of linear light, white D65. */
function lab(light: Colour): Colour {
  const xyz = times(
    [
      [0.4124564, 0.3575761, 0.1804375],
      [0.2126729, 0.7151522, 0.072175],
      [0.0193339, 0.119192, 0.9503041],
    ],
    light.map((part) => Math.min(1, Math.max(0, part))),
  );
  const [x, y, z] = xyz.map((part, place) => {
    const share = part / [0.95047, 1, 1.08883][place]!;
    return share > 216 / 24389 ? Math.cbrt(share) : ((24389 / 27) * share + 16) / 116;
  });
  return [116 * y! - 16, 500 * (x! - y!), 200 * (y! - z!)];
}

function apart(one: Colour, other: Colour, sight: number[][]): number {
  const [a, b] = [one, other].map((colour) => lab(times(sight, linear(colour))));
  return Math.hypot(...a!.map((part, place) => part - b![place]!));
}

/** Contrast of WCAG 2.2. */
function contrast(one: Colour, other: Colour): number {
  const [a, b] = [one, other].map((colour) => times([[0.2126, 0.7152, 0.0722]], linear(colour))[0]! + 0.05);
  return Math.max(a!, b!) / Math.min(a!, b!);
}

function parts(hex: number): Colour {
  return [hex >> 16, (hex >> 8) & 255, hex & 255].map((part) => part / 255);
}

it("ropes on light paper darken with their tension", () => {
  const light = [...Array(33).keys()].map((place) => {
    const out = new Float32Array(3);
    rampInto(paletteOf("light"), place / 32, out, 0);
    return lab(linear([...out]))[0]!;
  });
  for (let place = 1; place < light.length; place++) expect(light[place]!).toBeLessThan(light[place - 1]!);
});

describe.each(["light", "dark"] as const)("ropes in the %s", (theme) => {
  const palette = paletteOf(theme);
  const eighths = [...Array(9).keys()].map((place) => {
    const out = new Float32Array(3);
    rampInto(palette, place / 8, out, 0);
    return [...out];
  });
  /** `--sky-top` of the style sheet, which is behind what is high. */
  const sky = parts({ light: 0xdfe8f0, dark: 0x1a232c }[theme]);

  it("stand out from ground and sky", () => {
    // WCAG 2.2, 1.4.11: 3 : 1.
    for (const ground of [parts(palette.ground), sky])
      for (const colour of [...eighths, palette.slack])
        expect(contrast(colour, ground)).toBeGreaterThanOrEqual(3);
  });

  it.each(Object.keys(SIGHTS))("tell their tension by a quarter of the largest: %s", (name) => {
    // Differences from 2.3 on are seen where colours touch (Mahy and others 1994); ropes are thin and lie apart.
    const sight = SIGHTS[name]!;
    eighths.forEach((one, place) => {
      for (const other of eighths.slice(place + 2)) expect(apart(one, other, sight)).toBeGreaterThan(14);
      expect(apart(one, palette.slack, sight)).toBeGreaterThan(14);
    });
  });
});
