import type { BuiltinUniform, LinkedShader, TargetFormat } from '../../program/program.ts';
import { UNIFORM_TYPES } from '../isf/given-symbols.ts';
import { hashText } from '../link/hash.ts';
import { colorFunction, helpersFor, type Image, type ImageUse, imageText, sizeUniform } from '../link/images.ts';
import { createLineWriter, type LineWriter, type MappedLines } from '../link/line-writer.ts';
import type { ImagePart, PassParts } from '../link/link-parts.ts';
import { FRAGMENT_HEAD, outputText, VERTEX_SHADER } from '../link/prelude.ts';
import type { FusedPart } from './fused-part.ts';
import {
  layerName,
  MOVED_POSITION,
  type MovedLayer,
  type MovedLayers,
  mainName,
  movedKey,
  movedLayers,
  movedReadText,
  passesMoved,
} from './moved-layers.ts';

/** Names that the linker gives to globals and reserved words of an author (`link/names.ts`). */
const GLOBAL = /\ba\d*_/g;

/** The variable with the color of the objects in whose materials passes are computed. */
export const DRAWN_COLOR = 'scrim_drawn';

/** GLSL functions that round a color as a target of a format stores it. */
export const ROUNDING: Readonly<Record<TargetFormat, 'scrim_as8' | 'scrim_asHalf' | null>> = {
  rgba8: 'scrim_as8',
  scene16f: 'scrim_asHalf',
  rgba16f: 'scrim_asHalf',
  rgba32f: null,
  r32f: null,
};

/**
 * 8 bits are rounded to the nearest step, as OpenGL ES 3.0.6, section 2.1.6.2, prefers. The conversion to integers also removes NaN, which
 * colors in [0, 1] do not contain.
 */
export const ROUNDING_TEXT = {
  scrim_as8: 'vec4 scrim_as8(vec4 color) { return vec4(ivec4(roundEven(clamp(color, 0.0, 1.0) * 255.0))) / 255.0; }',
  scrim_clampedAs8: `vec4 scrim_clampedAs8(vec4 color) { return roundEven(color * 255.0) / 255.0; }
vec3 scrim_clampedAs8(vec3 color) { return roundEven(color * 255.0) / 255.0; }`,
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
 *   { node: 'sepia-1', parts: sepia, from: new Map(), hardEdged: new Set(), aligned: new Set() },
 *   { node: 'invert-1', parts: invert, from: new Map([['a_inputImage', 0]]), hardEdged: new Set(), aligned: new Set() },
 * ]);
 */
export function fusePasses(passes: readonly FusedPart[]): LinkedShader {
  const moved = movedLayers(passes);
  const isMoved = passesMoved(moved);
  const composed = composePasses(passes, moved, isMoved);
  const writer = createLineWriter(0);
  writer.own([FRAGMENT_HEAD, ...composed.declarations].join('\n'));
  composed.printPasses(writer);
  const calls = passes.flatMap((_, i) => (isMoved.has(i) ? [] : [`  ${mainName(i)}();`]));
  writer.own(['void main() {', ...(isMoved.size > 0 ? [`  ${MOVED_POSITION} = scrim_uv;`] : []), ...calls, '}'].join('\n'));
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

/** Parts of a shader that computes passes. */
export interface ComposedPasses {
  /** Uniforms, functions and variables. */
  readonly declarations: readonly string[];
  /** Prints a function `mainName(i)` for each pass, which leaves the output of the last one in `scrim_output`. */
  printPasses(writer: LineWriter): void;
}

/**
 * Composes the parts of a shader for several passes.
 *
 * @param placed Passes that take their position from `MOVED_POSITION`.
 */
export function composePasses(passes: readonly FusedPart[], moved: MovedLayers, placed: ReadonlySet<number>): ComposedPasses {
  const images = passes.map((_, i) => atPlace(printImages(passes, i, moved), placed.has(i)));
  const outputs = passes.map((_, i) => storeText(passes, i));
  const called = [...images, ...outputs].join('\n');
  const projects = passes.some(({ parts }) => parts.projects);
  return {
    declarations: [
      ...builtinsOf(passes, moved.size > 0).map((name) => `uniform ${UNIFORM_TYPES[name]} ${name};`),
      ...passes.flatMap(({ parts }, i) => parts.params.map(({ type, name }) => `uniform ${type} ${fusedName(i, name)};`)),
      ...helpersFor(called, projects),
      ...roundingFunctions(called),
      ...passes.slice(1).map((_, i) => `vec4 ${layerName(i)};`),
      ...(passes.some(({ parts }) => parts.usesFragCoord) ? ['vec4 scrim_fragCoord;'] : []),
      ...(passes.some(({ parts }) => parts.discards) ? ['bool scrim_discarded;'] : []),
      'vec4 scrim_fragColor;',
      ...(placed.size > 0 ? [`vec2 ${MOVED_POSITION};`] : []),
      ...[...placed].map((i) => `void ${mainName(i)}();`),
      ...images.filter((text) => text !== ''),
    ],
    printPasses: (writer) => {
      passes.forEach(({ parts }, i) => {
        writer.append(inPass(parts.functions, parts, i, placed.has(i)));
        writer.own(`void ${mainName(i)}() {`);
        if (parts.discards) writer.own('  scrim_discarded = false;');
        writer.append(inPass(parts.body, parts, i, placed.has(i)));
        writer.indent(1);
        writer.own(outputs[i] ?? '');
        writer.indent(-1);
        writer.own('}');
      });
    },
  };
}

/** The rounding functions that a text calls. */
function roundingFunctions(called: string): string[] {
  return Object.entries(ROUNDING_TEXT).flatMap(([name, text]) => (called.includes(`${name}(`) ? [text] : []));
}

/** The statements at the end of a pass: its color becomes the output of the shader, or a layer for later passes. */
function storeText(passes: readonly FusedPart[], index: number): string {
  const parts = passes[index]?.parts;
  if (parts === undefined) throw new Error('There is no such pass.');
  const { output, format } = parts;
  const isLast = index === passes.length - 1;
  const name = isLast ? 'scrim_output' : layerName(index);
  const alpha = keptAlpha(passes, index);
  if (alpha !== null) {
    const straight = 'clamp(scrim_fragColor.rgb, 0.0, 1.0)';
    const color = isMultipliedLater(passes, index) ? straight : `${straight} * ${alpha}`;
    return `${name} = vec4(${isLast ? color : `scrim_clampedAs8(${color})`}, ${alpha});`;
  }
  if (isLast) return outputText(output);
  const round = output.clamps && format === 'rgba8' ? 'scrim_clampedAs8' : ROUNDING[format];
  return [...output.statements, `${name} = ${round === null ? output.color : `${round}(${output.color})`};`].join('\n');
}

/** The alpha of an earlier pass that a pass outputs unchanged: it is rounded and clamped already. Null if there is none. */
function keptAlpha(passes: readonly FusedPart[], index: number): string | null {
  const { parts, from } = passes[index] ?? {};
  const producer = parts?.keptAlpha ? from?.get(parts.keptAlpha) : undefined;
  if (producer === undefined || !parts?.output.clamps || passes[producer]?.parts.format !== 'rgba8') return null;
  return `${layerName(producer)}.a`;
}

/**
 * Whether the alpha of a pass's layer is 0 or 1 in each pixel. Rounding then leaves it as it is, and a color that is multiplied by it is the
 * straight color already.
 */
function isHardEdged(passes: readonly FusedPart[], index: number): boolean {
  const { parts, from, hardEdged } = passes[index] ?? {};
  if (!parts?.output.clamps || parts.format !== 'rgba8') return false;
  if (parts.keptAlpha === null) return parts.isOpaque;
  const producer = from?.get(parts.keptAlpha);
  return producer === undefined ? (hardEdged?.has(parts.keptAlpha) ?? false) : isHardEdged(passes, producer);
}

/**
 * Whether each reader of a layer whose alpha is 0 or 1 outputs that alpha, so that it multiplies with it too, or its readers do. What the
 * layer has for a color where alpha is 0 then does not matter.
 */
function isMultipliedLater(passes: readonly FusedPart[], index: number): boolean {
  if (index === passes.length - 1 || !isHardEdged(passes, index)) return false;
  return passes.every(({ parts, from }, reader) =>
    [...from].every(([sampler, producer]) => producer !== index || (parts.keptAlpha === sampler && keptAlpha(passes, reader) !== null)),
  );
}

/** Automatic uniforms of all passes, in the table's order. The size of a fused layer is that of the target. */
function builtinsOf(passes: readonly FusedPart[], areMoved: boolean): BuiltinUniform[] {
  const used = new Set(passes.flatMap(({ parts }) => parts.builtins));
  const readsSize = passes.some(({ parts, from }) => parts.images.some(({ image, uses }) => from.has(image.sampler) && uses.has('size')));
  if (readsSize || areMoved) used.add('RENDERSIZE');
  used.delete('PASSINDEX');
  return (Object.keys(UNIFORM_TYPES) as BuiltinUniform[]).filter((name) => used.has(name));
}

function printImages(passes: readonly FusedPart[], index: number, moved: MovedLayers): string {
  const pass = passes[index];
  if (pass === undefined) throw new Error('There is no such pass.');
  const { parts, from } = pass;
  const texts = parts.images.map((part) => {
    const { image, uses, reading } = part;
    if (pass.drawn?.has(image.sampler)) return `vec4 ${colorFunction(image)}(vec2 uv) { return ${DRAWN_COLOR}; }`;
    const producer = from.get(image.sampler);
    if (producer === undefined) {
      const isAligned = pass.aligned.has(image.sampler);
      // A color that is 0 where alpha is, and is multiplied by 1 elsewhere, is the straight one.
      const isStraight = isAligned && pass.hardEdged.has(image.sampler);
      return imageText(image, uses, isStraight ? { ...reading, premultiplied: true } : reading, isAligned);
    }
    return fusedImageText(part, producer, isHardEdged(passes, producer), moved.get(movedKey(index, image.sampler)) ?? null);
  });
  return fusedName(index, texts.filter((text) => text !== '').join('\n'));
}

/** The functions that read a layer of an earlier pass, which `computedBy` computes at another pixel. Its depth, if any, is a texture. */
function fusedImageText({ image, uses, reading }: ImagePart, producer: number, isHard: boolean, computedBy: MovedLayer | null): string {
  const texture = new Set<ImageUse>([...uses].filter((use) => use === 'depth'));
  const layer = layerName(producer);
  const isStored = reading.premultiplied || image.kind === 'buffer' || isHard;
  return [
    ...(texture.size > 0 ? [imageText(image, texture, reading)] : []),
    ...(uses.has('size') ? [`#define ${sizeUniform(image)} RENDERSIZE`] : []),
    ...(uses.has('color') ? [readText(image, isStored ? layer : `scrim_straight(${layer})`, computedBy)] : []),
  ].join('\n');
}

function readText(image: Image, color: string, computedBy: MovedLayer | null): string {
  const name = colorFunction(image);
  return computedBy === null ? `vec4 ${name}(vec2 uv) { return ${color}; }` : movedReadText(image, color, computedBy);
}

/** A text whose position is that of a pass which another pixel's invocation computes. */
function atPlace(text: string, isMoved: boolean): string {
  return isMoved ? text.replace(/\bscrim_uv\b/g, MOVED_POSITION) : text;
}

/** Lines of a pass with its names. */
function inPass({ lines, map }: MappedLines, { passIndex }: PassParts, index: number, isMoved: boolean): MappedLines {
  return {
    lines: lines.map((line) => atPlace(fusedName(index, line).replace(/\bPASSINDEX\b/g, String(passIndex)), isMoved)),
    map: map.map((place) => place && [index, place[1], place[2]]),
  };
}
