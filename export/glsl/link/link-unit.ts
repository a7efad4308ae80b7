import { COUNTED_BUDGET, LOOP_BUDGET } from '../../program/loop-budget.ts';
import type { CheckedShader } from '../check/check-shader.ts';
import { countRounds } from '../check/count-rounds.ts';
import { isImageType } from '../check/glsl-type.ts';
import type { CheckedIsf } from '../isf/checked-isf.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import type { FunctionSymbol, VariableSymbol } from '../syntax/ast.ts';
import type { Image } from './images.ts';
import type { LinkOptions } from './linked-pass.ts';
import { createNames, type Names } from './names.ts';
import { passImages } from './pass-images.ts';
import type { PlannedPass } from './plan-passes.ts';

/** A file with its host variables and link options. */
export interface LinkSource {
  readonly shader: IsfShader;
  readonly given: ReadonlyMap<string, VariableSymbol>;
  readonly options: LinkOptions;
  readonly checked?: CheckedShader;
}

/** `free`: all loops are short. `counted`: they are long but end. `bounded`: they may be endless. */
export type Loops = 'free' | 'counted' | 'bounded';

export interface LinkUnit extends LinkSource, CheckedIsf {
  readonly checked: CheckedShader;
  readonly loops: Loops;
}

/** Classifies the loops, including those of the vertex shader (`export/program/loop-budget.ts`). */
export function loopsOf({ checked, vertex }: CheckedIsf, { loopBudget }: LinkOptions): Loops {
  if (loopBudget !== true) return 'free';
  const rounds = Math.max(countRounds(checked), vertex === null ? 0 : countRounds(vertex.checked));
  if (rounds <= LOOP_BUDGET) return 'free';
  return rounds <= COUNTED_BUDGET ? 'counted' : 'bounded';
}

export interface PassNames {
  readonly names: Names;
  readonly images: ReadonlyMap<string, Image>;
}

/** Names inputs and images first, so that their names do not depend on the rest of a pass. */
export function namePass(unit: LinkSource, pass: PlannedPass): PassNames {
  const names = createNames();
  for (const symbol of unit.given.values()) if (symbol.role === 'input') names.of(symbol);
  const images = passImages(unit.shader, pass, unit.options, names, unit.checked?.strayImages ?? []);
  return { names, images };
}

/** Functions and variables that can be printed without a call: those without image parameters. */
export function usable({ declarations }: CheckedShader): (FunctionSymbol | VariableSymbol)[] {
  const symbols = new Set<FunctionSymbol | VariableSymbol>();
  for (const declaration of declarations) {
    if (declaration.kind === 'function') {
      const { symbol } = declaration;
      if (symbol !== null && !symbol.parameterTypes.some(isImageType)) symbols.add(symbol);
      continue;
    }
    for (const { symbol } of declaration.declarators) if (symbol?.role === 'global') symbols.add(symbol);
  }
  return [...symbols];
}
