import { readFileSync } from "node:fs";
import { defineConfig } from "vitest/config";

// Reports carry the player wherever they are sent, and nothing beside it: what its parts are licensed under stands in it.
function notices(): string {
  const parts = [
    ["three", "node_modules/three/LICENSE"],
    ["earcut, which three holds a copy of", "licences/earcut.txt"],
  ] as const;
  const texts = parts.map(
    ([name, path]) => `${name}\n\n${readFileSync(new URL(path, import.meta.url), "utf-8").trim()}`,
  );
  return `/*! This player holds parts of others.\n\n${texts.join("\n\n")}\n*/`;
}

// One script and one style sheet, which the Python package puts into its pages.
export default defineConfig({
  build: {
    outDir: "../python/gantline/viewer/static",
    emptyOutDir: true,
    target: "es2022",
    cssCodeSplit: false,
    rolldownOptions: {
      output: { postBanner: notices, comments: { legal: true, annotation: false, jsdoc: false } },
    },
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
