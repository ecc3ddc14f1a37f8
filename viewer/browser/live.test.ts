import type { Browser } from "playwright-core";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { expected, start } from "./chromium";

let browser: Browser;
beforeAll(async () => {
  browser = await start();
});
afterAll(() => browser.close());

describe("a lift that runs", () => {
  it("is followed to its end, and then is what the recording has", async () => {
    const page = await browser.newPage();
    const troubles: string[] = [];
    page.on("pageerror", (problem) => troubles.push(problem.message));
    // The lift goes on when the page asks for more: not before its beginning has been looked at.
    let lookedAt = () => {};
    const begun = new Promise<void>((tell) => {
      lookedAt = tell;
    });
    await page.route("**/live/*", async (route) => {
      await begun;
      await route.continue();
    });
    await page.goto(process.env.GANTLINE_LIVE!);
    await page.waitForSelector("html[data-ready]", { timeout: 40_000 });
    const state = () =>
      page.evaluate(() => {
        const { session } = globalThis.gantlinePage!;
        return { end: session.lift.end, time: session.time, samples: session.lift.header.samples };
      });
    // Who comes without having been sent to a time looks at the end, and stays there.
    const first = await state();
    expect(first.time).toBe(first.end);
    // Who listens is told that it runs, not how far it is, ten times a second.
    const heard = await page.locator(".gl-live").ariaSnapshot();
    expect(heard).toBe("- status: The lift is being simulated");
    await page.evaluate(() => globalThis.gantlinePage!.session.pin("sling.S1"));
    lookedAt();
    await page.waitForFunction(
      () => document.querySelector(".gl-live")?.getAttribute("data-ended") === "done",
      undefined,
      { timeout: 40_000 },
    );
    expect(await page.locator(".gl-live").textContent()).toBe("The lift has been simulated: 40.0 of 40.0 s");
    const found = await state();
    const { times, ropes, paths, frames } = expected();
    expect(found.end).toBeGreaterThan(first.end); // it grew while the page was open
    expect(found.samples).toBe(times.length);
    expect(found.end).toBeCloseTo(40, 9);
    expect(found.time).toBe(found.end);
    const last = await page.evaluate(() => {
      const { lift } = globalThis.gantlinePage!.session;
      lift.seek(lift.end);
      const index = lift.header.ropes.findIndex((rope) => rope.name === "sling.S1");
      return { path: [...lift.drawnPath(index)], tension: lift.tensions[index]! };
    });
    expect(last.tension).toBeCloseTo(ropes["sling.S1"]!.at(-1)!, -1);
    const recorded = paths["sling.S1"]![frames.length - 1]!.flat();
    expect(last.path.length).toBe(recorded.length);
    for (const [place, part] of last.path.entries())
      expect(Math.abs(part - recorded[place]!)).toBeLessThan(1e-6);
    expect(await page.locator(".gl-slider").getAttribute("max")).toBe(String(found.end));
    // What is told of peaks is that of all that has been recorded, not of what there was when the page was opened.
    const told = await page.evaluate(() => {
      const { player, session } = globalThis.gantlinePage!;
      const { ropes, lugs } = session.lift.header;
      const peaks = ropes
        .filter((rope) => lugs.some((lug) => lug.rope === rope.name))
        .map((rope) => rope.peak);
      const { peak, peakTime } = ropes.find((rope) => rope.name === "sling.S1")!;
      return {
        most: `at most ${(peak / 1e3).toFixed(1)} kN at ${peakTime.toFixed(2)} s`,
        pinned: document.querySelector(".gl-pinned-head .gl-quiet")!.textContent,
        inWords: document.querySelector(".gl-pinned .gl-plot")!.getAttribute("aria-label"),
        curve: `to ${(peak / 1e3).toFixed(1)} kN`,
        scale: player!.stage!.world.arrows.largest,
        largest: Math.max(...peaks),
      };
    });
    expect(told.pinned).toContain(told.most);
    expect(told.inWords).toContain(told.curve);
    expect(told.scale).toBe(told.largest);
    expect(troubles).toEqual([]);
    await page.close();
  });
});
