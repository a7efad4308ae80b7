/**
 * Replaces code of three.js' Basis transcoder that creates functions from text (Emscripten's embind), which a page's policy blocks:
 * `'wasm-unsafe-eval'` does not allow it, and `'unsafe-eval'` would allow any. Emscripten's alternative (`-sDYNAMIC_EXECUTION=0`) uses
 * closures over the same tables, but must be chosen when the transcoder is built. This inserts such closures.
 */
const REPLACEMENTS: readonly (readonly [text: string, closure: string])[] = [
  [
    'var invokerFn=newFunc(Function,args)(...closureArgs);',
    `var invokerFn = function (...given) {
      if (given.length !== argCount - 2) throwBindingError(humanName + ' takes ' + (argCount - 2) + ' arguments, not ' + given.length);
      const destructors = needsDestructorStack ? [] : null;
      const types = argTypes.slice(isClassMethodFunc ? 1 : 2);
      const values = isClassMethodFunc ? [this, ...given] : given;
      const wired = types.map((type, i) => type['toWireType'](destructors, values[i]));
      const result = cppInvokerFunc(cppTargetFunc, ...wired);
      if (needsDestructorStack) runDestructors(destructors);
      else types.forEach((type, i) => { if (type.destructorFunction !== null) type.destructorFunction(wired[i]); });
      if (returns) return argTypes[0]['fromWireType'](result);
    };`,
  ],
  [
    'var invokerFunction=newFunc(Function,params)(...args);',
    `var invokerFunction = function (object, callee, destructorsRef, pointer) {
      const values = types.map((type) => {
        const value = type.readValueFromPointer(pointer);
        pointer += type['argPackAdvance'];
        return value;
      });
      const result = kind === 1 ? new callee(...values) : kind === 0 ? callee.call(object, ...values) : callee.call(...values);
      if (!retType.isVoid) return emval_returnValue(retType, destructorsRef, result);
    };`,
  ],
];

/**
 * Returns the script of the Basis transcoder with the replacements applied. Throws an `Error` if the script does not contain the expected
 * text, such as after an upgrade of three.js.
 */
export function withoutEval(script: string): string {
  return REPLACEMENTS.reduce((text, [made, closure]) => {
    const [before, after, ...more] = text.split(made);
    if (before === undefined || after === undefined || more.length > 0) throw new Error('the Basis transcoder is not the expected one');
    return before + closure + after;
  }, script);
}
