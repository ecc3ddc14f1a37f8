/** A page that is served asks whether its recording has changed, and loads again what is shown. */

const EVERY = 1500; // ms

export function watch(): void {
  const address = document.querySelector<HTMLMetaElement>('meta[name="gantline-reload"]')?.content;
  if (!address) return;
  let known: string | null = null;
  let asks = false; // a page that is made anew takes longer than it is from one question to the next
  const ask = async () => {
    if (asks) return;
    asks = true;
    try {
      const answer = await fetch(address, { cache: "no-store" });
      const state = answer.ok ? await answer.text() : known;
      if (known === null || state === "gone") known = state;
      else if (state !== known && (await canBeShown())) location.reload();
    } catch {
      // The server has ended; the page stays as it is.
    } finally {
      asks = false;
    }
  };
  setInterval(() => void ask(), EVERY);
  void ask();
}

/** Whether there is a page to load: not of a recording of which a half has been copied, which would stay the last. */
async function canBeShown(): Promise<boolean> {
  return (await fetch(location.pathname, { method: "HEAD", cache: "no-store" })).ok;
}
