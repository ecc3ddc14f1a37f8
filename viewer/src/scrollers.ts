/** Boxes that hold more than they show: keys alone must reach them, to scroll them. */

import { set } from "./dom";

/** Put every box that scrolls into the order of the keys, as long as it has something to scroll. */
export function reachScrollers(boxes: Iterable<HTMLElement>): void {
  const sizes = new ResizeObserver((entries) => {
    for (const { target } of entries) reach(target as HTMLElement);
  });
  for (const box of boxes) sizes.observe(box);
}

function reach(box: HTMLElement): void {
  const scrolls = box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight;
  const title = box.parentElement?.querySelector("h2, h3")?.firstChild?.textContent?.trim() ?? "Table";
  set(box, {
    tabindex: scrolls ? 0 : undefined,
    role: scrolls ? "group" : undefined,
    "aria-label": scrolls ? `${title}, scrolls` : undefined,
  });
}
