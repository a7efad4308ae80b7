import type { BuiltinUniform, LinkedShader, TargetFormat } from '../../program/program.ts';
import { UNIFORM_TYPES } from '../isf/given-symbols.ts';
import { hashText } from '../link/hash.ts';
import { colorFunction, helpersFor, type ImageUse, imageText, sizeUniform } from '../link/images.ts';
import { createLineWriter, type MappedLines } from '../link/line-writer.ts';
import type { ImagePart, PassParts } from '../link/link-parts.ts';
import { FRAGMENT_HEAD, outputText, VERTEX_SHADER } from '../link/prelude.ts';

/** A pass to fuse. */
export interface FusedPart {
  readonly node: string;
  readonly parts: PassParts;
  /** Sampler → index of the earlier pass that draws its layer. The fused shader reads the layer from a variable. */
  readonly from: ReadonlyMap<string, number>;
}

/** Names that the linker gives to globals and reserved words of an author (`link/names.ts`). */
const GLOBAL = /\ba\d*_/g;

/** GLSL functions that round a color as a target of a format stores it. */
const ROUNDING: Readonly<Record<TargetFormat, 'scrim_as8' | 'scrim_asHalf' | null>> = {
  rgba8: 'scrim_as8',
  scene16f: 'scrim_asHalf',
  rgba16f: 'scrim_asHalf',
  rgba32f: null,
  r32f: null,
};

/** 8 bits are rounded to the nearest step, as OpenGL ES 3.0.6, section 2.1.6.2, prefers. The conversion to integers also removes NaN. */
const ROUNDING_TEXT = {
  scrim_as8: 'vec4 scrim_as8(vec4 color) { return vec4(ivec4(roundEven(clamp(color, 0.0, 1.0) * 255.0))) / 255.0; }',
  scrim_asHalf:
    'vec4 scrim_asHalf(vec4 color) { return vec4(unpackHalf2x16(packHalf2x16(color.rg)), unpackHalf2x16(packHalf2x16(color.ba))); }',
} as const;

/**
 * The name that a fused shader gives to a sampler or a param's uniform of one of its passes.
 *
 * @example
 * fusedName(1, 'a_amount'); // 'b1_a_amount'
 */
export function fusedName(index: number, name: string): string {
  return name.replace(GLOBAL, `b${index}_$&`);
}

/**
 * Composes one shader of several passes. Each may read the current pixel of layers that earlier passes draw. Between passes, colors are
 * rounded as their targets would store them, so the shader draws what the passes would draw one after the other.
 *
 * Global names of each pass get a prefix (`b0_`, `b1_`, …) that no other name of a linked text has. Automatic uniforms have the same value
 * in all passes, except `PASSINDEX`, which becomes a constant.
 *
 * @param passes In drawing order. All draw the same number of pixels; the last one gives the output.
 * @returns The shader, with a source map of all files.
 *
 * @example
 * const shader = fusePasses([
 *   { node: 'sepia-1', parts: sepia, from: new Map() },
 *   { node: 'invert-1', parts: invert, from: new Map([['a_inputImage', 0]]) },
 * ]);
 */
export function fusePasses(passes: readonly FusedPart[]): LinkedShader {
  const images = passes.map(printImages);
  const outputs = passes.map(({ parts }, i) => (i === passes.length - 1 ? outputText(parts.output) : storeText(parts, i)));
  const called = [...images, ...outputs].join('\n');
  const projects = passes.some(({ parts }) => parts.projects);
  const head = [
    FRAGMENT_HEAD,
    ...builtinsOf(passes).map((name) => `uniform ${UNIFORM_TYPES[name]} ${name};`),
    ...passes.flatMap(({ parts }, i) => parts.params.map(({ type, name }) => `uniform ${type} ${fusedName(i, name)};`)),
    ...helpersFor(called, projects),
    ...Object.entries(ROUNDING_TEXT).flatMap(([name, text]) => (called.includes(`${name}(`) ? [text] : [])),
    ...passes.slice(1).map((_, i) => `vec4 ${layerName(i)};`),
    ...images.filter((text) => text !== ''),
    ...(passes.some(({ parts }) => parts.usesFragCoord) ? ['vec4 scrim_fragCoord;'] : []),
    ...(passes.some(({ parts }) => parts.discards) ? ['bool scrim_discarded;'] : []),
    'vec4 scrim_fragColor;',
  ];
  const writer = createLineWriter(0);
  writer.own(head.join('\n'));
  passes.forEach(({ parts }, i) => {
    writer.append(inPass(parts.functions, parts, i));
    writer.own(`void ${mainName(i)}() {`);
    if (parts.discards) writer.own('  scrim_discarded = false;');
    writer.append(inPass(parts.body, parts, i));
    writer.indent(1);
    writer.own(outputs[i] ?? '');
    writer.indent(-1);
    writer.own('}');
  });
  writer.own(['void main() {', ...passes.map((_, i) => `  ${mainName(i)}();`), '}'].join('\n'));
  const fragment = `${writer.lines.join('\n')}\n`;
  return {
    id: hashText(`${VERTEX_SHADER}\0${fragment}`),
    vertex: VERTEX_SHADER,
    fragment,
    sourceMap: {
      sources: passes.map(({ parts }) => parts.file),
      nodes: passes.map(({ node }) => node),
      lines: writer.map,
    },
  };
}

function layerName(index: number): string {
  return `b${index}_layer`;
}

function mainName(index: number): string {
  return `b${index}_main`;
}

function storeText({ output, format }: PassParts, index: number): string {
  const round = ROUNDING[format];
  const stored = round === null ? output.color : `${round}(${output.color})`;
  return [...output.statements, `${layerName(index)} = ${stored};`].join('\n');
}

/** Automatic uniforms of all passes, in the table's order. The size of a fused layer is that of the target. */
function builtinsOf(passes: readonly FusedPart[]): BuiltinUniform[] {
  const used = new Set(passes.flatMap(({ parts }) => parts.builtins));
  const readsSize = passes.some(({ parts, from }) => parts.images.some(({ image, uses }) => from.has(image.sampler) && uses.has('size')));
  if (readsSize) used.add('RENDERSIZE');
  used.delete('PASSINDEX');
  return (Object.keys(UNIFORM_TYPES) as BuiltinUniform[]).filter((name) => used.has(name));
}

function printImages({ parts, from }: FusedPart, index: number): string {
  const texts = parts.images.map((part) => {
    const { image, uses, reading } = part;
    const producer = from.get(image.sampler);
    return producer === undefined ? imageText(image, uses, reading) : fusedImageText(part, producer);
  });
  return fusedName(index, texts.filter((text) => text !== '').join('\n'));
}

/** The functions that read a layer of an earlier pass. Its depth, if any, is a texture. */
function fusedImageText({ image, uses, reading }: ImagePart, producer: number): string {
  const texture = new Set<ImageUse>([...uses].filter((use) => use === 'depth'));
  const layer = layerName(producer);
  const isStored = reading.premultiplied || image.kind === 'buffer';
  return [
    ...(texture.size > 0 ? [imageText(image, texture, reading)] : []),
    ...(uses.has('size') ? [`#define ${sizeUniform(image)} RENDERSIZE`] : []),
    ...(uses.has('color') ? [`vec4 ${colorFunction(image)}(vec2 uv) { return ${isStored ? layer : `scrim_straight(${layer})`}; }`] : []),
  ].join('\n');
}

/** Lines of a pass with its names. */
function inPass({ lines, map }: MappedLines, { passIndex }: PassParts, index: number): MappedLines {
  return {
    lines: lines.map((line) => fusedName(index, line).replace(/\bPASSINDEX\b/g, String(passIndex))),
    map: map.map((place) => place && [index, place[1], place[2]]),
  };
}
