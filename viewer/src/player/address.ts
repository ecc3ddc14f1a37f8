/** What is shown, in the address of the page, so that a link leads to it. */

import { isView, type View } from "../scene/cameras";

export interface Shown {
  time?: number;
  view?: View;
  camera?: number[];
  pinned?: string;
  speed?: number;
  span?: [number, number];
}

/** The part of an address behind `#`; empty of anything that is not understood. */
export function parse(hash: string): Shown {
  const given = new URLSearchParams(hash.replace(/^#/, ""));
  const shown: Shown = {};
  const time = number(given.get("t"));
  if (time !== null) shown.time = time;
  const view = given.get("view");
  if (view !== null && isView(view)) shown.view = view;
  const camera = numbers(given.get("camera"));
  if (camera.length === 6) shown.camera = camera;
  const pinned = given.get("pin");
  if (pinned) shown.pinned = pinned;
  const speed = number(given.get("speed"));
  if (speed !== null && speed > 0 && speed <= 100) shown.speed = speed;
  const [begin, end] = numbers(given.get("span"));
  if (begin !== undefined && end !== undefined) shown.span = [begin, end];
  return shown;
}

export function written(shown: Shown): string {
  const parts: string[] = [];
  if (shown.time !== undefined) parts.push(`t=${round(shown.time)}`);
  if (shown.view !== undefined) parts.push(`view=${shown.view}`);
  if (shown.camera !== undefined) parts.push(`camera=${shown.camera.map(round).join(",")}`);
  if (shown.pinned !== undefined) parts.push(`pin=${encodeURIComponent(shown.pinned)}`);
  if (shown.speed !== undefined) parts.push(`speed=${shown.speed}`);
  if (shown.span !== undefined) parts.push(`span=${shown.span.map(round).join(",")}`);
  return parts.length > 0 ? `#${parts.join("&")}` : "";
}

function number(text: string | null): number | null {
  const value = text === null || text.trim() === "" ? Number.NaN : Number(text);
  return Number.isFinite(value) ? value : null;
}

function numbers(text: string | null): number[] {
  const found = (text ?? "").split(",").map((part) => number(part));
  return found.every((part) => part !== null) ? (found as number[]) : [];
}

function round(value: number): number {
  return Math.round(value * 1000) / 1000;
}
