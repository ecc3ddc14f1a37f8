/** Size, opening, frames and script of the pages that `benchmarks/player.py` has written. */

import { readdirSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser } from "playwright-core";
import { afterAll, beforeAll, it } from "vitest";
import { open, start } from "./chromium";
import { type Playing, playing } from "./measured";

const OPENED = 3; // times; the fastest counts

interface Measured extends Playing {
  name: string;
  /** Of the page [bytes]. */
  size: number;
  /** From the request to a page that can be used [ms]. */
  opening: number;
  /** What draws, as WebGL says. */
  renderer: string;
}

let browser: Browser;
beforeAll(async () => {
  browser = await start();
});
afterAll(() => browser.close());

async function measure(file: string): Promise<Measured> {
  // The drawing is then 640 by 360 pixels.
  const wishes = { width: 682, height: 700 };
  const openings: number[] = [];
  for (let round = 0; round < OPENED; round++) {
    const { page } = await open(browser, file, wishes);
    openings.push(await page.evaluate(() => globalThis.gantlinePage!.ready));
    await page.context().close();
  }
  const { page } = await open(browser, file, { ...wishes, hash: "#speed=1" });
  const renderer = await page.evaluate(() => {
    const context = document.createElement("canvas").getContext("webgl")!;
    const info = context.getExtension("WEBGL_debug_renderer_info");
    return String(context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : context.RENDERER));
  });
  const found = await playing(page, 5000);
  await page.context().close();
  const size = statSync(join(process.env.GANTLINE_PAGES!, file)).size;
  return { name: file.replace(/\.html$/, ""), size, opening: Math.min(...openings), renderer, ...found };
}

it("measures every page", async () => {
  const pages = readdirSync(process.env.GANTLINE_PAGES!).filter((name) => name.endsWith(".html"));
  const found: Measured[] = [];
  for (const page of pages.sort()) found.push(await measure(page));
  writeFileSync(join(process.env.GANTLINE_PAGES!, "measured.json"), JSON.stringify(found));
});
