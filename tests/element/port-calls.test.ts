/** Calls between the shop's page and the editor's: what fails there comes here as it was. */
import { afterEach, describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { PortCalls } from "../../web/embed/port-calls.ts";

/** As another copy of the package throws it: standalone.js has its own beside that of host.js. */
class ForeignError extends Error {
  override readonly name = "TexelcastError";
  toJSON(): object {
    return { code: "too-many-decals", message: this.message, hint: "Delete one to add another." };
  }
}

const open: PortCalls[] = [];
afterEach(() => {
  for (const calls of open.splice(0)) calls.end(new TexelcastError("disposed", "The test is over."));
});

/** Rejects as the other side's answer did. */
function ask(answer: () => unknown): Promise<unknown> {
  const { port1, port2 } = new MessageChannel();
  const parts = { answer, onEvent: () => undefined, onIgnored: () => undefined };
  const [here, there] = [new PortCalls(port1, parts), new PortCalls(port2, parts)];
  open.push(here, there);
  return here.call("addDecal", [], 5000);
}

const fail = (thrown: unknown) => () => {
  throw thrown;
};

describe("a call that fails on the other side", () => {
  it.each([
    ["this script's own", new TexelcastError("too-many-decals", "Full.", { hint: "Delete one to add another." })],
    ["another script's", new ForeignError("Full.")],
  ])("rejects with the code, the words and the hint of %s error", async (_what, thrown) => {
    const error = await ask(fail(thrown)).catch((reason: unknown) => reason);
    expect(error).toBeInstanceOf(TexelcastError);
    expect(error).toMatchObject({ code: "too-many-decals", message: "Full.", hint: "Delete one to add another." });
  });

  it("is the editor's own fault where nobody meant the error", async () => {
    const message = "“addDecal” failed: TypeError: x is not a function";
    await expect(ask(fail(new TypeError("x is not a function")))).rejects.toMatchObject({ code: "internal", message });
    await expect(ask(fail("nothing"))).rejects.toMatchObject({ code: "internal" });
  });
});
