import { defineConfig } from "vitest/config";

// No tests but the pictures of reports in the documentation; `tools/report_pictures.py` makes the pages and starts them.
export default defineConfig({
  test: { include: ["browser/**/*.pictures.ts"], testTimeout: 300_000, hookTimeout: 60_000 },
});
