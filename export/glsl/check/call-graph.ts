import type { CallExpression, FunctionSymbol, ParsedShader } from '../syntax/ast.ts';
import { walkStatement } from '../syntax/walk.ts';

/** The author's functions, in the order of their bodies; those without come where their heads stand. */
export function functionsOf(declarations: ParsedShader['declarations']): FunctionSymbol[] {
  return declarations.flatMap((declaration) =>
    declaration.kind === 'function' && declaration.symbol?.declaration === declaration ? [declaration.symbol] : [],
  );
}

/** Calls of authors' functions in the body of one, in the order of the text. */
export function callsIn({ declaration: { body } }: FunctionSymbol): readonly CallExpression[] {
  const calls: CallExpression[] = [];
  if (body !== null) {
    walkStatement(body, {
      expression: (expression) => {
        if (expression.kind === 'call' && expression.symbol?.kind === 'function') calls.push(expression);
        return undefined;
      },
    });
  }
  return calls;
}

/**
 * The functions and all that they call, each once and behind those that it calls. Without recursion of our own: chains of calls may be
 * longer than the stack. `onReturn` hears of a call, inside of `caller`, of a function that is being called already.
 */
export function calleesFirst(
  roots: Iterable<FunctionSymbol>,
  onReturn: (call: CallExpression, caller: FunctionSymbol) => void = () => undefined,
): FunctionSymbol[] {
  const done = new Set<FunctionSymbol>();
  const running = new Set<FunctionSymbol>();
  for (const root of roots) {
    if (done.has(root)) continue;
    const chain = [{ symbol: root, calls: callsIn(root), next: 0 }];
    running.add(root);
    for (let at = chain.at(-1); at !== undefined; at = chain.at(-1)) {
      const call = at.calls[at.next++];
      if (call === undefined) {
        chain.pop();
        running.delete(at.symbol);
        done.add(at.symbol);
      } else if (call.symbol?.kind === 'function' && !done.has(call.symbol)) {
        const { symbol } = call;
        if (running.has(symbol)) {
          onReturn(call, at.symbol);
          continue;
        }
        running.add(symbol);
        chain.push({ symbol, calls: callsIn(symbol), next: 0 });
      }
    }
  }
  return [...done];
}
