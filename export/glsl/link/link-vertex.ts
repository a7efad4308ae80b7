import { GATE_TEXT, LOOP_BUDGET } from '../../program/loop-budget.ts';
import type { LinkedShader, SourceMap } from '../../program/program.ts';
import type { CheckedShader } from '../check/check-shader.ts';
import { UNIFORM_TYPES } from '../isf/given-symbols.ts';
import type { VariableSymbol } from '../syntax/ast.ts';
import { inFile } from '../syntax/token.ts';
import { helpersFor, imageText } from './images.ts';
import { createLineWriter } from './line-writer.ts';
import { type LinkUnit, namePass, type PassNames, usable } from './link-unit.ts';
import type { PlannedPass } from './plan-passes.ts';
import { vertexHead, vertexMain } from './prelude.ts';
import type { PrintContext } from './print-context.ts';
import { printAuthorsText, printHoistedGlobals } from './print-shader.ts';
import { findReach, type Reach } from './reach.ts';
import { builtinUniforms, paramUniforms } from './uniforms-in-use.ts';

/** The author's vertex shader, linked for one pass. */
export interface LinkedVertex {
  readonly text: string;
  readonly map: SourceMap;
  readonly geometry: NonNullable<LinkedShader['geometry']>;
  /** The host's variables and functions that it uses. */
  readonly needed: Reach;
}

/** Varying with the position of the pixel, which authors may change. */
export const NORM_COORD = 'scrim_normCoord';

/** Varyings of a stage by name. */
export function varyingsOf({ declarations }: CheckedShader): ReadonlyMap<string, VariableSymbol> {
  const varyings = new Map<string, VariableSymbol>();
  for (const declaration of declarations) {
    if (declaration.kind !== 'variables') continue;
    for (const { symbol } of declaration.declarators) if (symbol?.role === 'varying') varyings.set(symbol.name, symbol);
  }
  return varyings;
}

/** Gives varyings equal names in both stages. Call it right after `namePass`. */
export function nameVaryings({ names }: PassNames, fragment: CheckedShader, own: CheckedShader): void {
  const symbols = varyingsOf(own);
  for (const name of varyingsOf(fragment).keys()) {
    const symbol = symbols.get(name);
    if (symbol === undefined) names.fresh(name);
    else names.of(symbol);
  }
}

/**
 * Links the author's vertex shader for a pass; null if there is none. `wanted` are the varyings that the fragment shader of the pass reads.
 *
 * @throws GlslError with the file.
 */
export function linkVertex(unit: LinkUnit, pass: PlannedPass, wanted: ReadonlySet<string>): LinkedVertex | null {
  const { vertex } = unit;
  const file = unit.shader.vertex?.file;
  if (vertex === null || file === undefined) return null;
  return inFile(file, () => printVertex({ ...unit, ...vertex }, unit.checked, pass, wanted, file));
}

function printVertex(unit: LinkUnit, fragment: CheckedShader, pass: PlannedPass, wanted: ReadonlySet<string>, file: string): LinkedVertex {
  const { shader, checked, given, options } = unit;
  const isBounded = unit.loops === 'bounded';
  const passNames = namePass(unit, pass);
  nameVaryings(passNames, fragment, checked);
  const { names, images } = passNames;
  const { passIndex } = pass;
  const needed = findReach(checked, { passIndex, images, names, also: [] });
  const reach = findReach(checked, { passIndex, images, names, also: usable(checked) });
  const loopBudget = isBounded && reach.hasLoops;
  const context: PrintContext = {
    writer: createLineWriter(0, options.loopBudget === true),
    names,
    reach,
    passIndex,
    images,
    structs: checked.structs,
    loopBudget,
    stage: 'vertex',
    varyings: wanted,
    normCoord: NORM_COORD,
    binding: new Map(),
    returnType: '',
    found: { discards: false, projects: false, returns: false },
  };
  printAuthorsText(checked, context);
  const { writer } = context;
  writer.own('void scrim_start() {');
  writer.indent(1);
  printHoistedGlobals(checked, context);
  writer.indent(-1);
  writer.own('}');
  const main = checked.main.symbol === null ? '' : (reach.instances.get(checked.main.symbol)?.[0]?.name ?? '');
  writer.own(vertexMain(main, NORM_COORD, isBounded));

  const imageTexts = [...reach.images].map(([image, uses]) => imageText(image, uses, shader));
  const head = [
    vertexHead(NORM_COORD),
    ...(isBounded ? [GATE_TEXT] : []),
    ...(loopBudget ? [LOOPS_END] : []),
    ...builtinUniforms(reach).map((name) => `uniform ${UNIFORM_TYPES[name]} ${name};`),
    ...paramUniforms(shader, reach, given, names).map(({ type, name }) => `uniform ${type} ${name};`),
    ...helpersFor(imageTexts.join('\n'), context.found.projects),
    ...imageTexts,
  ]
    .join('\n')
    .split('\n');
  return {
    text: `${[...head, ...writer.lines].join('\n')}\n`,
    map: { sources: [file], nodes: [options.node], lines: [...head.map(() => null), ...writer.map] },
    geometry: given.get('gl_Position')?.written ? 'moved-quad' : 'quad',
    needed,
  };
}

/**
 * GLSL that ends the loops of a vertex shader when the budget is used up, as in fragment shaders (`export/program/loop-budget.ts`), but
 * without reporting the loop.
 */
const LOOPS_END = `int scrim_roundsLeft = ${LOOP_BUDGET};
bool scrim_spend(int line) {
  scrim_roundsLeft -= 1;
  return scrim_roundsLeft >= 0;
}`;
