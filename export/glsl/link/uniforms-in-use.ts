import type { BuiltinUniform, PassUniform } from '../../program/program.ts';
import { INPUT_TYPES, UNIFORM_TYPES } from '../isf/given-symbols.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import type { VariableSymbol } from '../syntax/ast.ts';
import type { LinkedUniform } from './linked-pass.ts';
import type { Names } from './names.ts';
import type { Reach } from './reach.ts';

/** Automatic uniforms that a pass uses, in the table's order; a position in pixels needs the size. */
export function builtinUniforms(...reaches: readonly Reach[]): BuiltinUniform[] {
  const used = new Set(reaches.flatMap(({ builtins }) => [...builtins]));
  if (reaches.some(usesFragCoord)) used.add('RENDERSIZE');
  return (Object.keys(UNIFORM_TYPES) as BuiltinUniform[]).filter((name) => used.has(name));
}

export function usesFragCoord(reach: Reach): boolean {
  return ['gl_FragCoord', 'isf_FragCoord', 'vv_FragCoord'].some((name) => reach.builtins.has(name));
}

/** Inputs that are values and that one of the reaches uses, in the header's order. */
export function paramUniforms(
  shader: IsfShader,
  reach: Reach,
  given: ReadonlyMap<string, VariableSymbol>,
  names: Names,
  also?: Reach,
): LinkedUniform[] {
  const uniforms: LinkedUniform[] = [];
  for (const { name, type } of shader.inputs) {
    const symbol = given.get(name);
    if (symbol === undefined || !(reach.params.has(name) || also?.params.has(name))) continue;
    uniforms.push({
      name: names.of(symbol),
      type: INPUT_TYPES[type] as PassUniform['type'],
      source: type === 'event' ? { event: name } : { param: name },
    });
  }
  return uniforms;
}
