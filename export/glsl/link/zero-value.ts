import { numericOf } from '../check/glsl-type.ts';
import type { GlslType } from '../syntax/ast.ts';
import type { PrintContext } from './print-context.ts';

/** Maximum nesting of structs, ANGLE's limit. */
const MAX_STRUCTS = 4;

/**
 * A value of the type with all numbers 0; null for arrays, whose size is not part of the type, and for unknown types and deeper structs.
 */
export function zeroOf(type: GlslType, context: PrintContext, left = MAX_STRUCTS): string | null {
  if (numericOf(type) !== null) return `${type}(0)`;
  const struct = context.structs.get(type);
  if (struct === undefined || left === 0) return null;
  const members: string[] = [];
  for (const member of struct.members.values()) {
    const zero = zeroOf(member, context, left - 1);
    if (zero === null) return null;
    members.push(zero);
  }
  return `${context.names.of(struct)}(${members.join(', ')})`;
}
