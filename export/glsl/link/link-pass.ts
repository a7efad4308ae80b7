import type { LinkedShader } from '../../program/program.ts';
import { UNIFORM_TYPES } from '../isf/given-symbols.ts';
import type { FunctionSymbol, VariableSymbol } from '../syntax/ast.ts';
import { hashText } from './hash.ts';
import { colorFunction, helpersFor, type Image, type ImageUse, imageText, samplerFor } from './images.ts';
import { createLineWriter, type LineWriter } from './line-writer.ts';
import { type LinkSource, type LinkUnit, namePass } from './link-unit.ts';
import { type LinkedVertex, linkVertex, NORM_COORD, nameVaryings, varyingsOf } from './link-vertex.ts';
import type { LinkedPass, LinkedSampler } from './linked-pass.ts';
import type { PlannedPass } from './plan-passes.ts';
import {
  BOUNDED_VERTEX_SHADER,
  COUNTED_LOOPS_TEXT,
  FRAGMENT_HEAD,
  LOOP_BUDGET_END,
  LOOP_BUDGET_START,
  LOOP_BUDGET_TEXT,
  outputText,
  VERTEX_SHADER,
} from './prelude.ts';
import type { PrintContext } from './print-context.ts';
import { printAuthorsText, printHoistedGlobals } from './print-shader.ts';
import { findReach, type Reach } from './reach.ts';
import { builtinUniforms, paramUniforms, usesFragCoord } from './uniforms-in-use.ts';

/** Everything that `main` uses in this pass. */
export function reachOfPass(unit: LinkUnit, pass: PlannedPass): Reach {
  return findReach(unit.checked, { ...namePass(unit, pass), passIndex: pass.passIndex, also: [] });
}

/** Prints one pass. `also` is what no pass uses: it is printed so that the driver reports its mistakes, but nothing is bound for it. */
export function linkPass(unit: LinkUnit, pass: PlannedPass, also: readonly (FunctionSymbol | VariableSymbol)[]): LinkedPass {
  const passNames = namePass(unit, pass);
  const { names, images } = passNames;
  if (pass.kind === 'copy') return linkCopy(unit, pass, images);
  const { shader, checked, given, loops } = unit;
  nameVaryings(passNames, checked, checked);
  const needed = reachOfPass(unit, pass);
  const reach = findReach(checked, { passIndex: pass.passIndex, images, names, also });
  const context: PrintContext = {
    writer: createLineWriter(0, unit.options.loopBudget === true),
    names,
    reach,
    passIndex: pass.passIndex,
    images,
    structs: checked.structs,
    loopBudget: loops !== 'free' && reach.hasLoops,
    stage: 'fragment',
    varyings: unit.vertex === null ? new Set() : new Set(varyingsOf(unit.vertex.checked).keys()),
    normCoord: unit.vertex === null ? 'scrim_uv' : NORM_COORD,
    binding: new Map(),
    returnType: '',
    found: { discards: false, projects: false, returns: false },
  };
  printAuthorsText(checked, context);
  printMain(unit, pass, context);

  const params = paramUniforms(shader, reach, given, names);
  const builtins = builtinUniforms(reach);
  const imageTexts = [...reach.images].map(([image, uses]) => imageText(image, uses, shader));
  const head = [
    FRAGMENT_HEAD,
    ...(unit.vertex === null ? [] : [`in vec2 ${NORM_COORD};`]),
    ...(context.loopBudget ? [loops === 'counted' ? COUNTED_LOOPS_TEXT : LOOP_BUDGET_TEXT] : []),
    ...builtins.map((name) => `uniform ${UNIFORM_TYPES[name]} ${name};`),
    ...params.map((uniform) => `uniform ${uniform.type} ${uniform.name};`),
    ...helpersFor(`${imageTexts.join('\n')}\n${outputText(shader.premultiplied, pass.target)}`, context.found.projects),
    ...imageTexts,
    ...(usesFragCoord(reach) ? ['vec4 scrim_fragCoord;'] : []),
    ...(context.found.discards ? ['bool scrim_discarded = false;'] : []),
    'vec4 scrim_fragColor;',
  ];
  const read = [...reach.globals].filter(({ name, role }) => role === 'varying' && context.varyings.has(name));
  const vertex = linkVertex(unit, pass, new Set(read.map(({ name }) => name)));
  const reaches = vertex === null ? [needed] : [needed, vertex.needed];
  const isGated = context.loopBudget && loops === 'bounded';
  const linked = linkedShader(unit, head.join('\n'), context.writer, vertex ?? (isGated ? BOUNDED_VERTEX_SHADER : VERTEX_SHADER));
  return {
    shader: context.loopBudget && loops === 'counted' ? { ...linked, loops } : linked,
    passIndex: pass.passIndex,
    target: pass.target,
    samplers: samplersOf(reaches, images),
    uniforms: [
      ...builtinUniforms(...reaches).map((name) => ({ name, type: UNIFORM_TYPES[name], source: { builtin: name } })),
      ...paramUniforms(shader, needed, given, names, vertex?.needed),
    ],
  };
}

/** Prints the pass that copies a buffer to the node's output. */
function linkCopy(unit: LinkUnit, pass: PlannedPass, images: ReadonlyMap<string, Image>): LinkedPass {
  const image = images.get(pass.copyFrom ?? '');
  if (image === undefined) throw new Error('A copy names the buffer that it shows.');
  const uses = new Set<ImageUse>(['color']);
  const writer = createLineWriter(0);
  writer.own(`void main() {\n  vec4 scrim_fragColor = ${colorFunction(image)}(scrim_uv);`);
  writer.indent(1);
  const output = outputText(unit.shader.premultiplied, pass.target);
  writer.own(output);
  writer.indent(-1);
  writer.own('}');
  return {
    shader: linkedShader(unit, [FRAGMENT_HEAD, ...helpersFor(output, false), imageText(image, uses, unit.shader)].join('\n'), writer),
    passIndex: pass.passIndex,
    target: pass.target,
    samplers: samplersOf([{ images: new Map([[image, uses]]) }], images),
    uniforms: [],
  };
}

function printMain(unit: LinkUnit, pass: PlannedPass, context: PrintContext): void {
  const { writer, reach } = context;
  const main = unit.checked.main.symbol;
  writer.own('void main() {');
  writer.indent(1);
  if (context.loopBudget) writer.own(LOOP_BUDGET_START);
  // `gl_FragCoord` is relative to the target, in which the viewport may have any position. This value is exact at pixel centers.
  if (usesFragCoord(reach)) writer.own('scrim_fragCoord = vec4(floor(scrim_uv * RENDERSIZE) + 0.5, 0.5, 1.0);');
  writer.own('scrim_fragColor = vec4(0.0);');
  printHoistedGlobals(unit.checked, context);
  if (main !== null) writer.own(`${reach.instances.get(main)?.[0]?.name}();`);
  if (context.found.discards) writer.own('if (scrim_discarded) scrim_fragColor = vec4(0.0);');
  writer.own(outputText(unit.shader.premultiplied, pass.target));
  if (context.loopBudget) writer.own(LOOP_BUDGET_END);
  writer.indent(-1);
  writer.own('}');
}

function samplersOf(reaches: readonly Pick<Reach, 'images'>[], images: ReadonlyMap<string, Image>): LinkedSampler[] {
  const samplers = new Map<string, LinkedSampler>();
  // The sets may come from different walks, so images are matched by name; the order is that of the header.
  const used = reaches.flatMap((reach) => [...reach.images].map(([image, uses]) => ({ name: image.name, uses })));
  for (const image of images.values()) {
    for (const { uses } of used.filter(({ name }) => name === image.name)) {
      for (const use of uses) {
        const sampler = samplerFor(image, use);
        if (sampler !== null) samplers.set(sampler.name, sampler);
      }
    }
  }
  return [...samplers.values()];
}

/**
 * Assembles the GLSL of a pass from its head and the lines of a writer. `vertex` is the author's vertex shader, linked, or the text of a
 * standard one.
 */
export function linkedShader(
  unit: Omit<LinkSource, 'given'>,
  head: string,
  writer: LineWriter,
  vertex: string | LinkedVertex = VERTEX_SHADER,
): LinkedShader {
  const headLines = head.split('\n');
  const fragment = `${[...headLines, ...writer.lines].join('\n')}\n`;
  const vertexText = typeof vertex === 'string' ? vertex : vertex.text;
  return {
    id: hashText(`${vertexText}\0${fragment}`),
    vertex: vertexText,
    fragment,
    ...(typeof vertex === 'string' ? {} : { geometry: vertex.geometry, vertexMap: vertex.map }),
    sourceMap: { sources: [unit.shader.file], nodes: [unit.options.node], lines: [...headLines.map(() => null), ...writer.map] },
  };
}
