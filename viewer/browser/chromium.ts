/** The system's Chromium, without a network, opening pages that Python has written. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { type Browser, chromium, type Page } from "playwright-core";
import type {} from "../src/main";

declare global {
  var hacked: unknown;
}

const folder = process.env.GANTLINE_PAGES!;

/** What the recording has, as Python wrote it. */
export interface Expected {
  times: number[];
  ropes: Record<string, number[]>;
  paths: Record<string, number[][][]>;
  bodies: Record<string, { position: number[]; orientation: number[] }[]>;
  lengths: Record<string, number[]>;
  frames: number[];
  liftOff: number;
  stepBegins: number[];
}

export function expected(): Expected {
  return JSON.parse(readFileSync(join(folder, "expected.json"), "utf-8")) as Expected;
}

export function start(): Promise<Browser> {
  // Without a sandbox since tests may run as root in a container; the pages are our own.
  const args = ["--no-sandbox", "--enable-unsafe-swiftshader"];
  // Where the locale is plain C it would not find a folder whose name is more than ASCII, that of downloads for one.
  const env = { ...process.env, LC_ALL: "C.UTF-8" };
  return chromium.launch({ executablePath: process.env.GANTLINE_CHROMIUM!, args, env });
}

export interface Opened {
  page: Page;
  /** Errors, warnings of the security policy, and requests for anything but the page itself. */
  troubles: string[];
}

export interface Wishes {
  width?: number;
  height?: number;
  dark?: boolean;
  touch?: boolean;
  hash?: string;
}

/** A page with the list that its troubles go to, and the address that it may ask for: both change with each test. */
interface Watched extends Opened {
  address: string;
  hasTouch: boolean;
}

/** By browser: pages with a lift, and those that are empty again. */
const pages = new WeakMap<Browser, { open: Watched[]; empty: Watched[] }>();

function pagesOf(browser: Browser): { open: Watched[]; empty: Watched[] } {
  if (!pages.has(browser)) pages.set(browser, { open: [], empty: [] });
  return pages.get(browser)!;
}

async function newPage(browser: Browser, hasTouch: boolean): Promise<Watched> {
  const context = await browser.newContext({ offline: true, hasTouch });
  const page = await context.newPage();
  const watched: Watched = { page, troubles: [], address: "", hasTouch };
  page.on("pageerror", (problem) => watched.troubles.push(problem.message));
  page.on("dialog", (dialog) => {
    watched.troubles.push(`dialog ${dialog.message()}`);
    void dialog.dismiss();
  });
  page.on("console", (message) => {
    // Reading pixels back is slow in software; Chromium says so.
    if (message.type() === "error" || /security policy/i.test(message.text()))
      watched.troubles.push(message.text());
  });
  page.on("request", (request) => {
    if (!request.url().startsWith(watched.address) && !/^(data|blob):/.test(request.url()))
      watched.troubles.push(request.url());
  });
  return watched;
}

/**
 * A page by its file's address, with the network off.
 *
 * It is one that an earlier test has done with where there is one: two processes that begin for a page of its own take
 * more time than the lift that it shows.
 */
export async function open(browser: Browser, file: string, wishes: Wishes = {}): Promise<Opened> {
  const { open, empty } = pagesOf(browser);
  const watched = (wishes.touch ? undefined : empty.pop()) ?? (await newPage(browser, wishes.touch ?? false));
  open.push(watched);
  const { page } = watched;
  await page.setViewportSize({ width: wishes.width ?? 1000, height: wishes.height ?? 700 });
  await page.emulateMedia({ media: null, colorScheme: wishes.dark ? "dark" : "light" });
  watched.troubles = [];
  watched.address = pathToFileURL(join(folder, file)).href;
  await page.goto(watched.address + (wishes.hash ?? ""));
  await page.waitForSelector("html[data-ready]", { timeout: 40_000 });
  // A page is ready before it has been laid out: its drawing gets its size, and the lift its time, in a frame.
  await drawn(page);
  return { page, troubles: watched.troubles };
}

/** For after each test: pages that stay open go on drawing, and make the tests that follow slower and slower. */
export async function closePages(browser: Browser): Promise<void> {
  const { open, empty } = pagesOf(browser);
  for (const watched of open.splice(0)) {
    const { page, hasTouch } = watched;
    // One is enough for those that follow, but for the few that open two.
    if (hasTouch || empty.length > 0) {
      await page.context().close();
      continue;
    }
    await page.goto("about:blank");
    await page.mouse.move(0, 0); // where the next page has nothing that shows that the mouse is over it
    empty.push(watched);
  }
}

/** Two frames, so that what was to be drawn in the next one has been. */
async function drawn(page: Page): Promise<void> {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** For `expect.poll`, on a machine that has much else to do. */
export const PATIENTLY = { timeout: 40_000 };

/** What there is to see on a page once two looks, some frames apart, see the same. */
export async function settled<Seen>(page: Page, look: () => Seen): Promise<Seen> {
  for (let before = ""; ; ) {
    await drawn(page);
    await page.waitForTimeout(200);
    const seen = await page.evaluate(look);
    const now = JSON.stringify(seen);
    if (now === before) return seen as Seen;
    before = now;
  }
}

/** Seconds that the player shows. */
export async function clock(page: Page): Promise<number> {
  return Number.parseFloat((await page.locator(".gl-clock").textContent())!);
}
