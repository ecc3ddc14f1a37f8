/** A page that is served asks whether its recording has changed, and loads again what is shown. */

const EVERY = 1500; // ms

export function watch(): void {
  const address = document.querySelector<HTMLMetaElement>('meta[name="gantline-reload"]')?.content;
  if (!address) return;
  let known: string | null = null;
  const ask = async () => {
    try {
      const answer = await fetch(address, { cache: "no-store" });
      const state = answer.ok ? await answer.text() : known;
      if (known !== null && state !== known && state !== "gone") location.reload();
      known = state ?? known;
    } catch {
      // The server has ended; the page stays as it is.
    }
  };
  setInterval(() => void ask(), EVERY);
  void ask();
}
