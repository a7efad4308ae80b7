import { decideBranch, reachableStatements } from '../link/pass-condition.ts';
import type { Expression, Statement } from '../syntax/ast.ts';
import { partsOf } from '../syntax/walk-tree.ts';

/** The direct parts of a statement or an expression, without branches that a pass cannot take. */
export function takenParts(part: Statement | Expression, passIndex: number): readonly (Statement | Expression)[] {
  if (part.kind === 'if') {
    const branch = decideBranch(part, passIndex);
    if (branch !== undefined) return branch === null ? [] : [branch];
  }
  return part.kind === 'block' ? reachableStatements(part.statements, passIndex) : partsOf(part);
}
