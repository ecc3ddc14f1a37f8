/** MathJax understands every formula of the documents, which nothing else says: Sphinx hands them on unread. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import MathJax from "mathjax";
import { beforeAll, expect, test } from "vitest";

const docs = join(import.meta.dirname, "../../docs");

/** Formulas of a page, by whether they have lines of their own; code is left out. */
function formulas(page: string): { tex: string; display: boolean }[] {
  const text = readFileSync(join(docs, page), "utf-8").replace(/^(`{3,})[\s\S]*?^\1|`[^`\n]*`/gm, "");
  const found = text.matchAll(/\$\$([\s\S]+?)\$\$|(?<!\\)\$([^$]+?)\$/g);
  return [...found].map((match) => ({ tex: match[1] ?? match[2]!, display: match[1] !== undefined }));
}

beforeAll(async () => {
  await MathJax.init({
    loader: { load: ["input/tex"] },
    tex: {
      // What MathJax would load when it meets it does not lie beside the built pages.
      packages: { "[-]": ["autoload", "require", "noundefined"] },
      formatError: (_jax: unknown, error: Error) => {
        throw error;
      },
    },
  });
});

const pages = readdirSync(docs, { recursive: true, encoding: "utf-8" }).filter((name) =>
  name.endsWith(".md"),
);

test("there are as many formulas as there were", () => {
  expect(pages.flatMap(formulas).length).toBeGreaterThan(1000);
});

test.each(pages.filter((page) => formulas(page).length > 0))("%s", (page) => {
  for (const { tex, display } of formulas(page))
    expect(() => MathJax.tex2mml(tex, { display }), tex).not.toThrow();
});
