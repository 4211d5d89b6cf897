/**
 * Run in each frame of a page before its own scripts: notes when the element's poster is there, and when its product can be worked on,
 * in milliseconds since 1970, as frames have clocks of their own.
 */
{
  /** @type {Record<string, number>} */
  const times = {};
  Object.assign(globalThis, { loadTimes: times });
  /** @param {string} name */
  const note = (name) => {
    times[name] ??= performance.timeOrigin + performance.now();
  };
  // It does not bubble, but passes the document on its way down; no window hears a "load" from within.
  document.addEventListener(
    "load",
    ({ target }) => {
      if (target instanceof Element && target.localName === "texelcast-editor") note("ready");
    },
    true,
  );
  const look = () => {
    const shadow = document.querySelector("texelcast-editor")?.shadowRoot;
    const poster = shadow?.querySelector("[part~=poster]");
    if (poster instanceof HTMLImageElement && poster.complete && poster.naturalWidth > 0) note("poster");
    else if (times.ready === undefined) requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}
