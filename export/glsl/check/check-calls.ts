import type { CallExpression, FunctionSymbol } from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import { walkStatement } from '../syntax/walk.ts';
import type { CheckedShader } from './check-shader.ts';

/**
 * Refuses what drivers refuse without a word of where: functions that come back to themselves (GLSL ES 3.00 §6.1), and calls of
 * those that have no body, unless `isGiven` says that another one brings it. Throws `GlslError`.
 */
export function checkCalls({ declarations }: CheckedShader, isGiven: (name: string) => boolean): void {
  const done = new Set<FunctionSymbol>();
  /** Functions that are being looked into, each called by the one before. */
  const chain: FunctionSymbol[] = [];

  function enter(symbol: FunctionSymbol): void {
    const { body, name } = symbol.declaration;
    if (body === null) {
      if (!isGiven(symbol.name))
        throw new GlslError(name, `"${symbol.name}" is called, but has only this head: its body in braces is missing.`);
      return;
    }
    chain.push(symbol);
    walkStatement(body, {
      expression: (expression) => {
        if (expression.kind === 'call' && expression.symbol?.kind === 'function') follow(expression, expression.symbol);
        return undefined;
      },
    });
    chain.pop();
    done.add(symbol);
  }

  function follow(call: CallExpression, callee: FunctionSymbol): void {
    if (done.has(callee)) return;
    if (!chain.includes(callee)) {
      enter(callee);
      return;
    }
    const caller = chain.at(-1);
    const how = caller === callee ? 'calls itself' : `is called here by "${caller?.name}", which it calls itself`;
    throw new GlslError(call.token, `"${callee.name}" ${how}: GLSL has no recursion. Use a loop.`);
  }

  for (const declaration of declarations) {
    if (declaration.kind === 'function' && declaration.body !== null && declaration.symbol && !done.has(declaration.symbol))
      enter(declaration.symbol);
  }
}
