import type { IsfShader } from '../isf/isf-shader.ts';
import type { Expression, VariableSymbol } from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import { IMAGE_SUFFIXES, type Image } from './images.ts';
import type { LinkOptions } from './linked-pass.ts';
import type { Names } from './names.ts';
import type { PlannedPass } from './plan-passes.ts';

/** Images of one pass by the author's name, in the header's order, with samplers named for its text. */
export function passImages(shader: IsfShader, pass: PlannedPass, options: LinkOptions, names: Names): Map<string, Image> {
  const images = new Map<string, Image>();
  const absent = new Set(options.absent ?? []);
  const withoutDepth = new Set(options.withoutDepth ?? []);

  function add(name: string, kind: Image['kind'], isRoom: boolean, buffer = '', repeat = false): void {
    const sampler = names.fresh(name, IMAGE_SUFFIXES);
    images.set(name, { name, kind, isRoom, buffer, sampler, hasDepth: kind === 'input' && !withoutDepth.has(name), repeat });
  }

  for (const input of shader.inputs) {
    if (input.type === 'image') add(input.name, absent.has(input.name) ? 'absent' : 'input', false, '', input.repeat);
    if (input.type === 'depth') add(input.name, absent.has(input.name) ? 'absent' : 'room', true);
  }
  const targets = new Set([...shader.passes.map((other) => other.target), ...pass.readable.keys()]);
  for (const target of targets) {
    if (target === null || images.has(target)) continue;
    const buffer = pass.readable.get(target);
    add(target, buffer === undefined ? 'absent' : 'buffer', false, buffer);
  }
  return images;
}

/** Which images the sampler parameters of a function stand for; empty for a function without. */
export type ImageBinding = ReadonlyMap<VariableSymbol, Image>;

/** The image that an expression names: an image itself, or a parameter that stands for one. Null for anything else. */
export function imageOf(expression: Expression, images: ReadonlyMap<string, Image>, binding: ImageBinding): Image | null {
  if (expression.kind === 'group') return imageOf(expression.inner, images, binding);
  if (expression.kind !== 'name' || expression.symbol === null) return null;
  if (expression.symbol.role === 'image') return images.get(expression.symbol.name) ?? null;
  return binding.get(expression.symbol) ?? null;
}

/** As `imageOf`, for a place where nothing else can stand. */
export function needImage(
  expression: Expression | undefined,
  at: Expression,
  images: ReadonlyMap<string, Image>,
  binding: ImageBinding,
): Image {
  const image = expression === undefined ? null : imageOf(expression, images, binding);
  if (image !== null) return image;
  const what = expression?.kind === 'name' ? `"${expression.token.text}" is not an image` : 'The first value has to be an image';
  throw new GlslError(expression?.token ?? at.token, `${what}: "${at.token.text}" reads an image input or the TARGET of a pass.`);
}
