/**
 * Emscripten's glue for classes (embind) without functions made of text, which a Content-Security-Policy without `unsafe-eval`
 * refuses: the same functions as code. Emscripten has a switch for that, -sDYNAMIC_EXECUTION=0, without which the packages that
 * are used here were built.
 */

/** What calls the module's own methods: stands where their text is made a function with all that it names. */
export const INVOKER = `function() {
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
export const CALLER = `function(obj, func, destructorsRef, place) {
  var values = kind === 0 ? [obj] : [];
  for (var type of types) { values.push(type.readValueFromPointer(place)); place += type.argPackAdvance; }
  var rv = kind === 1 ? new func(...values) : func.call(...values);
  if (!retType.isVoid) return emval_returnValue(retType, destructorsRef, rv);
}`;

/**
 * A package's code with other code in its places. Throws where a place is not found once: another release has to be looked at.
 * @param {string} name the package's, for the error
 * @param {string} code
 * @param {readonly (readonly [made: string, plain: string])[]} places
 */
export function withPlaces(name, code, places) {
  return places.reduce((text, [made, plain]) => {
    if (text.split(made).length !== 2) throw new Error(`${name} has no longer one "${made}".`);
    return text.replace(made, () => plain);
  }, code);
}
