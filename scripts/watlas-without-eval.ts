/**
 * watlas for pages whose Content-Security-Policy allows no `eval`: its glue (Emscripten's embind) makes functions out of text, in
 * two places, and the build puts the same functions there as code. Emscripten has a switch for that, which watlas was built without.
 */
import type { Plugin } from "vite";

/** What calls the module's own methods. */
const INVOKER = `function() {
  var stack = needsDestructorStack ? [] : null;
  var wired = isClassMethodFunc ? [argTypes[1].toWireType(stack, this)] : [];
  for (var i = 2; i < argTypes.length; ++i) wired.push(argTypes[i].toWireType(stack, arguments[i - 2]));
  var rv = cppInvokerFunc(cppTargetFunc, ...wired);
  if (stack) runDestructors(stack);
  else for (var first = isClassMethodFunc ? 1 : 2, k = first; k < argTypes.length; ++k)
    if (argTypes[k].destructorFunction !== null) argTypes[k].destructorFunction(wired[k - first]);
  if (returns) return argTypes[0].fromWireType(rv);
}`;

/** What the module calls a page's functions by. */
const CALLER = `function(obj, func, destructorsRef, place) {
  var values = kind === 0 ? [obj] : [];
  for (var type of types) { values.push(type.readValueFromPointer(place)); place += type.argPackAdvance; }
  var rv = kind === 1 ? new func(...values) : func.call(...values);
  if (!retType.isVoid) return emval_returnValue(retType, destructorsRef, rv);
}`;

const PLACES = [
  ["new Function(...args,invokerFnBody)(...closureArgs)", INVOKER],
  ["new Function(...params,functionBody)(...args)", CALLER],
] as const;

/** The package's code without functions made of text. Throws where a place is not found: another release has to be looked at. */
export function withoutEval(code: string): string {
  return PLACES.reduce((text, [made, plain]) => {
    if (text.split(made).length !== 2) throw new Error(`watlas has no longer one "${made}".`);
    return text.replace(made, () => plain);
  }, code);
}

/** For the page's build, and for its workers'. */
export const watlasWithoutEval = (): Plugin => ({
  name: "texelcast-watlas",
  transform: { filter: { id: /watlas[/\\]dist[/\\]watlas\.js/ }, handler: (code) => withoutEval(code) },
});
