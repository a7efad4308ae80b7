import { MAX_SOUND_COUNT } from '../../program/texture-sizes.ts';
import type { IsfInput, IsfShader } from '../isf/isf-shader.ts';
import type { Expression, VariableSymbol } from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import { IMAGE_SUFFIXES, type Image } from './images.ts';
import type { LinkedSound, LinkOptions } from './linked-pass.ts';
import type { Names } from './names.ts';
import type { PlannedPass } from './plan-passes.ts';

/**
 * Images of a pass by the author's name, in the header's order, with samplers named for its text. `stray` are images that the text declares
 * but the header does not.
 */
export function passImages(
  shader: IsfShader,
  pass: PlannedPass,
  options: LinkOptions,
  names: Names,
  stray: readonly VariableSymbol[],
): Map<string, Image> {
  const images = new Map<string, Image>();
  const absent = new Set(options.absent ?? []);
  const withoutDepth = new Set(options.withoutDepth ?? []);

  function add(
    name: string,
    kind: Image['kind'],
    more: Partial<Pick<Image, 'isCube' | 'isRoom' | 'buffer' | 'sound' | 'repeat'>> = {},
  ): void {
    const sampler = names.fresh(name, IMAGE_SUFFIXES);
    const hasDepth = kind === 'input' && !withoutDepth.has(name);
    images.set(name, {
      name,
      kind,
      sampler,
      hasDepth,
      isCube: kind === 'cube',
      isRoom: false,
      buffer: '',
      sound: null,
      repeat: false,
      ...more,
    });
  }

  for (const input of shader.inputs) {
    const { name, type, repeat } = input;
    if (type === 'image') add(name, absent.has(name) ? 'absent' : 'input', { repeat });
    if (type === 'depth') add(name, absent.has(name) ? 'absent' : 'room', { isRoom: true });
    if (type === 'curve' || type === 'gradient') add(name, type);
    if (type === 'audio' || type === 'audioFFT') add(name, absent.has(name) ? 'absent' : 'sound', { sound: soundOf(input) });
  }
  for (const { name, cube } of shader.imported) if (!images.has(name)) add(name, cube ? 'cube' : 'picture');
  const targets = new Set([...shader.passes.map((other) => other.target), ...pass.readable.keys()]);
  for (const target of targets) {
    if (target === null || images.has(target)) continue;
    const buffer = pass.readable.get(target);
    add(target, buffer === undefined ? 'absent' : 'buffer', { buffer: buffer ?? '' });
  }
  for (const { name, type } of stray) if (!images.has(name)) add(name, 'absent', { isCube: type === 'samplerCube' });
  return images;
}

/** Default sizes that most shaders expect. */
const DEFAULT_COUNTS = { waveform: 1024, spectrum: 512 } as const;

function soundOf({ type, sampleCount }: IsfInput): LinkedSound {
  const analysis = type === 'audio' ? 'waveform' : 'spectrum';
  return { analysis, count: Math.min(sampleCount ?? DEFAULT_COUNTS[analysis], MAX_SOUND_COUNT) };
}

/** The images that a function's sampler parameters refer to; empty if it has none. */
export type ImageBinding = ReadonlyMap<VariableSymbol, Image>;

/** The image that an expression refers to, directly or by a parameter; null otherwise. */
export function imageOf(expression: Expression, images: ReadonlyMap<string, Image>, binding: ImageBinding): Image | null {
  if (expression.kind === 'group') return imageOf(expression.inner, images, binding);
  if (expression.kind !== 'name' || expression.symbol === null) return null;
  if (expression.symbol.role === 'image') return images.get(expression.symbol.name) ?? null;
  return binding.get(expression.symbol) ?? null;
}

/** The image that an expression refers to. Unlike `imageOf`, throws if there is none. */
export function needImage(
  expression: Expression | undefined,
  at: Expression,
  images: ReadonlyMap<string, Image>,
  binding: ImageBinding,
): Image {
  const image = expression === undefined ? null : imageOf(expression, images, binding);
  if (image !== null) return image;
  const what = expression?.kind === 'name' ? `"${expression.token.text}" is not an image` : 'The first argument must be an image';
  throw new GlslError(expression?.token ?? at.token, `${what}: "${at.token.text}" reads an image input or the TARGET of a pass.`);
}
