import { afterEach, describe, expect, it, vi } from "vitest";
import { watch } from "../src/reload";

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

describe("a page that is served", () => {
  it("loads again what has changed once it can be shown: half a copy would be the last page", async () => {
    vi.useFakeTimers();
    const served = { state: "a", ok: true };
    const reload = vi.fn();
    vi.stubGlobal("document", { querySelector: () => ({ content: "version" }) });
    vi.stubGlobal("location", { pathname: "/token/", reload });
    vi.stubGlobal("fetch", async (address: string) =>
      address === "version" ? { ok: true, text: async () => served.state } : { ok: served.ok },
    );
    watch();
    const later = () => vi.advanceTimersByTimeAsync(1500);
    await later();
    expect(reload).not.toHaveBeenCalled();
    Object.assign(served, { state: "half", ok: false });
    await later();
    await later();
    expect(reload).not.toHaveBeenCalled();
    Object.assign(served, { state: "gone" });
    await later();
    expect(reload).not.toHaveBeenCalled();
    Object.assign(served, { state: "whole", ok: true });
    await later();
    expect(reload).toHaveBeenCalledTimes(1);
  });
});
