/** What the player shows of a lift at first, in drawings of all sizes, and what of the screen it takes. */

import type { Browser, Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, describe, expect, it } from "vitest";
import { closePages, open, PATIENTLY, settled, start } from "./chromium";

let browser: Browser;
beforeAll(async () => {
  browser = await start();
});
afterEach(() => closePages(browser));
afterAll(() => browser.close());

interface Seen {
  /** Of all that the lift takes over its time: how much of the drawing it covers across and up. */
  across: number;
  up: number;
  /** Least distance from an edge of the drawing [pixels]. */
  least: number;
  /** What lies on it. */
  covering: string[];
}

/** Where the lift is in the drawing, once that stands still. */
function seen(page: Page): Promise<Seen> {
  return settled(page, () => {
    const { world, root } = globalThis.gantlinePage!.player!.stage!;
    const { points, middle } = world.extent;
    const [width, height] = [root.clientWidth, root.clientHeight];
    const places: [number, number][] = [];
    for (let at = 0; at < points.length; at += 3) {
      const [x, y, z] = [0, 1, 2].map((axis) => points[at + axis]! + middle[axis]!);
      places.push(world.project(x!, y!, z!, width, height)!);
    }
    const [across, down] = [0, 1].map((axis) => places.map((place) => place[axis]!));
    const most = [Math.max(...across!), Math.max(...down!)] as const;
    const least = [Math.min(...across!), Math.min(...down!)] as const;
    const boxes = [...root.querySelectorAll<HTMLElement>(".gl-views, .gl-switches, .gl-ramp-box")];
    const covering = boxes.filter((box) =>
      places.some(
        ([x, y]) =>
          x > box.offsetLeft &&
          x < box.offsetLeft + box.offsetWidth &&
          y > box.offsetTop &&
          y < box.offsetTop + box.offsetHeight,
      ),
    );
    return {
      across: (most[0] - least[0]) / width,
      up: (most[1] - least[1]) / height,
      least: Math.min(...least, width - most[0], height - most[1]),
      covering: covering.map((box) => box.className),
    };
  });
}

function expectFitted(now: Seen): void {
  expect(now.least).toBeGreaterThanOrEqual(11); // 12 pixels stay free
  expect(now.covering).toEqual([]);
  // Legend and buttons leave more than half of the drawing.
  expect(Math.max(now.across, now.up)).toBeGreaterThan(0.55);
}

const SIZES = [
  ["wide", 1440, 800],
  ["square", 900, 900],
  ["an upright phone", 390, 844],
  ["a phone on its side", 844, 390],
] as const;

describe("the first view", () => {
  it.each(["report.html", "afloat.html"].flatMap((file) => SIZES.map((size) => [file, ...size] as const)))(
    "holds the whole lift of %s, as large as buttons and legend let it be: %s",
    async (file, _, width, height) => {
      const { page } = await open(browser, file, { width, height });
      expectFitted(await seen(page));
    },
  );

  it("is fitted again to another size, until somebody moves the camera", async () => {
    const { page } = await open(browser, "report.html", { width: 1440, height: 800 });
    const first = await seen(page);
    await page.setViewportSize({ width: 390, height: 844 });
    const turned = await seen(page);
    expect(turned.up).not.toBeCloseTo(first.up, 2);
    expectFitted(turned);
    await page.locator(".gl-canvas").focus();
    await page.keyboard.press("+");
    const state = () => page.evaluate(() => globalThis.gantlinePage!.player!.stage!.cameras.state());
    const moved = await state();
    await page.setViewportSize({ width: 844, height: 390 });
    await seen(page);
    expect(await state()).toEqual(moved);
    await page.keyboard.press("1");
    expectFitted(await seen(page));
  });

  it("is fitted where the player was hidden at first", async () => {
    const { page } = await open(browser, "report.html", { width: 1440, height: 800 });
    const hide = (display: string) =>
      page.evaluate((display) => {
        document.querySelector<HTMLElement>(".gl-player")!.style.display = display;
      }, display);
    await hide("none");
    await page.setViewportSize({ width: 390, height: 844 });
    await page.waitForTimeout(200);
    await hide("");
    expectFitted(await seen(page));
  });

  it("is not moved by a press that pins a rope, but by a drag", async () => {
    const { page } = await open(browser, "report.html");
    const canvas = page.locator(".gl-canvas");
    await canvas.scrollIntoViewIfNeeded();
    const box = (await canvas.boundingBox())!;
    const isMoved = () => page.evaluate(() => globalThis.gantlinePage!.player!.stage!.cameras.isMoved);
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    expect(await isMoved()).toBe(false);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 40, box.y + box.height / 2, { steps: 3 });
    await page.mouse.up();
    expect(await isMoved()).toBe(true);
    await expect.poll(() => page.evaluate(() => location.hash), PATIENTLY).toContain("camera=");
  });
});

describe("a link", () => {
  it("leads to the camera that it names, where a body is followed that has moved", async () => {
    const camera = [10, -40, 5, 0, 0, 2];
    const { page } = await open(browser, "report.html", { hash: `#t=39&view=load&camera=${camera}` });
    // The load has risen by more than half a metre until then.
    const found = await settled(page, () => globalThis.gantlinePage!.player!.stage!.cameras.state());
    expect(found).toEqual(camera);
  });
});

describe("on a small screen", () => {
  it.each([
    [844, 390],
    [667, 375],
  ])("drawing and bar are seen together where a phone lies on its side: %i by %i", async (width, height) => {
    const { page } = await open(browser, "report.html", { width, height });
    const [player, stage] = await settled(page, () =>
      [".gl-player", ".gl-stage"].map((one) => document.querySelector(one)!.getBoundingClientRect().height),
    );
    expect(player).toBeLessThanOrEqual(height);
    expect(stage).toBeGreaterThan(0.8 * height);
    expect(await page.evaluate(() => document.scrollingElement!.scrollWidth)).toBe(width);
  });

  it("a drawing that fills a phone on its side keeps most of it where a rope is pinned", async () => {
    const { page } = await open(browser, "report.html", { width: 844, height: 390, hash: "#pin=sling.S1" });
    await page.getByRole("button", { name: "Full screen" }).click();
    const stage = await settled(
      page,
      () => document.querySelector(".gl-player:fullscreen .gl-stage")?.getBoundingClientRect().height ?? 0,
    );
    expect(stage).toBeGreaterThan(0.6 * 390);
    expect(await page.locator(".gl-pinned-value").isVisible()).toBe(true);
  });

  it.each([360, 390, 418])("the bar of an upright phone takes three lines: %i pixels", async (width) => {
    const { page } = await open(browser, "report.html", { width, height: 740 });
    const lines = await settled(page, () => [
      ...new Set(
        [...document.querySelectorAll(".gl-bar > :not(.gl-said)")].map((one) => {
          const { top, height } = one.getBoundingClientRect();
          return Math.round(top + height / 2);
        }),
      ),
    ]);
    expect(lines.length).toBe(3);
    const cut = await page.locator(".gl-clock").evaluate((one) => one.scrollWidth - one.clientWidth);
    expect(cut).toBe(0);
  });
});
