/** Fills a page: the player and the plots where it has places for them. */

import "./style.css";
import { Chart } from "./chart/chart";
import type { ChartSpec } from "./chart/frame";
import { Lift } from "./data/lift";
import { unpack } from "./data/unpack";
import { element } from "./dom";
import { follow } from "./live";
import { Player } from "./player/player";
import { Session } from "./player/session";
import { watch } from "./reload";
import { reachScrollers } from "./scrollers";

declare global {
  /** For scripts that look at the page from outside, as tests do. */
  var gantlinePage: { session: Session; player: Player | null; charts: Chart[]; ready: number } | undefined;
}

async function fill(): Promise<void> {
  const header = document.getElementById("gantline-header")?.textContent;
  const data = document.getElementById("gantline-data")?.textContent;
  if (!header || !data) return;
  const session = new Session(new Lift(await unpack(header, data)));
  const place = document.querySelector<HTMLElement>("[data-gantline-player]");
  const player = place ? new Player(session, place) : null;
  const charts: Chart[] = [];
  for (const holder of document.querySelectorAll<HTMLElement>("[data-gantline-chart]")) {
    const spec = JSON.parse(holder.dataset.gantlineChart!) as ChartSpec;
    charts.push(new Chart(session, spec, holder));
  }
  globalThis.gantlinePage = { session, player, charts, ready: performance.now() };
  document.documentElement.dataset.ready = "true";
  void follow(session);
}

function chooseTheme(): void {
  for (const choice of document.querySelectorAll<HTMLButtonElement>("[data-gantline-theme]"))
    choice.addEventListener("click", () => {
      const isDark = document.documentElement.dataset.theme
        ? document.documentElement.dataset.theme === "dark"
        : matchMedia("(prefers-color-scheme: dark)").matches;
      document.documentElement.dataset.theme = isDark ? "light" : "dark";
    });
}

chooseTheme();
reachScrollers(document.querySelectorAll<HTMLElement>(".scroll, .columns"));
watch();
fill().catch((problem: unknown) => {
  const text = problem instanceof Error ? problem.message : String(problem);
  const place = document.querySelector("[data-gantline-player]") ?? document.body;
  place.append(
    element("p", { class: "gl-message", role: "alert" }, `The recording cannot be shown: ${text}`),
  );
});
