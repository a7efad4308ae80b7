import type { LinkedShader } from '../../program/program.ts';
import { countOperations } from '../access/count-operations.ts';
import { type ImageReads, imageReads } from '../access/find-access.ts';
import { givesOpaque, keptAlpha } from '../access/kept-alpha.ts';
import { UNIFORM_TYPES } from '../isf/given-symbols.ts';
import type { FunctionSymbol, VariableSymbol } from '../syntax/ast.ts';
import { hashText } from './hash.ts';
import { colorFunction, helpersFor, type Image, type ImageUse, imageText, samplerFor } from './images.ts';
import { createLineWriter, type LineWriter, type MappedLines } from './line-writer.ts';
import type { PartedPass, PassParts } from './link-parts.ts';
import { type LinkSource, type LinkUnit, namePass } from './link-unit.ts';
import { type LinkedVertex, linkVertex, NORM_COORD, nameVaryings, varyingsOf } from './link-vertex.ts';
import type { LinkedSampler } from './linked-pass.ts';
import type { PlannedPass } from './plan-passes.ts';
import {
  BOUNDED_VERTEX_SHADER,
  COUNTED_LOOPS_TEXT,
  FRAGMENT_HEAD,
  LOOP_BUDGET_END,
  LOOP_BUDGET_START,
  LOOP_BUDGET_TEXT,
  outputOf,
  outputText,
  VERTEX_SHADER,
} from './prelude.ts';
import type { PrintContext } from './print-context.ts';
import { needsHoisting } from './print-declaration.ts';
import { printAuthorsText, printHoistedGlobals } from './print-shader.ts';
import { findReach, type Reach } from './reach.ts';
import { builtinUniforms, paramUniforms, usesFragCoord } from './uniforms-in-use.ts';

/** Everything that `main` uses in this pass. */
export function reachOfPass(unit: LinkUnit, pass: PlannedPass): Reach {
  return findReach(unit.checked, { ...namePass(unit, pass), passIndex: pass.passIndex, also: [] });
}

/** Prints one pass. `also` is what no pass uses: it is printed so that the driver reports its mistakes, but nothing is bound for it. */
export function linkPass(unit: LinkUnit, pass: PlannedPass, also: readonly (FunctionSymbol | VariableSymbol)[]): PartedPass {
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
  const body = printBody(unit, context);

  const reads = imageReads(checked, pass.passIndex);
  const readsOf = ({ name }: Image) => (reads === null ? UNCLEAR_READS : (reads.get(name) ?? NO_READS));
  const here = new Set([...(reads ?? [])].flatMap(([image, { texels, elsewhere }]) => (texels + elsewhere === 0 ? [image] : [])));
  const alphaOf = context.found.discards ? null : keptAlpha(checked, pass.passIndex);
  const parts: PassParts = {
    file: shader.file,
    passIndex: pass.passIndex,
    builtins: builtinUniforms(reach),
    params: paramUniforms(shader, reach, given, names),
    images: [...reach.images].map(([image, uses]) => ({
      image,
      uses,
      reading: shader,
      isHere: here.has(image.name),
      reads: readsOf(image),
    })),
    projects: context.found.projects,
    usesFragCoord: usesFragCoord(reach),
    discards: context.found.discards,
    functions: linesOf(context.writer),
    body: linesOf(body),
    output: outputOf(shader.premultiplied, pass.target),
    keptAlpha: alphaOf !== null && here.has(alphaOf) ? (images.get(alphaOf)?.sampler ?? null) : null,
    isOpaque: !context.found.discards && givesOpaque(checked, pass.passIndex),
    format: pass.target.format,
    moves: reads !== null && !usesNormCoord([context.writer, body], [...reach.images.keys()]) && ![...reach.globals].some(isKept),
    operations: countOperations(checked, pass.passIndex),
  };
  const read = [...reach.globals].filter(({ name, role }) => role === 'varying' && context.varyings.has(name));
  const vertex = linkVertex(unit, pass, new Set(read.map(({ name }) => name)));
  const reaches = vertex === null ? [needed] : [needed, vertex.needed];
  const isGated = context.loopBudget && loops === 'bounded';
  const linked = printPass(unit, parts, {
    declarations: [
      ...(unit.vertex === null ? [] : [`in vec2 ${NORM_COORD};`]),
      ...(context.loopBudget ? [loops === 'counted' ? COUNTED_LOOPS_TEXT : LOOP_BUDGET_TEXT] : []),
    ],
    loopBudget: context.loopBudget,
    vertex: vertex ?? (isGated ? BOUNDED_VERTEX_SHADER : VERTEX_SHADER),
  });
  return {
    shader: context.loopBudget && loops === 'counted' ? { ...linked, loops } : linked,
    passIndex: pass.passIndex,
    target: pass.target,
    samplers: samplersOf(reaches, images),
    uniforms: [
      ...builtinUniforms(...reaches).map((name) => ({ name, type: UNIFORM_TYPES[name], source: { builtin: name } })),
      ...paramUniforms(shader, needed, given, names, vertex?.needed),
    ],
    parts: unit.vertex !== null ? 'vertex' : context.loopBudget ? 'loops' : parts,
  };
}

/** Prints the pass that copies a buffer to the node's output. */
function linkCopy(unit: LinkUnit, pass: PlannedPass, images: ReadonlyMap<string, Image>): PartedPass {
  const image = images.get(pass.copyFrom ?? '');
  if (image === undefined) throw new Error('A copy names the buffer that it shows.');
  const uses = new Set<ImageUse>(['color']);
  const body = createLineWriter(0);
  body.indent(1);
  body.own(`scrim_fragColor = ${colorFunction(image)}(scrim_uv);`);
  const parts: PassParts = {
    file: unit.shader.file,
    passIndex: pass.passIndex,
    builtins: [],
    params: [],
    images: [{ image, uses, reading: unit.shader, isHere: true, reads: { ...NO_READS, here: 1 } }],
    projects: false,
    usesFragCoord: false,
    discards: false,
    functions: NO_LINES,
    body: linesOf(body),
    output: outputOf(unit.shader.premultiplied, pass.target),
    keptAlpha: null,
    isOpaque: false,
    format: pass.target.format,
    moves: true,
    operations: 0,
  };
  return {
    shader: printPass(unit, parts, { declarations: [], loopBudget: false, vertex: VERTEX_SHADER }),
    passIndex: pass.passIndex,
    target: pass.target,
    samplers: samplersOf([{ images: new Map([[image, uses]]) }], images),
    uniforms: [],
    parts,
  };
}

const NO_READS: ImageReads = { here: 0, texels: 0, elsewhere: 0 };
const UNCLEAR_READS: ImageReads = { ...NO_READS, elsewhere: Number.POSITIVE_INFINITY };

/** How `gl_FragCoord` is computed of the normalized position: relative to the target, and exact at pixel centers. */
const FRAG_COORD = 'scrim_fragCoord = vec4(floor(scrim_uv * RENDERSIZE) + 0.5, 0.5, 1.0);';

/** Whether a global variable keeps what the text writes to it when `main` runs again. */
function isKept({ role, written, declaration }: VariableSymbol): boolean {
  return role === 'global' && written && (declaration === null || !needsHoisting(declaration));
}

/** Whether printed text computes with the normalized position, which reads of images and `gl_FragCoord` do not. */
function usesNormCoord(texts: readonly LineWriter[], images: readonly Image[]): boolean {
  const reads = new Set(images.map((image) => `${colorFunction(image)}(scrim_uv)`));
  const rest = (line: string) => line.replaceAll(/\w+\(scrim_uv\)/g, (call) => (reads.has(call) ? '' : call)).replace(FRAG_COORD, '');
  return texts.some(({ lines }) => lines.some((line) => /\bscrim_uv\b/.test(rest(line))));
}

const NO_LINES: MappedLines = { lines: [], map: [] };

/** What a writer has printed, as data. */
function linesOf({ lines, map }: LineWriter): MappedLines {
  return { lines, map };
}

/** Prints the statements that compute the author's color. */
function printBody(unit: LinkUnit, context: PrintContext): LineWriter {
  const writer = createLineWriter(0, unit.options.loopBudget === true);
  const { reach } = context;
  const main = unit.checked.main.symbol;
  writer.indent(1);
  // `gl_FragCoord` is relative to the target, in which the viewport may have any position. This value is exact at pixel centers.
  if (usesFragCoord(reach)) writer.own(FRAG_COORD);
  writer.own('scrim_fragColor = vec4(0.0);');
  printHoistedGlobals(unit.checked, { ...context, writer });
  if (main !== null) writer.own(`${reach.instances.get(main)?.[0]?.name}();`);
  if (context.found.discards) writer.own('if (scrim_discarded) scrim_fragColor = vec4(0.0);');
  writer.endLine();
  return writer;
}

interface PrintOptions {
  /** Declarations for the vertex shader and for loops. */
  readonly declarations: readonly string[];
  readonly loopBudget: boolean;
  readonly vertex: string | LinkedVertex;
}

function printPass(unit: LinkUnit, parts: PassParts, { declarations, loopBudget, vertex }: PrintOptions): LinkedShader {
  const output = outputText(parts.output);
  const images = parts.images.map(({ image, uses, reading }) => imageText(image, uses, reading));
  const head = [
    FRAGMENT_HEAD,
    ...declarations,
    ...parts.builtins.map((name) => `uniform ${UNIFORM_TYPES[name]} ${name};`),
    ...parts.params.map(({ type, name }) => `uniform ${type} ${name};`),
    ...helpersFor([...images, output].join('\n'), parts.projects),
    ...images,
    ...(parts.usesFragCoord ? ['vec4 scrim_fragCoord;'] : []),
    ...(parts.discards ? ['bool scrim_discarded = false;'] : []),
    'vec4 scrim_fragColor;',
  ];
  const writer = createLineWriter(0);
  writer.append(parts.functions);
  writer.own('void main() {');
  writer.indent(1);
  if (loopBudget) writer.own(LOOP_BUDGET_START);
  writer.append(parts.body);
  writer.own(output);
  if (loopBudget) writer.own(LOOP_BUDGET_END);
  writer.indent(-1);
  writer.own('}');
  return linkedShader(unit, head.join('\n'), writer, vertex);
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
