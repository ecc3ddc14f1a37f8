import { type BufferAttribute, LineSegments, type Mesh, type MeshBasicMaterial } from "three";
import { describe, expect, it } from "vitest";
import type { Lift } from "../src/data/lift";
import { Ground } from "../src/scene/ground";
import { Sea, Waves } from "../src/scene/sea";
import type { Extent } from "../src/scene/world";
import { paletteOf } from "../src/theme";

const extent = { middle: [3, -4, 5], size: 40, low: [-20, -20, -5], high: [20, 20, 15] } as unknown as Extent;

/** One wave of 25 m, a height of 1.6 m, running between x and y, that has grown after 10 s. */
const WAVE = [1.57, 0.2, 0.15, 0.8, 0.6] as const;

function lift(water: number | null, waves: readonly number[], ground: number | null = null) {
  const header = { water, ground, riseTime: waves.length > 0 ? 10 : null, holes: [] };
  return { header, array: () => Float64Array.from(waves) } as unknown as Lift;
}

describe("the sea", () => {
  it("lies at its level, also where there is no ground", () => {
    const sea = new Sea(lift(-1, []), extent);
    sea.lay(paletteOf("light"));
    const [surface, grid] = sea.group.children as Mesh[];
    expect(sea.group.position.z).toBe(-6);
    expect((surface!.material as MeshBasicMaterial).transparent).toBe(true);
    expect(grid).toBeInstanceOf(LineSegments);
    const dry = new Sea(lift(null, [], 0), extent);
    dry.lay(paletteOf("light"));
    expect(dry.group.children.length).toBe(0);
    const ground = new Ground(lift(null, [], 0).header, extent);
    ground.lay(paletteOf("light"));
    expect(ground.group.children.length).toBe(1);
  });

  it("is at each crossing as high as a cos(k x - w t + e), once it has grown", () => {
    const waves = new Waves(Float64Array.of(...WAVE), 10, extent.middle, 30);
    const [frequency, alongX, alongY, amplitude, phase] = WAVE;
    const count = waves.lines.length;
    for (const [time, growth] of [
      [0, 0],
      [5, 0.5],
      [10, 1],
      [47.3, 1],
    ] as const) {
      waves.update(time);
      for (const place of [0, 17, 48 * count + 48, 50 * count + 90, count * count - 1]) {
        const x = waves.lines[place % count]! + 3;
        const y = waves.lines[Math.floor(place / count)]! - 4;
        const angle = alongX * x + alongY * y - frequency * time + phase;
        expect(waves.heights[place]).toBeCloseTo(growth * amplitude * Math.cos(angle), 12);
      }
    }
  });

  it("has lines from edge to edge, the closest in the middle", () => {
    const { lines } = new Waves(Float64Array.of(...WAVE), 10, extent.middle, 30);
    const spaces = Array.from(lines.subarray(1), (line, at) => line - lines[at]!);
    expect([lines[0], lines[lines.length - 1]]).toEqual([-30, 30]);
    expect(Math.min(...spaces)).toBeCloseTo(spaces[48]!, 3);
    expect(Math.min(...spaces)).toBeGreaterThan(0);
  });

  it("leaves out waves that its lines are too far apart for", () => {
    const short = new Waves(Float64Array.of(10, 10, 0, 1, 0), 1, [0, 0, 0], 200);
    short.update(9);
    expect(Math.max(...short.heights)).toBe(0);
    const far = new Waves(Float64Array.of(2, 0.6, 0, 1, 0), 1, [0, 0, 0], 200);
    far.update(9);
    const middle = Array.from({ length: 9 }, (_, at) => Math.abs(far.heights[48 * 97 + 44 + at]!));
    expect(Math.max(...middle)).toBeGreaterThan(0.5);
    expect(far.heights[48 * 97]).toBe(0);
  });

  it("moves with time, and is lighter where it falls towards the light", () => {
    const sea = new Sea(lift(0, WAVE), extent);
    sea.lay(paletteOf("light"));
    const [surface] = sea.group.children as Mesh[];
    const places = surface!.geometry.attributes.position as BufferAttribute;
    const colours = surface!.geometry.attributes.color as BufferAttribute;
    sea.update(20);
    const before = places.getZ(48 * 97 + 48);
    sea.update(22);
    expect(places.getZ(48 * 97 + 48)).not.toBeCloseTo(before, 3);
    const slope = (at: number) =>
      (places.getZ(at + 97) - places.getZ(at - 97)) / (places.getY(at + 97) - places.getY(at - 97));
    const row = Array.from({ length: 60 }, (_, line) => (18 + line) * 97 + 48);
    const rising = row.reduce((best, at) => (slope(at) > slope(best) ? at : best));
    const falling = row.reduce((best, at) => (slope(at) < slope(best) ? at : best));
    // Light comes from where x and y are small: what rises with y faces it.
    expect(colours.getX(rising)).toBeGreaterThan(colours.getX(falling));
  });
});
