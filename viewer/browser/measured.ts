/** What a page costs, in time of the processor: a machine that does other things too measures the same. */

import { readdirSync, readFileSync } from "node:fs";
import type { Page } from "playwright-core";

const TICK = 10; // ms, of Linux

/** Time that all processes started from here have had [ms]; null where /proc does not tell. */
export function processorTime(): number | null {
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
export async function scriptTime(page: Page): Promise<() => Promise<number>> {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  return async () => {
    const { metrics } = await session.send("Performance.getMetrics");
    return 1000 * metrics.find((metric) => metric.name === "ScriptDuration")!.value;
  };
}
