import { defineConfig } from "vitest/config";

// No tests but measurements in the system's Chromium; `benchmarks/player.py` makes the pages and starts them.
export default defineConfig({
  test: { include: ["browser/**/*.measure.ts"], testTimeout: 300_000, hookTimeout: 60_000 },
});
