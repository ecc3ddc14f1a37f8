import { defineConfig } from "vitest/config";

// One script and one style sheet, which the Python package puts into its pages.
export default defineConfig({
  build: {
    outDir: "../python/gantline/viewer/static",
    emptyOutDir: true,
    target: "es2022",
    cssCodeSplit: false,
    lib: {
      entry: "src/main.ts",
      formats: ["iife"],
      name: "gantline",
      fileName: () => "player.js",
      cssFileName: "player",
    },
  },
  test: { include: ["test/**/*.test.ts"] },
});
