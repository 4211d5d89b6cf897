/** What pages may load and run (Content-Security-Policy). */

/**
 * Scripts are the shop's own alone, and WebAssembly may be compiled. Blob addresses are the textures of a model on its
 * way to the graphics card.
 */
export const EDITOR_POLICY = {
  "default-src": ["'none'"],
  "script-src": ["'self'", "'wasm-unsafe-eval'"],
  "style-src": ["'self'"],
  "img-src": ["'self'", "blob:", "data:"],
  "font-src": ["'self'"],
  "connect-src": ["'self'", "blob:", "data:"],
  "worker-src": ["'self'"],
  "base-uri": ["'none'"],
  "form-action": ["'self'"],
};

/** An origin as a policy names it. */
export const orNone = (origin: string | null): string => origin ?? "'none'";
