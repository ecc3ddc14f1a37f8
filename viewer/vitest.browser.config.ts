import { defineConfig } from "vitest/config";

// Tests in the system's Chromium; `tests/browser/` makes the pages that they open and starts them.
export default defineConfig({
  test: {
    include: ["browser/**/*.test.ts"],
    testTimeout: 60_000,
    hookTimeout: 60_000,
    fileParallelism: false,
  },
});
