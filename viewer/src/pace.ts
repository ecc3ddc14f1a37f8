/** Keeps what changes at every frame to a pace at which it can be read. */
export class Pace {
  private last = Number.NEGATIVE_INFINITY;

  constructor(private readonly interval: number) {}

  /** Whether it is time again; the interval is in milliseconds and counts from the last time it was. */
  isDue(now = performance.now()): boolean {
    if (now - this.last < this.interval) return false;
    this.last = now;
    return true;
  }
}
