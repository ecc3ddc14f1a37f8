/** A page of a lift that runs asks for what has been recorded since, and says how far the run is. */

import { unpack } from "./data/unpack";
import { element } from "./dom";
import { parse } from "./player/address";
import type { Session } from "./player/session";

const EVERY = 100; // ms between an answer and the next question
const ENDS: Record<string, string> = {
  done: "The lift has been simulated",
  stopped: "The simulation was stopped",
  failed: "The simulation could not go on",
};

interface Live {
  status: string;
  duration: number;
}

export async function follow(session: Session): Promise<void> {
  const address = document.querySelector<HTMLMetaElement>('meta[name="gantline-live"]')?.content;
  if (!address) return;
  // Who comes to see a lift that runs sees what it does now, unless he was sent to a time.
  if (parse(location.hash).time === undefined) session.seek(session.lift.end);
  const runs = "The lift is being simulated";
  const words = element("span", {}, runs);
  // Not for those who listen: it changes ten times a second.
  const far = element("span", { "aria-hidden": "true" });
  const sign = element("p", { class: "gl-live", role: "status" }, words, far);
  document.querySelector("[data-gantline-player]")?.before(sign);
  for (;;) {
    const live = await ask(address, session);
    if (live === null) {
      words.textContent = "The simulation has ended; this page shows what it had got.";
      far.textContent = "";
      return;
    }
    far.textContent = `: ${session.lift.end.toFixed(1)} of ${live.duration.toFixed(1)} s`;
    const end = ENDS[live.status];
    if (end !== undefined) {
      words.textContent = end;
      sign.dataset.ended = live.status;
      return;
    }
    await new Promise((resolve) => setTimeout(resolve, EVERY));
  }
}

/** Ask once and take what comes; null where nobody answers any more. */
async function ask(address: string, session: Session): Promise<Live | null> {
  for (;;) {
    try {
      const answer = await fetch(`${address}${session.lift.header.samples}`, { cache: "no-store" });
      if (!answer.ok) return null;
      const text = await answer.text();
      if (text === "") continue;
      const [header, data] = text.split("\n");
      const more = await unpack(header!, data!);
      session.append(more);
      return (more.header as unknown as { live: Live }).live;
    } catch {
      return null;
    }
  }
}
