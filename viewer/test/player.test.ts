import {
  Box3,
  type BufferAttribute,
  type BufferGeometry,
  type Mesh,
  type Plane,
  SphereGeometry,
  Vector3,
} from "three";
import { describe, expect, it } from "vitest";
import { forceText, shown, ticksOf, valueText, verticalScale } from "../src/chart/scale";
import type { Vector } from "../src/data/format";
import { Lift } from "../src/data/lift";
import { Pace } from "../src/pace";
import { parse, written } from "../src/player/address";
import { Session, usualSpeed } from "../src/player/session";
import { Arrows } from "../src/scene/arrows";
import { Bodies } from "../src/scene/bodies";
import { Clearances } from "../src/scene/clearances";
import { niceCell } from "../src/scene/fading";
import { holesUnder, insideOf, outsideOf, pitOf } from "../src/scene/ground";
import { distanceToPiece } from "../src/scene/picking";
import { hullOf, plainSheaveGeometry, sheaveGeometry } from "../src/scene/solids";
import { Structures } from "../src/scene/structures";
import { extentOf } from "../src/scene/world";
import { paletteOf, rampInto } from "../src/theme";

describe("a pace", () => {
  it("is due at once and then no more often than it says", () => {
    const pace = new Pace(50);
    expect([1000, 1049, 1050, 1080, 1101].map((now) => pace.isDue(now))).toEqual([
      true,
      false,
      true,
      false,
      true,
    ]);
  });
});

describe("axes", () => {
  it("have round ticks", () => {
    expect(ticksOf(0, 702, 5)).toEqual({ ticks: [0, 200, 400, 600], digits: 0, step: 200 });
    expect(ticksOf(0, 1, 4)).toEqual({ ticks: [0, 0.25, 0.5, 0.75, 1], digits: 2, step: 0.25 });
    // 10 ** -4 is a little less than 0.0001: the axis of 1 kg had 0.0005, 0.0002 (0.00025) and 0.0000.
    for (const power of [-5, -4, -3, -2, -1])
      expect(ticksOf(0, Number(`5e${power}`), 2).digits, `5e${power}`).toBe(1 - power);
  });

  it("hold all values, begin at 0 where that is near, and are never without height", () => {
    const scale = verticalScale(100, 702, 5, 1);
    expect([scale.low, scale.high]).toEqual([0, 800]);
    const flat = verticalScale(3, 3, 5, 0.1);
    expect(flat.high - flat.low).toBeGreaterThanOrEqual(0.1);
    // About zero with less than a step to either side: trim of a barge in waves had the one tick 0.
    expect(verticalScale(-0.44, 0.44, 2, 0.1).ticks).toEqual([-0.5, 0, 0.5]);
    expect(verticalScale(Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY, 5, 1).high).toBeGreaterThan(0);
  });

  it("write numbers with a proper minus and no -0", () => {
    expect(shown(-1.25, 1)).toBe("−1.3");
    expect(shown(-0.001, 1)).toBe("0.0");
    expect(shown(Number.NaN, 1)).toBe("–");
  });

  it("write forces with a unit that shows them", () => {
    expect(forceText(124_400, 249_000)).toBe("124 kN");
    expect(forceText(124_400, 249_000, 1)).toBe("124.4 kN");
    expect(forceText(500, 45_000)).toBe("0.5 kN");
    expect(forceText(1500, 3000)).toBe("1.50 kN");
    // The rope of the smallest scenario had a scale from 0 to 0 kN.
    expect(forceText(99.92, 99.92)).toBe("99.9 N");
  });

  it("write values with decimals that show them", () => {
    expect(valueText(231.71, "kN", 248.7)).toBe("231.7 kN");
    // The slings of 200 kg: 1.1 kN all the time.
    expect(valueText(1.084, "kN", 1.326)).toBe("1.08 kN");
    // Less than 1 kN is read in N: a rope with 0.53 kg carried 0.005 kN.
    expect(valueText(-0.0526, "kN", 0.981)).toBe("−53 N");
    expect(valueText(0.0051993, "kN", 0.0051993)).toBe("5.20 N");
    expect(valueText(0, "kN", 0)).toBe("0.00 N");
    expect(valueText(0.25, "m", 1)).toBe("0.250 m");
    expect(valueText(20, "", 53)).toBe("20.00");
  });
});

describe("the address", () => {
  it("leads back to what was shown", () => {
    const state = {
      time: 12.345,
      view: "side" as const,
      camera: [1, 2, 3, 4, 5, 6],
      pinned: "sling.S 1&x=<b>",
      speed: 2,
      span: [1, 9] as [number, number],
    };
    expect(parse(written(state))).toEqual(state);
  });

  it("leaves out what it does not understand", () => {
    expect(parse("#t=x&view=<script>&camera=1,2&speed=-3&span=1")).toEqual({});
    expect(parse("")).toEqual({});
  });
});

function session(unfinished: string | null = null, end = 10): Session {
  const lift = {
    begin: 0,
    end,
    header: {
      unfinished,
      ropes: [{ name: "r" }],
      events: [
        [0, "step_begin", "hoist"],
        [3, "taut", "r"],
        [4, "lift_off", "block"],
        [4, "step_begin", "hold"],
      ],
    },
  };
  return new Session(lift as never);
}

describe("playing", () => {
  it("goes on by the speed, and stops at the end", () => {
    const one = session();
    one.setSpeed(10);
    one.play();
    one.advance(1000);
    one.advance(1100);
    expect(one.time).toBeCloseTo(1, 9);
    for (let now = 1200; now < 4000; now += 100) one.advance(now);
    expect([one.time, one.playing]).toEqual([10, false]);
    one.play();
    expect(one.time).toBe(0);
  });

  it("begins again where it is told to loop", () => {
    const one = session();
    one.setLoop(true);
    one.seek(9.99);
    one.play();
    one.advance(0);
    one.advance(200);
    expect([one.time, one.playing]).toEqual([0, true]);
  });

  it("steps between notable events, which are told once each", () => {
    const one = session();
    expect(one.notable()).toEqual([
      { time: 0, text: "hoist", isGrave: false },
      { time: 4, text: "lift off block, hold", isGrave: false },
    ]);
    one.jump(true);
    expect(one.time).toBe(4);
    one.jump(true);
    expect(one.time).toBe(10);
    one.jump(false);
    one.jump(false);
    expect(one.time).toBe(0);
  });

  it("opens a run that failed in its last seconds, and steps to where it did", () => {
    expect(session("the run failed in 'hold'", 100).time).toBe(95);
    const one = session("the run failed in 'hold'");
    expect(one.time).toBe(7.5);
    one.jump(true);
    expect(one.time).toBe(10);
    expect(one.notable().pop()).toEqual({ time: 10, text: "the run failed in 'hold'", isGrave: true });
  });

  // A barge that capsized, a rope that left its chart and a pair that came too close were stepped over.
  it("steps to what a reader must not miss, and says that it is grave", () => {
    const one = session();
    one.lift.header.events = [
      [1, "overload", "goliath.U1"],
      [2, "capsized", "barge"],
      [2, "cut", "sling.S1"],
      [3, "slip", "block.1"],
    ];
    expect(one.notable()).toEqual([
      { time: 1, text: "overload goliath.U1", isGrave: true },
      { time: 2, text: "capsized barge, cut sling.S1", isGrave: true },
    ]);
  });

  // A barge beside another in swell left and met its fenders 216 times in 600 s: the time line was a fence.
  it("tells the ends of what comes again and again", () => {
    const one = session();
    (one.lift as { end: number }).end = 100;
    const lifted = [3, 7, 16, 25.9, 40, 60, 65];
    one.lift.header.events = lifted.map((time) => [time, "lift_off", "module"]);
    one.lift.header.events.splice(
      2,
      0,
      [8, "lift_off", "other"],
      [9, "lift_off", "fender.ps"],
      [9, "set_down", "guide.fore"],
    );
    expect(one.notable().map(({ time }) => time)).toEqual([3, 8, 25.9, 40, 60, 65]);
    one.lift.header.events = [1, 2, 3].map((time) => [time, "step_begin", "hoist"]);
    expect(one.notable().length).toBe(3);
  });

  it("pins only ropes that there are, and refuses times that are none", () => {
    const one = session();
    one.pin("r");
    expect(one.pinned).toBe("r");
    one.pin("nobody");
    expect(one.pinned).toBe(null);
    one.seek(Number.NaN);
    expect(one.time).toBe(0);
    one.show(5, 5);
    expect(one.span).toEqual([0, 10]);
    one.show(8, 99);
    expect(one.span).toEqual([8, 10]);
  });

  it("stays at the end of a lift that goes on, unless somebody looks elsewhere", () => {
    const one = session();
    one.lift.append = () => {
      (one.lift as { end: number }).end += 5;
    };
    one.append(null as never);
    expect([one.time, one.span]).toEqual([0, [0, 15]]);
    one.seek(15);
    one.append(null as never);
    expect([one.time, one.span]).toEqual([20, [0, 20]]);
    one.show(2, 3);
    one.append(null as never);
    expect(one.span).toEqual([2, 3]);
  });

  it("tells each listener until it has had enough", () => {
    const one = session();
    let told = 0;
    const end = one.on("time", () => {
      told += 1;
    });
    one.seek(1);
    end();
    one.seek(2);
    expect(told).toBe(1);
  });

  it("chooses a speed at which a lift takes a minute at most", () => {
    expect([usualSpeed(40), usualSpeed(300), usualSpeed(1e9)]).toEqual([1, 5, 20]);
  });
});

describe("drawing", () => {
  it("measures to the nearest point of a piece", () => {
    expect(distanceToPiece(5, 3, [0, 0], [10, 0])).toBe(3);
    expect(distanceToPiece(-3, 4, [0, 0], [10, 0])).toBe(5);
    expect(distanceToPiece(3, 4, [0, 0], [0, 0])).toBe(5);
  });

  it("lays a grid of round metres", () => {
    expect([0.08, 1.2, 3.3, 6, 40].map(niceCell)).toEqual([0.1, 1, 2, 5, 50]);
  });

  it("cuts the ground to what is outside of a hole, and a shadow to what is inside", () => {
    const hole = { x: [10, 70] as [number, number], y: [-200, 200] as [number, number], floor: -12 };
    const origin = [20, 5, 0];
    const sides = (planes: Plane[], x: number, y: number) =>
      planes.map((plane) => plane.distanceToPoint(new Vector3(x - 20, y - 5, 0)) < 0);
    const outside = outsideOf([hole], origin);
    // Of an intersection only what is behind all planes is cut.
    expect(outside.clipIntersection).toBe(true);
    const places = [
      [40, 0, true],
      [9, 0, false],
      [71, 0, false],
      [40, -201, false],
      [40, 201, false],
    ] as const;
    for (const [x, y, isInside] of places) {
      expect(sides(outside.clippingPlanes!, x, y).every((cut) => cut)).toBe(isInside);
      expect(sides(insideOf(hole, origin).clippingPlanes!, x, y).some((cut) => cut)).toBe(!isInside);
    }
    expect(outsideOf([], origin)).toEqual({});
    expect(holesUnder({ holes: [hole] }, [0, 0, 0], [20, 9, 9])).toEqual([hole]);
    expect(holesUnder({ holes: [hole] }, [0, 0, 0], [10, 9, 9])).toEqual([]);
  });

  it("draws a line between the nearest points of a watched pair, in another colour where it is too short", () => {
    let tooClose = false;
    const lift = {
      nearest: Float64Array.of(1, 2, 3, 4, 2, 3),
      header: { pairs: [{ name: "p", smallest: 1 }] },
      isTooClose: () => tooClose,
    } as unknown as Lift;
    const drawn = new Clearances(lift, [1, 1, 1]);
    const { lines } = drawn;
    const palette = paletteOf("light");
    const colour = () => [0, 1, 2].map((part) => lines.geometry.attributes.instanceColorStart!.array[part]!);
    drawn.update(palette);
    expect([...lines.geometry.attributes.instanceStart!.array]).toEqual([0, 1, 2, 3, 1, 2]);
    const usual = colour();
    tooClose = true;
    drawn.update(palette);
    expect(colour()).not.toEqual(usual);
  });

  it("draws sheaves and shadows with few triangles where drawing is slow", () => {
    const [fine, plain] = [sheaveGeometry(), plainSheaveGeometry()];
    const count = (geometry: BufferGeometry) =>
      (geometry.index ? geometry.index.count : geometry.attributes.position!.count) / 3;
    expect(count(plain)).toBeLessThan(count(fine) / 5);
    expect(count(hullOf(new SphereGeometry(1, 8, 6).toNonIndexed()))).toBeGreaterThan(8);
    const box = new Box3().setFromBufferAttribute(plain.attributes.position as BufferAttribute);
    expect(box.max.x).toBeLessThanOrEqual(1);
  });

  it("shows the walls and the floor of a pit from within", () => {
    const { floor, walls, edges } = pitOf({ x: [0, 2], y: [0, 4], floor: -3 }, 1);
    const middle = new Vector3(1, 2, -1);
    let area = 0;
    for (const places of [floor, walls])
      for (let at = 0; at < places.length; at += 9) {
        const [a, b, c] = [0, 3, 6].map((corner) => new Vector3().fromArray(places, at + corner));
        const normal = b!.clone().sub(a!).cross(c!.clone().sub(a!));
        expect(normal.dot(middle.clone().sub(a!))).toBeGreaterThan(0);
        area += normal.length() / 2;
      }
    // The floor 2 by 4, and walls 4 high all around.
    expect(area).toBeCloseTo(2 * 4 + 4 * (2 + 4 + 2 + 4), 6);
    expect(Math.min(...edges.filter((_, at) => at % 3 === 2))).toBe(-3);
  });

  it("lets supports stand until they are taken away", () => {
    const corners = [0, 1].flatMap((x) => [0, 2].flatMap((y) => [0, 3].map((z) => [x, y, z] as Vector)));
    const made = { name: "support.a", kind: "support" as const, boxes: [corners] };
    const header = {
      structures: [
        { ...made, removedAt: 5 },
        { ...made, removedAt: null },
      ],
    };
    const lift = { header, now: 4.9 } as unknown as Lift;
    const structures = new Structures(lift, [10, 0, 0]);
    structures.update();
    expect(structures.group.children.map((one) => one.visible)).toEqual([true, true]);
    lift.now = 5;
    structures.update();
    expect(structures.group.children.map((one) => one.visible)).toEqual([false, true]);
    const box = new Box3().setFromObject(structures.group);
    expect([...box.min.toArray(), ...box.max.toArray()]).toEqual([-10, 0, 0, -9, 2, 3]);
    const mesh = structures.group.children[0]!.children[0] as Mesh;
    const places = mesh.geometry.attributes.position!;
    // The sum of the volumes under its faces is that of the box if all of them look outwards.
    let volume = 0;
    for (let at = 0; at < places.count; at += 3) {
      const [a, b, c] = [0, 1, 2].map((corner) => new Vector3().fromBufferAttribute(places, at + corner));
      volume += a!.dot(b!.cross(c!)) / 6;
    }
    expect(volume).toBeCloseTo(6, 6);
    const none = new Structures({ header: { structures: [] }, now: 0 } as unknown as Lift, [0, 0, 0]);
    expect(none.group.children).toEqual([]);
  });

  it("shows a hinge where it is until it lets its load go", () => {
    const body = { kind: "hinge", shape: null, cog: [0, 0, 0] };
    const header = {
      bodies: [
        { ...body, name: "load", kind: "load", shape: { type: "box", size: [4, 1, 1], centre: [0, 0, 0] } },
      ],
      ground: null,
      holes: [],
      sheaves: [],
      lugs: [],
      hinges: [] as object[],
    };
    header.bodies.push({ ...body, name: "foot" } as never);
    header.hinges.push({ body: 1, openedAt: 5 });
    const poses = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 3, 0, 2, 1, 0, 0, 0);
    const lift = { header, poses, now: 4.9, pinOf: Lift.prototype.pinOf } as unknown as Lift;
    const bodies = new Bodies(lift, [1, 0, 0], 100);
    bodies.update();
    const pin = bodies.holders[1]!;
    expect([pin.visible, ...pin.position.toArray()]).toEqual([true, 2, 0, 2]);
    // A ring about the axis of the hinge, its own y, of 1.3 % of the scene; the pin in it reaches out at its ends.
    const box = new Box3().setFromObject(pin.children[0]!);
    const size = box.getSize(new Vector3());
    expect(size.x).toBeCloseTo(2.6, 1);
    expect(size.z).toBeCloseTo(2.6, 1);
    expect(size.y).toBeCloseTo(2.6 * 1.3, 1);
    lift.now = 5;
    bodies.update();
    expect([pin.visible, bodies.holders[0]!.visible]).toEqual([false, true]);
  });

  it("colours by tension from the first to the last colour, and no further", () => {
    const palette = paletteOf("light");
    const out = new Float32Array(3);
    rampInto(palette, 0, out, 0);
    expect([...out]).toEqual([...Float32Array.from(palette.ramp[0]!)]);
    rampInto(palette, 7, out, 0);
    expect([...out]).toEqual([...Float32Array.from(palette.ramp[palette.ramp.length - 1]!)]);
  });
});

describe("the room of a lift", () => {
  it("leaves out how far mooring lines go", () => {
    const rope = (kind: string, first: number) => ({ kind, first, count: 2 });
    const lift = {
      header: {
        bodies: [],
        ropes: [rope("rope", 0), rope("outer", 2)],
        water: null,
        ground: null,
        holes: [],
      },
      frameTimes: Float64Array.of(0),
      path: Float64Array.of(0, 0, 0, 2, 4, 6, 0, 0, 0, 500, 0, 0),
      poses: new Float64Array(),
      seek: () => {},
      begin: 0,
    } as unknown as Lift;
    expect(extentOf(lift).high).toEqual([2, 4, 6]);
  });

  it("has what pushes from below the ground, which lay under the buttons of a phone", () => {
    const contact = { body: 0, at: [3, 0, 0] };
    const lift = {
      header: {
        bodies: [{ cog: [0, 0, 1] }],
        contacts: [contact, contact, contact],
        ropes: [{ name: "sling", peak: 100e3 }],
        lugs: [{ rope: "sling" }],
      },
      contactForces: Float64Array.of(50e3, 100, 300e3),
      poses: Float64Array.of(10, 20, 1, 1, 0, 0, 0),
    } as unknown as Lift;
    // 0.2 of 40 m for as much as the largest sling: a half of 8 m, nothing for what is not drawn, 1.2 at most.
    const tails = new Arrows(lift, [10, 20, 0], 40).tails();
    [3, 0, -4, 3, 0, -9.6].forEach((value, at) => {
      expect(tails[at]).toBeCloseTo(value, 12);
    });
    expect(tails).toHaveLength(6);
  });
});
