import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { type Lens, lensFrom, placeFor, type Room, roomsBetween, WHOLE } from "../src/scene/fit";
import type { Box } from "../src/scene/settle";

/** Eight corners of a box about the origin. */
function corners(x: number, y: number, z: number): number[] {
  return [-x, x].flatMap((i) => [-y, y].flatMap((j) => [-z, z].flatMap((k) => [i, j, k])));
}

/** Where points are seen from a place, in shares of half the drawing. */
function seen(points: number[], from: Vector3, lens: Lens): { across: number[]; up: number[] } {
  const [across, up]: [number[], number[]] = [[], []];
  for (let at = 0; at < points.length; at += 3) {
    const way = new Vector3().fromArray(points, at).sub(from);
    const away = -way.dot(lens.back);
    across.push(way.dot(lens.right) / away / lens.across);
    up.push(way.dot(lens.up) / away / lens.above);
  }
  return { across, up };
}

const ROOMS: Room[] = [
  WHOLE,
  { left: -0.9, right: 0.9, low: -0.7, high: 0.6 },
  { left: -0.4, right: 0.4, low: -0.9, high: 0.9 },
];

describe("a camera that is fitted", () => {
  for (const [name, aspect] of [
    ["wide", 16 / 9],
    ["square", 1],
    ["upright", 3 / 4],
  ] as const)
    for (const [thing, points] of [
      ["tower", corners(3, 4, 30)],
      ["bridge", corners(40, 6, 5)],
    ] as const)
      it(`holds a ${thing} whole, and no larger could be drawn: ${name}`, () => {
        for (const room of ROOMS) {
          const lens = lensFrom(new Vector3(-0.62, -1, 0.3), 32, aspect);
          const { across, up } = seen(points, placeFor(points, lens, room, 1), lens);
          const gaps = [
            [Math.min(...across) - room.left, room.right - Math.max(...across)],
            [Math.min(...up) - room.low, room.high - Math.max(...up)],
          ];
          for (const gap of gaps.flat()) expect(gap).toBeGreaterThan(-1e-9);
          // Along one side it reaches from edge to edge.
          expect(Math.min(...gaps.map(([one, other]) => one! + other!))).toBeLessThan(1e-9);
        }
      });

  it("stands before a single place", () => {
    const lens = lensFrom(new Vector3(0, -1, 0), 32, 1);
    const place = placeFor([1, 2, 3], lens, WHOLE, 0.5);
    [1, 1.5, 3].forEach((part, axis) => {
      expect(place.getComponent(axis)).toBeCloseTo(part, 12);
    });
  });
});

describe("rooms of a drawing", () => {
  const chips: Box = { x: 60, y: 20, width: 100, height: 20 };
  const legend: Box = { x: 550, y: 40, width: 160, height: 60 };
  const step: Box = { x: 320, y: 340, width: 640, height: 20 };

  it("lie under what is wide, and between what is narrow", () => {
    const rooms = roomsBetween([chips, legend, step], 640, 360).map(({ left, right, low, high }) => [
      320 * (1 + left),
      320 * (1 + right),
      180 * (1 - high),
      180 * (1 - low),
    ]);
    // 12 pixels stay free beside each: under the legend; beside the buttons; beside the legend, from top to step.
    const expected = [
      [12, 628, 82, 318],
      [122, 518, 82, 318],
      [182, 458, 12, 318],
    ];
    rooms.forEach((room, index) => {
      room.forEach((side, place) => {
        expect(side).toBeCloseTo(expected[index]![place]!, 9);
      });
    });
    expect(rooms.length).toBe(3);
  });

  it("are the whole where nothing is left, and leave out what has no size", () => {
    expect(roomsBetween([{ x: 50, y: 50, width: 100, height: 90 }], 100, 100)).toEqual([WHOLE]);
    expect(roomsBetween([{ x: 0, y: 0, width: 0, height: 0 }], 240, 120)).toEqual([
      { left: -0.9, right: 0.9, low: -0.8, high: 0.8 },
    ]);
  });
});
