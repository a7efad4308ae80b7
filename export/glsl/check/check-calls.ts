import type { FunctionSymbol } from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import { calleesFirst, callsIn, functionsOf } from './call-graph.ts';
import type { CheckedShader } from './check-shader.ts';

/** Maximum call depth in WebGL (`MaxCallStackDepth` of ANGLE). */
const MAX_CALLS = 256;

/**
 * Rejects mistakes that drivers report without a line: recursion (GLSL ES 3.00 §6.1), calls that are nested too deeply, and calls of
 * functions without a body, unless `isGiven` returns true.
 *
 * @throws GlslError at the first mistake.
 */
export function checkCalls({ declarations }: CheckedShader, isGiven: (name: string) => boolean): void {
  const defined = functionsOf(declarations).filter(({ declaration }) => declaration.body !== null);
  const called = calleesFirst(defined, (call, caller) => {
    const how = call.symbol === caller ? 'calls itself' : `is called here by "${caller.name}", which it calls itself`;
    throw new GlslError(call.token, `"${call.symbol?.name}" ${how}: GLSL has no recursion. Use a loop.`);
  });
  const depths = new Map<FunctionSymbol, number>();
  for (const symbol of called) {
    const { name, declaration } = symbol;
    const depth = callsIn(symbol).reduce((deepest, call) => Math.max(deepest, 1 + (depths.get(call.symbol as FunctionSymbol) ?? 0)), 1);
    depths.set(symbol, depth);
    if (depth > MAX_CALLS)
      throw new GlslError(declaration.name, `Calls from "${name}" are nested more than ${MAX_CALLS} deep, the limit of WebGL.`, 'SCR043');
    if (declaration.body === null && !isGiven(name))
      throw new GlslError(declaration.name, `"${name}" is called, but has only this head: its body in braces is missing.`);
  }
}
