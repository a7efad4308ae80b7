import type { LinkedShader } from '../../program/program.ts';
import type { CheckedShader } from '../check/check-shader.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import type { FunctionSymbol, VariableSymbol } from '../syntax/ast.ts';
import { hashText } from './hash.ts';
import { colorFunction, helpersFor, type Image, type ImageUse, imageText, samplerFor } from './images.ts';
import { createLineWriter, type LineWriter } from './line-writer.ts';
import type { LinkedPass, LinkedSampler, LinkOptions } from './linked-pass.ts';
import { createNames, type Names } from './names.ts';
import { passImages } from './pass-images.ts';
import type { PlannedPass } from './plan-passes.ts';
import {
  BOUNDED_VERTEX_SHADER,
  FRAGMENT_HEAD,
  LOOP_BUDGET_END,
  LOOP_BUDGET_START,
  LOOP_BUDGET_TEXT,
  outputText,
  VERTEX_SHADER,
} from './prelude.ts';
import type { PrintContext } from './print-context.ts';
import { needsHoisting, printFunctionHead, printGlobals, printHoisted } from './print-declaration.ts';
import { printBlock } from './print-statement.ts';
import { findReach, type Reach } from './reach.ts';
import { builtinUniforms, GLSL_UNIFORM_TYPES, paramUniforms, usesFragCoord } from './uniforms.ts';

/** A file, the variables that it is given, and the node that it is linked for. */
export interface LinkSource {
  readonly shader: IsfShader;
  readonly given: ReadonlyMap<string, VariableSymbol>;
  readonly options: LinkOptions;
}

export interface LinkUnit extends LinkSource {
  readonly checked: CheckedShader;
}

interface PassNames {
  readonly names: Names;
  readonly images: ReadonlyMap<string, Image>;
}

/** Inputs and images get their names first, so that these do not depend on what else a pass uses. */
export function namePass(unit: LinkSource, pass: PlannedPass): PassNames {
  const names = createNames();
  for (const symbol of unit.given.values()) if (symbol.role === 'input') names.of(symbol);
  return { names, images: passImages(unit.shader, pass, unit.options, names) };
}

/** What `main` of this pass uses. */
export function reachOfPass(unit: LinkUnit, pass: PlannedPass): Reach {
  return findReach(unit.checked, { ...namePass(unit, pass), passIndex: pass.passIndex, also: [] });
}

/**
 * Prints one pass. `also` is what no pass uses: it is printed all the same, so that the driver reports its mistakes too, but
 * nothing has to be bound for it.
 */
export function linkPass(unit: LinkUnit, pass: PlannedPass, also: readonly (FunctionSymbol | VariableSymbol)[]): LinkedPass {
  const { names, images } = namePass(unit, pass);
  if (pass.kind === 'copy') return linkCopy(unit, pass, images);
  const { shader, checked, given, options } = unit;
  const needed = reachOfPass(unit, pass);
  const reach = findReach(checked, { passIndex: pass.passIndex, images, names, also });
  const context: PrintContext = {
    writer: createLineWriter(0),
    names,
    reach,
    passIndex: pass.passIndex,
    images,
    structs: checked.structs,
    loopBudget: options.loopBudget === true && reach.hasLoops,
    binding: new Map(),
    returnType: '',
    found: { discards: false, projects: false },
  };
  printAuthorsText(checked, context);
  printMain(unit, pass, context);

  const params = paramUniforms(shader, reach, given, names);
  const builtins = builtinUniforms(reach);
  const imageTexts = [...reach.images].map(([image, uses]) => imageText(image, uses, shader.premultiplied));
  const head = [
    FRAGMENT_HEAD,
    ...(context.loopBudget ? [LOOP_BUDGET_TEXT] : []),
    ...builtins.map((name) => `uniform ${GLSL_UNIFORM_TYPES[name]} ${name};`),
    ...params.map((uniform) => `uniform ${uniform.type} ${uniform.name};`),
    ...helpersFor(imageTexts.join('\n'), context.found.projects),
    ...imageTexts,
    ...(usesFragCoord(reach) ? ['vec4 scrim_fragCoord;'] : []),
    ...(context.found.discards ? ['bool scrim_discarded = false;'] : []),
    'vec4 scrim_fragColor;',
  ];
  return {
    shader: linkedShader(unit, head.join('\n'), context.writer, context.loopBudget ? BOUNDED_VERTEX_SHADER : VERTEX_SHADER),
    passIndex: pass.passIndex,
    target: pass.target,
    samplers: samplersOf(needed.images, images),
    uniforms: [
      ...builtinUniforms(needed).map((name) => ({ name, type: GLSL_UNIFORM_TYPES[name], source: { builtin: name } })),
      ...params.filter(({ source }) => 'param' in source && needed.params.has(source.param)),
    ],
  };
}

/** Shows a buffer as the node's layer. */
function linkCopy(unit: LinkUnit, pass: PlannedPass, images: ReadonlyMap<string, Image>): LinkedPass {
  const image = images.get(pass.copyFrom ?? '');
  if (image === undefined) throw new Error('A copy names the buffer that it shows.');
  const uses = new Set<ImageUse>(['color']);
  const writer = createLineWriter(0);
  writer.own(`void main() {\n  vec4 scrim_fragColor = ${colorFunction(image)}(scrim_uv);`);
  writer.indent(1);
  writer.own(outputText(unit.shader.premultiplied, pass.target));
  writer.indent(-1);
  writer.own('}');
  return {
    shader: linkedShader(unit, [FRAGMENT_HEAD, imageText(image, uses, unit.shader.premultiplied)].join('\n'), writer),
    passIndex: pass.passIndex,
    target: pass.target,
    samplers: samplersOf(new Map([[image, uses]]), images),
    uniforms: [],
  };
}

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

function printMain(unit: LinkUnit, pass: PlannedPass, context: PrintContext): void {
  const { writer, reach } = context;
  const main = unit.checked.main.symbol;
  writer.own('void main() {');
  writer.indent(1);
  if (context.loopBudget) writer.own(LOOP_BUDGET_START);
  // The viewport may lie anywhere in the target, so GLSL's own position will not do; this one is exact at pixel centres.
  if (usesFragCoord(reach)) writer.own('scrim_fragCoord = vec4(floor(scrim_uv * RENDERSIZE) + 0.5, 0.5, 1.0);');
  writer.own('scrim_fragColor = vec4(0.0);');
  for (const declaration of unit.checked.declarations) {
    if (declaration.kind !== 'variables') continue;
    for (const declarator of declaration.declarators) {
      const isReached = declarator.symbol !== null && reach.globals.has(declarator.symbol);
      if (isReached && needsHoisting(declarator)) printHoisted(declarator, context);
    }
  }
  if (main !== null) writer.own(`${reach.instances.get(main)?.[0]?.name}();`);
  if (context.found.discards) writer.own('if (scrim_discarded) scrim_fragColor = vec4(0.0);');
  writer.own(outputText(unit.shader.premultiplied, pass.target));
  if (context.loopBudget) writer.own(LOOP_BUDGET_END);
  writer.indent(-1);
  writer.own('}');
}

function samplersOf(used: ReadonlyMap<Image, ReadonlySet<ImageUse>>, images: ReadonlyMap<string, Image>): LinkedSampler[] {
  const samplers = new Map<string, LinkedSampler>();
  // The sets may come from another walk, so images are found by name; the order is the header's.
  const usesByName = new Map([...used].map(([image, uses]) => [image.name, uses]));
  for (const image of images.values()) {
    for (const use of usesByName.get(image.name) ?? []) {
      const sampler = samplerFor(image, use);
      if (sampler !== null) samplers.set(sampler.name, sampler);
    }
  }
  return [...samplers.values()];
}

export function linkedShader(unit: Omit<LinkSource, 'given'>, head: string, writer: LineWriter, vertex = VERTEX_SHADER): LinkedShader {
  const headLines = head.split('\n');
  const fragment = `${[...headLines, ...writer.lines].join('\n')}\n`;
  return {
    id: hashText(`${vertex}\0${fragment}`),
    vertex,
    fragment,
    sourceMap: { sources: [unit.shader.file], nodes: [unit.options.node], lines: [...headLines.map(() => null), ...writer.map] },
  };
}
