/** An answer whose line breaks when half of it has come. */
export const brokenOff = (): Response =>
  new Response(
    new ReadableStream({
      start: (body) => body.enqueue(new Uint8Array(8)),
      pull: (body) => body.error(new TypeError("network error")),
    }),
  );
