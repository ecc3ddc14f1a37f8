/** The drawing on paper: browsers print the canvas of a graphics card empty, one of plain pixels as it is. */

import { element } from "../dom";

/** A place for a copy of a drawing, seen on paper only; the drawing is as it shall look there while it is copied. */
export function onPaper(
  canvas: HTMLCanvasElement,
  print: { before: () => void; after: () => void },
): HTMLCanvasElement {
  const copy = element("canvas", { class: "gl-on-paper", "aria-hidden": "true" });
  addEventListener("beforeprint", () => {
    // Copied at once, since what was drawn is lost as soon as the browser has shown it.
    print.before();
    [copy.width, copy.height] = [canvas.width, canvas.height];
    copy.getContext("2d")!.drawImage(canvas, 0, 0);
  });
  addEventListener("afterprint", print.after);
  return copy;
}
