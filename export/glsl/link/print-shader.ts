import type { CheckedShader } from '../check/check-shader.ts';
import type { PrintContext } from './print-context.ts';
import { needsHoisting, printFunctionHead, printGlobals, printHoisted } from './print-declaration.ts';
import { printBlock } from './print-statement.ts';

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
        printBlock(declaration.body, context);
      }
    }
    context.binding = new Map();
  }
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
