import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser } from "playwright-core";
import { afterAll, afterEach, beforeAll, describe, expect, it } from "vitest";
import { clock, closePages, expected, open, PATIENTLY, settled, start } from "./chromium";

let browser: Browser;
beforeAll(async () => {
  browser = await start();
});
afterEach(() => closePages(browser));
afterAll(() => browser.close());

/** Linear between samples, as the recording is read. */
function at(times: number[], values: number[], time: number): number {
  const next = times.findIndex((one) => one > time);
  if (next <= 0) return values[next === 0 ? 0 : values.length - 1]!;
  const share = (time - times[next - 1]!) / (times[next]! - times[next - 1]!);
  return values[next - 1]! + share * (values[next]! - values[next - 1]!);
}

describe("the player", () => {
  it("opens by its file without a network, and asks for nothing else", async () => {
    const { page, troubles } = await open(browser, "report.html");
    await page.waitForTimeout(300);
    expect(troubles).toEqual([]);
    expect(await page.locator(".gl-canvas").count()).toBe(1);
  });

  it("draws ropes where the solver has them, to a micrometre, and bodies too", async () => {
    const { page } = await open(browser, "report.html");
    const { paths, bodies, frames } = expected();
    const drawn = await page.evaluate(
      ({ frames, ropes, bodies }) => {
        const { lift } = globalThis.gantlinePage!.session;
        return frames.map((time) => {
          lift.seek(time);
          const index = (name: string) => lift.header.ropes.findIndex((rope) => rope.name === name);
          const body = (name: string) => lift.header.bodies.findIndex((one) => one.name === name);
          return {
            paths: ropes.map((name) => (lift.hangs(index(name)) ? null : [...lift.drawnPath(index(name))])),
            poses: bodies.map((name) => [...lift.poses.subarray(7 * body(name), 7 * body(name) + 7)]),
          };
        });
      },
      { frames, ropes: Object.keys(paths), bodies: Object.keys(bodies) },
    );
    let compared = 0;
    drawn.forEach((one, frame) => {
      Object.values(paths).forEach((recorded, rope) => {
        const path = one.paths[rope];
        if (!path) return;
        compared += 1;
        const points = recorded[frame]!.flat();
        expect(path.length).toBe(points.length);
        expect(Math.max(...path.map((part, place) => Math.abs(part - points[place]!)))).toBeLessThan(1e-6);
      });
      Object.values(bodies).forEach((recorded, body) => {
        const pose = [...recorded[frame]!.position, ...recorded[frame]!.orientation];
        // Half a micrometre, and half of 1e-7 for each part of a quaternion.
        expect(
          Math.max(...one.poses[body]!.map((part, place) => Math.abs(part - pose[place]!))),
        ).toBeLessThan(1e-6);
      });
    });
    // All ropes are taut at the end, and most of them before.
    expect(compared).toBeGreaterThan(frames.length * 3);
  });

  it("hangs slack ropes from the same two points by their own length", async () => {
    const { page } = await open(browser, "report.html");
    const { lengths } = expected();
    const found = await page.evaluate(() => {
      const { lift } = globalThis.gantlinePage!.session;
      lift.seek(lift.begin);
      return lift.header.ropes.flatMap((rope, index) => {
        if (!lift.hangs(index) || rope.kind !== "sling") return [];
        const path = lift.drawnPath(index);
        const first = 3 * rope.first;
        const last = 3 * (rope.first + rope.count - 1);
        const ends = [0, 1, 2].flatMap((part) => [
          path[part]! - lift.path[first + part]!,
          path[path.length - 3 + part]! - lift.path[last + part]!,
        ]);
        return [{ name: rope.name, length: rope.length, off: Math.max(...ends.map(Math.abs)) }];
      });
    });
    expect(found.length).toBeGreaterThan(0);
    for (const rope of found) {
      expect(rope.off).toBeLessThan(1e-9);
      expect(rope.length).toBe(lengths[rope.name]![0]);
    }
  });

  it("shows what the recording has for a rope that is clicked", async () => {
    const { page } = await open(browser, "report.html", { hash: "#t=17.5" });
    const { times, ropes } = expected();
    const place = await page.evaluate(() => {
      const { session, player } = globalThis.gantlinePage!;
      const index = session.lift.header.ropes.findIndex((rope) => rope.name === "sling.S1");
      const path = session.lift.drawnPath(index);
      const middle = [0, 1, 2].map((part) => 0.5 * path[part]! + 0.5 * path[path.length - 3 + part]!);
      const canvas = player!.stage!.canvas;
      canvas.scrollIntoView({ block: "center" });
      const box = canvas.getBoundingClientRect();
      const at = player!.stage!.world.project(middle[0]!, middle[1]!, middle[2]!, box.width, box.height)!;
      return { x: box.left + at[0], y: box.top + at[1] };
    });
    await page.mouse.click(place.x, place.y);
    await page.locator(".gl-pinned-name", { hasText: /^sling\.S1 / }).waitFor(PATIENTLY);
    const shown = Number.parseFloat((await page.locator(".gl-pinned-value").textContent())!);
    // Shown with one decimal, and the curve is decimated without losing more than that.
    expect(Math.abs(shown - at(times, ropes["sling.S1"]!, 17.5) / 1e3)).toBeLessThan(0.06);
    // The address follows what is shown, a moment later.
    await expect
      .poll(() => page.evaluate(() => location.hash), PATIENTLY)
      .toMatch(/^#t=17\.5&.*&pin=sling\.S1&/);
  });

  it("plays, stops, and goes where it is told", async () => {
    const { page } = await open(browser, "report.html");
    await page.getByRole("button", { name: "Play (space)" }).click();
    await page.waitForFunction(() => globalThis.gantlinePage!.session.time > 0.3);
    await page.getByRole("button", { name: "Pause (space)" }).click();
    const stopped = await settled(page, () => document.querySelector(".gl-clock")!.textContent);
    await page.waitForTimeout(200);
    expect(await page.locator(".gl-clock").textContent()).toBe(stopped);
    await page.locator(".gl-slider").fill("20");
    expect(await clock(page)).toBe(20);
    await page.getByRole("button", { name: "Previous event (comma)" }).click();
    expect(await clock(page)).toBeCloseTo(expected().liftOff, 1);
  });

  it("is worked by keys alone", async () => {
    const { page } = await open(browser, "report.html");
    await page.locator(".gl-canvas").focus();
    await page.keyboard.press(".");
    expect(await clock(page)).toBeGreaterThan(0);
    await page.keyboard.press("Home");
    await page.keyboard.press("ArrowRight");
    expect(await clock(page)).toBeCloseTo(0.2, 6); // half a hundredth of 40 s
    await page.keyboard.press("2");
    expect(await page.getByRole("button", { name: "side", exact: true }).getAttribute("aria-pressed")).toBe(
      "true",
    );
    await page.keyboard.press(" ");
    expect(await page.evaluate(() => globalThis.gantlinePage!.session.playing)).toBe(true);
    await page.keyboard.press(" ");
    expect(await page.evaluate(() => globalThis.gantlinePage!.session.playing)).toBe(false);
    await page.getByLabel("Pin a rope").focus();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowDown");
    const { ropes } = await page.evaluate(() => globalThis.gantlinePage!.session.lift.header);
    expect(await page.locator(".gl-pinned-name").textContent()).toContain(ropes[1]!.name);
    // Letting go of the rope leaves the keys where they can go on.
    await page.getByRole("button", { name: "Let go of this rope" }).focus();
    await page.keyboard.press("Enter");
    expect(await page.evaluate(() => document.activeElement!.getAttribute("aria-label"))).toBe("Pin a rope");
    // Every control can be reached and says what it is.
    const nameless = await page.evaluate(
      () =>
        [...document.querySelectorAll("button, select, input, a")].filter(
          (one) => !(one.textContent || one.getAttribute("aria-label") || one.getAttribute("title")),
        ).length,
    );
    expect(nameless).toBe(0);
  });

  // Only some of them were heard: no capitals of P, no names, forces and distances but in the drawing, no = to come
  // nearer, no up and down of the slider; and with Alt, which is the browser's, names went.
  it("hears its keys wherever they are pressed, and leaves those of the browser alone", async () => {
    const { page } = await open(browser, "report.html", { hash: "#t=20" });
    const names = () => page.getByRole("button", { name: "Names" }).getAttribute("aria-pressed");
    await page.locator(".gl-play").focus();
    await page.keyboard.press("n");
    expect(await names()).toBe("false");
    await page.keyboard.press("Shift+N");
    expect(await names()).toBe("true");
    await page.locator(".gl-canvas").focus();
    await page.keyboard.press("Alt+n");
    expect(await names()).toBe("true");
    const out = () =>
      page.evaluate(() => {
        const [x, y, z, u, v, w] = globalThis.gantlinePage!.player!.stage!.cameras.state() as number[];
        return Math.hypot(x! - u!, y! - v!, z! - w!);
      });
    const before = await out();
    await page.keyboard.press("=");
    expect(await out()).toBeCloseTo(0.87 * before, 1);
    const waiting = page.waitForEvent("download");
    await page.keyboard.press("Shift+P");
    await waiting;
    await page.locator(".gl-slider").focus();
    await page.keyboard.press("ArrowUp");
    expect(await clock(page)).toBeCloseTo(20.2, 6);
    await page.keyboard.press("ArrowDown");
    expect(await clock(page)).toBe(20);
  });

  // The finger that had not moved was taken for a tap beside all ropes, and the pinned one was let go of.
  it("keeps the pinned rope while two fingers zoom, whichever is lifted first", async () => {
    const { page } = await open(browser, "report.html", { touch: true, hash: "#t=20&pin=sling.S1" });
    const [x, y] = await page.evaluate(() => {
      const { canvas } = globalThis.gantlinePage!.player!.stage!;
      canvas.scrollIntoView({ block: "center" });
      const { left, top, width, height } = canvas.getBoundingClientRect();
      return [left + 0.2 * width, top + 0.5 * height];
    });
    const session = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", ...places: number[]) =>
      session.send("Input.dispatchTouchEvent", {
        type,
        touchPoints: places.map((place, id) => ({ x: place, y: y!, id })),
      });
    const pinned = () => page.evaluate(() => globalThis.gantlinePage!.session.pinned);
    await touch("touchStart", x! + 40);
    await touch("touchStart", x! + 40, x!);
    for (const more of [60, 80, 100]) await touch("touchMove", x! + more, x!);
    await session.send("Input.dispatchTouchEvent", {
      type: "touchEnd",
      touchPoints: [{ x: x!, y: y!, id: 1 }],
    });
    await touch("touchEnd");
    expect(await pinned()).toBe("sling.S1");
    // A tap there does let go of it.
    await page.touchscreen.tap(x!, y!);
    await expect.poll(pinned, PATIENTLY).toBe(null);
  });

  // Names hung upon nothing until the lift moved again.
  it("is drawn again when the browser has given the graphics card back", async () => {
    const { page } = await open(browser, "report.html", { hash: "#t=20" });
    const seen = async () => (await page.locator(".gl-canvas").screenshot()).length;
    const before = await seen();
    await page.evaluate(async () => {
      const { canvas } = globalThis.gantlinePage!.player!.stage!;
      const card = canvas.getContext("webgl2")!.getExtension("WEBGL_lose_context")!;
      const told = (what: string) =>
        new Promise((done) => canvas.addEventListener(what, done, { once: true }));
      const lost = told("webglcontextlost");
      card.loseContext();
      await lost;
      await new Promise((done) => setTimeout(done, 100));
      const restored = told("webglcontextrestored");
      card.restoreContext();
      await restored;
    });
    await expect.poll(seen, PATIENTLY).toBeGreaterThan(0.9 * before);
  });

  it.each([
    ["report.html", 390],
    ["afloat.html", 390],
    ["afloat.html", 1024],
    ["hostile.html", 390],
  ])(
    "has names that cover neither each other nor what lies on the drawing, and are whole: %s, %i pixels",
    async (file, width) => {
      const { page } = await open(browser, file, { width, height: 844, hash: "#t=5" });
      const [stage, ...boxes] = await settled(page, () =>
        [
          ...document.querySelectorAll(
            ".gl-stage, .gl-views, .gl-switches, .gl-ramp-box, .gl-step-now, .gl-label",
          ),
        ]
          .map((one) => one.getBoundingClientRect())
          .filter((one) => one.width > 0)
          .map(({ left, right, top, bottom }) => ({ left, right, top, bottom })),
      );
      expect(boxes.length).toBeGreaterThan(5);
      boxes.forEach((one, index) => {
        expect(one.left).toBeGreaterThanOrEqual(stage!.left - 1);
        expect(one.right).toBeLessThanOrEqual(stage!.right + 1);
        for (const other of boxes.slice(index + 1)) {
          const across = Math.min(one.right, other.right) - Math.max(one.left, other.left);
          const down = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
          expect(Math.min(across, down)).toBeLessThanOrEqual(1); // places are rounded to pixels
        }
      });
    },
  );

  it("says what came of a link that was asked for", async () => {
    const { page } = await open(browser, "report.html");
    // Said a moment after the click, and for some seconds: who looks now and then could miss it.
    const said = page.evaluate(
      () =>
        new Promise((tell) => {
          const place = document.querySelector(".gl-bar [role=status]")!;
          new MutationObserver(() => tell(place.textContent)).observe(place, { childList: true });
        }),
    );
    await page.getByRole("button", { name: "Copy a link to what is shown" }).click();
    expect(await said).toMatch(/^(link copied|the link is in the address bar)$/);
  });

  it("saves what it shows as a picture", async () => {
    const { page, troubles } = await open(browser, "report.html", { hash: "#t=17.5" });
    const waiting = page.waitForEvent("download");
    await page.getByRole("button", { name: "Save a picture (P)" }).click();
    const saved = await waiting;
    expect(saved.suggestedFilename()).toBe("One_equalizer_lifts_a_300_t_load_17.50s.png");
    expect(
      readFileSync(await saved.path())
        .subarray(1, 4)
        .toString(),
    ).toBe("PNG");
    expect(troubles).toEqual([]);
  });

  it("is led by its address to what was shown", async () => {
    const hash = "#t=12.5&view=top&pin=sling.S3&speed=2&span=10,20";
    const { page } = await open(browser, "report.html", { hash });
    const shown = await page.evaluate(() => {
      const { session, player } = globalThis.gantlinePage!;
      return [session.time, player!.stage!.cameras.view, session.pinned, session.speed, session.span];
    });
    expect(shown).toEqual([12.5, "top", "sling.S3", 2, [10, 20]]);
  });

  it("keeps its address in step with view, speed and camera while it stands", async () => {
    // Only time, pinned rope, zoom and a drag of the drawing were written down: who pressed Top, or 2×, or turned
    // the camera by keys and copied the address mailed the view before.
    const { page } = await open(browser, "report.html", { hash: "#t=17.5" });
    const address = () => page.evaluate(() => location.hash);
    await page.getByRole("group", { name: "Views" }).getByText("top").click();
    await expect.poll(address, PATIENTLY).toMatch(/^#t=17\.5&view=top&/);
    await page.getByLabel("Speed, of real time").selectOption("2");
    await expect.poll(address, PATIENTLY).toMatch(/&speed=2$/);
    await page.locator(".gl-canvas").focus();
    await page.keyboard.press("2");
    await expect.poll(address, PATIENTLY).toMatch(/^#t=17\.5&view=side&speed=2$/);
    await page.keyboard.press("ArrowUp");
    await expect.poll(address, PATIENTLY).toMatch(/&view=side&camera=/);
  });

  it("shows where watched pairs are nearest, and that one is too close", async () => {
    const { time, points } = JSON.parse(
      readFileSync(join(process.env.GANTLINE_PAGES!, "watched.json"), "utf-8"),
    ) as { time: number[]; points: number[][][][] };
    const { page, troubles } = await open(browser, "watched.html", { hash: "#t=2" });
    const nearest = await page.evaluate(() => {
      const { lift } = globalThis.gantlinePage!.session;
      lift.seek(2);
      return [...lift.nearest];
    });
    const recorded = points[time.findIndex((one) => Math.abs(one - 2) < 1e-9)]!.flat(2);
    expect(nearest.length).toBe(recorded.length);
    for (const [place, part] of nearest.entries())
      expect(Math.abs(part - recorded[place]!)).toBeLessThan(1e-6);
    const label = page.locator(".gl-label-pair");
    await expect.poll(() => label.textContent(), PATIENTLY).toBe("2.50 m < 3 m");
    await expect.poll(() => label.getAttribute("data-close"), PATIENTLY).toBe(""); // 3 m are asked for
    await page.getByRole("button", { name: "Distances" }).click();
    await label.waitFor({ state: "hidden" });
    const plot = page.locator('[data-gantline-chart*="clearance"]');
    expect(await plot.textContent()).toContain("box - wall");
    expect(troubles).toEqual([]);
  });

  it("draws finely again once nothing moves", async () => {
    const { page } = await open(browser, "yard.html");
    const style = () =>
      page.evaluate(() => {
        const { world, canvas } = globalThis.gantlinePage!.player!.stage!;
        return [world.isCheap, canvas.width / canvas.clientWidth > 1.5];
      });
    await page.evaluate(() => {
      const { session, player } = globalThis.gantlinePage!;
      if (!player!.stage!.world.isCheap)
        [...document.querySelectorAll<HTMLButtonElement>(".gl-chip")]
          .find((one) => one.textContent === "Thin ropes")!
          .click();
      session.play();
    });
    await expect.poll(style, PATIENTLY).toEqual([true, false]);
    await page.evaluate(() => globalThis.gantlinePage!.session.pause());
    const isAntialiased = await page.evaluate(
      () =>
        globalThis.gantlinePage!.player!.stage!.canvas.getContext("webgl2")!.getContextAttributes()!
          .antialias,
    );
    await expect.poll(style, PATIENTLY).toEqual([true, !isAntialiased]);
  });
});
