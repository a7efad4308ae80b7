/** Objects of the language that no test replaces. */
const NAMES = [
  'Array',
  'ArrayBuffer',
  'BigInt',
  'Boolean',
  'DataView',
  'Float32Array',
  'Float64Array',
  'Infinity',
  'Int16Array',
  'Int32Array',
  'Int8Array',
  'JSON',
  'Map',
  'Math',
  'NaN',
  'Number',
  'Object',
  'Reflect',
  'Set',
  'String',
  'Symbol',
  'Uint16Array',
  'Uint32Array',
  'Uint8Array',
  'Uint8ClampedArray',
  'WeakMap',
];

/**
 * Reads the globals of a module once, into variables of the same names. In the context in which Jest runs a module, each look at a global takes
 * 50 times as long as a look at a variable: `Math.min` in the loop over an image was most of its time. The names stay, so that functions that a
 * test sends to a page are the same.
 */
export function keepGlobals(code) {
  const used = NAMES.filter((name) => new RegExp(`\\b${name}\\b`).test(code) && !isDeclared(name, code));
  if (used.length === 0) return code;
  // A directive stays the first.
  const [directive] = /^(['"])use strict\1;/.exec(code) ?? [''];
  return `${directive} const { ${used.join(', ')} } = globalThis; ${code.slice(directive.length)}`;
}

/** Whether a module has a variable or an import of that name, perhaps in a function only. */
function isDeclared(name, code) {
  return (
    new RegExp(`\\b(?:const|let|var|function|class|as)\\s+${name}\\b`).test(code) ||
    new RegExp(`\\bimport\\b[^;'"]*[{,\\s]${name}\\s*[,}\\s][^;'"]*from`).test(code)
  );
}
