/** Pictures of the sections of reports, as a reader has them: on a desktop, on a phone, on paper. */

import { join } from "node:path";
import type { Browser } from "playwright-core";
import { afterAll, beforeAll, it } from "vitest";
import { open, start } from "./chromium";

const MILLIMETRE = 96 / 25.4; // pixels of CSS
const SETTLED = 1200; // ms until what was still has been drawn finely

interface Wanted {
  page: string;
  /** CSS selector of what is shown, by the name of its picture. */
  parts: Record<string, string>;
  width: number;
  dark?: boolean;
  print?: boolean;
  hash?: string;
}

const DESKTOP = 1100;
const WANTED: Wanted[] = [
  { page: "goliath", width: DESKTOP, parts: { report_lift: "#lift" } },
  { page: "goliath", width: DESKTOP, hash: "#t=186", parts: { report_player: ".gl-player" } },
  {
    page: "goliath",
    width: DESKTOP,
    hash: "#t=186",
    parts: { report_tensions: "#tensions", report_hooks: "#hooks" },
  },
  {
    page: "goliath",
    width: DESKTOP,
    dark: true,
    hash: "#t=186",
    parts: {
      report_equalizers: "#equalizers",
      report_attitude: "#attitude",
      report_clearance: "#clearance",
      report_checks: "#checks",
      report_energy: "#energy",
    },
  },
  {
    page: "goliath",
    width: DESKTOP,
    parts: { report_statics: "#statics", report_modes: "#modes" },
  },
  {
    page: "floating_crane",
    width: DESKTOP,
    hash: "#t=2000",
    parts: { report_afloat: "#lift", report_player_afloat: ".gl-player", report_vessels: "#vessels" },
  },
  {
    page: "goliath",
    width: 390,
    dark: true,
    hash: "#t=186",
    parts: { report_phone: ".gl-player", report_phone_lift: "#lift .sheet > .verdict" },
  },
  { page: "goliath", width: Math.round(186 * MILLIMETRE), print: true, parts: { report_page: ".sheet" } },
];

let browser: Browser;
beforeAll(async () => {
  browser = await start();
});
afterAll(() => browser.close());

it.each(WANTED)("draws $page at $width pixels", async ({ page: name, parts, width, print, ...wishes }) => {
  const { page } = await open(browser, `${name}.html`, { ...wishes, width, height: 900 });
  if (print) await page.emulateMedia({ media: "print" });
  // What stays in sight while one scrolls would lie over the section.
  await page.evaluate(() => document.querySelector("header.top")?.remove());
  for (const [picture, selector] of Object.entries(parts)) {
    const part = page.locator(selector).first();
    await part.scrollIntoViewIfNeeded();
    await page.waitForTimeout(SETTLED);
    await part.screenshot({ path: join(process.env.GANTLINE_PICTURES!, `${picture}.png`) });
  }
  await page.context().close();
});
