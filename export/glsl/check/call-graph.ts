import type { CallExpression, FunctionSymbol, ParsedShader } from '../syntax/ast.ts';
import { walkStatement } from '../syntax/walk-tree.ts';

/** Lists the author's functions in the order of their bodies; a function without a body comes at the place of its prototype. */
export function functionsOf(declarations: ParsedShader['declarations']): FunctionSymbol[] {
  return declarations.flatMap((declaration) =>
    declaration.kind === 'function' && declaration.symbol?.declaration === declaration ? [declaration.symbol] : [],
  );
}

/** Calls of the author's functions in a function's body, in the order of the text. */
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
 * Lists the functions `roots` and all functions that they call directly or indirectly. Each is listed once, after the functions that it
 * calls. The traversal is iterative, because call chains may be longer than the stack. `onReturn` is called for a recursive call in
 * `caller`.
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
