import { numericOf } from '../check/glsl-type.ts';
import type { GlslType } from '../syntax/ast.ts';
import type { PrintContext } from './print-context.ts';

/** A value of the type with all numbers 0; null for arrays, whose size the type does not say, and for unknown types. */
export function zeroOf(type: GlslType, context: PrintContext): string | null {
  if (numericOf(type) !== null) return `${type}(0)`;
  const struct = context.structs.get(type);
  if (struct === undefined) return null;
  const members = [...struct.members.values()].map((member) => zeroOf(member, context));
  return members.every((member) => member !== null) ? `${context.names.of(struct)}(${members.join(', ')})` : null;
}
