import type { CheckedShader } from '../check/check-shader.ts';
import type { Block } from '../syntax/ast.ts';
import { walkStatement } from '../syntax/walk-tree.ts';
import type { PrintContext } from './print-context.ts';
import { needsHoisting, printFunctionHead, printGlobals, printHoisted } from './print-declaration.ts';
import { printBlock, zeroOf } from './print-statement.ts';

/** Prints the author's functions and variables that `context.reach` contains. */
export function printAuthorsText(checked: CheckedShader, context: PrintContext): void {
  const { writer, reach } = context;
  for (const declaration of checked.declarations) {
    if (declaration.kind === 'variables') {
      printGlobals(declaration, context);
      continue;
    }
    const { symbol } = declaration;
    for (const instance of symbol === null ? [] : (reach.instances.get(symbol) ?? [])) {
      context.binding = instance.binding;
      context.returnType = declaration.returnType.type;
      printFunctionHead(declaration, instance, context);
      if (declaration.body === null) {
        writer.write(';');
        writer.endLine();
      } else {
        writer.write(' ');
        context.found.returns = false;
        const { body } = declaration;
        printBlock(body, context, () => missingReturn(body, context));
      }
    }
    context.binding = new Map();
  }
}

/** A return statement for a function whose other returns belong to other passes; it returns 0, which is not used. */
function missingReturn(body: Block, context: PrintContext): string {
  if (context.found.returns || context.returnType === 'void' || !hasReturn(body)) return '';
  const zero = zeroOf(context.returnType, context);
  return zero === null ? '' : `return ${zero};`;
}

function hasReturn(body: Block): boolean {
  let found = false;
  walkStatement(body, {
    statement: (statement) => {
      found ||= statement.kind === 'return';
      return undefined;
    },
  });
  return found;
}

/** Assigns the initializers of globals that are not constant. */
export function printHoistedGlobals(checked: CheckedShader, context: PrintContext): void {
  for (const declaration of checked.declarations) {
    if (declaration.kind !== 'variables') continue;
    for (const declarator of declaration.declarators) {
      const isReached = declarator.symbol !== null && context.reach.globals.has(declarator.symbol);
      if (isReached && needsHoisting(declarator)) printHoisted(declarator, context);
    }
  }
}
