import type { CheckedShader } from '../check/check-shader.ts';
import type { Block } from '../syntax/ast.ts';
import { walkStatement } from '../syntax/walk.ts';
import type { PrintContext } from './print-context.ts';
import { needsHoisting, printFunctionHead, printGlobals, printHoisted } from './print-declaration.ts';
import { printBlock } from './print-statement.ts';
import { zeroOf } from './zero.ts';

/** The author's functions and variables, as far as `context.reach` goes. */
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

/** A function whose returns are all for other passes would be refused for want of one: it gives 0, which nobody looks at. */
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

/** Sets the variables that ES 3.00 does not let start with what the author gave them. */
export function printHoistedGlobals(checked: CheckedShader, context: PrintContext): void {
  for (const declaration of checked.declarations) {
    if (declaration.kind !== 'variables') continue;
    for (const declarator of declaration.declarators) {
      const isReached = declarator.symbol !== null && context.reach.globals.has(declarator.symbol);
      if (isReached && needsHoisting(declarator)) printHoisted(declarator, context);
    }
  }
}
