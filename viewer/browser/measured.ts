/** What a page costs, in time of the processor: a machine that does other things too measures the same. */

import { readdirSync, readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import type {} from "../src/main";

const TICK = 10; // ms, of Linux

/** Time that all processes started from here have had [ms]; null where /proc does not tell. */
function processorTime(): number | null {
  const parents = new Map<number, number>();
  const times = new Map<number, number>();
  try {
    for (const name of readdirSync("/proc")) {
      if (!/^\d+$/.test(name)) continue;
      try {
        const text = readFileSync(`/proc/${name}/stat`, "utf-8");
        const fields = text.slice(text.lastIndexOf(")") + 2).split(" ");
        parents.set(Number(name), Number(fields[1]));
        times.set(Number(name), (Number(fields[11]) + Number(fields[12])) * TICK);
      } catch {
        // It has ended meanwhile.
      }
    }
  } catch {
    return null;
  }
  let sum = 0;
  for (const [process_, time] of times) {
    let above = process_;
    while (above > 1 && above !== process.pid) above = parents.get(above) ?? 0;
    if (above === process.pid && process_ !== process.pid) sum += time;
  }
  return sum;
}

/** Time that scripts of a page have had of their thread [ms]. */
async function scriptTime(page: Page): Promise<() => Promise<number>> {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  return async () => {
    const { metrics } = await session.send("Performance.getMetrics");
    return 1000 * metrics.find((metric) => metric.name === "ScriptDuration")!.value;
  };
}

export interface Playing {
  /** Frames in a second. */
  rate: number;
  /** Time of the processor for each frame, of all processes of the browser [ms]. */
  processor: number;
  /** Time of scripts for each frame [ms]. */
  script: number;
  /** Whether ropes were drawn as thin lines. */
  isCheap: boolean;
}

/** What the player of an open page costs while it plays on and on for some time [ms]. */
export async function playing(page: Page, time: number): Promise<Playing> {
  const scripts = await scriptTime(page);
  await page.evaluate(() => {
    const { player, session } = globalThis.gantlinePage!;
    player!.stage!.canvas.scrollIntoView();
    session.setLoop(true);
    session.play();
  });
  await page.waitForTimeout(1000);
  const frames = () => page.evaluate(() => globalThis.gantlinePage!.player!.stage!.measured.count);
  const begin = {
    frames: await frames(),
    processor: processorTime(),
    script: await scripts(),
    now: Date.now(),
  };
  await page.waitForTimeout(time);
  const count = (await frames()) - begin.frames;
  return {
    rate: (1000 * count) / (Date.now() - begin.now),
    processor: ((processorTime() ?? 0) - (begin.processor ?? 0)) / count,
    script: ((await scripts()) - begin.script) / count,
    isCheap: await page.evaluate(() => globalThis.gantlinePage!.player!.stage!.world.isCheap),
  };
}
