import { givenSymbols } from '../isf/given-symbols.ts';
import { findInput, type IsfShader, imageInputs } from '../isf/isf-shader.ts';
import type { VariableSymbol } from '../syntax/ast.ts';
import { colorFunction, depthFunction, helpersFor, type Image, type ImageUse, imageText, samplerFor } from './images.ts';
import { createLineWriter } from './line-writer.ts';
import type { PartedPass } from './link-parts.ts';
import { linkedShader } from './link-pass.ts';
import { namePass } from './link-unit.ts';
import type { LinkedUniform, LinkOptions } from './linked-pass.ts';
import { planPasses } from './plan-passes.ts';
import { FRAGMENT_HEAD } from './prelude.ts';

/** A float input of this name scales the alpha of the first image. */
const OPACITY = 'opacity';

/**
 * Links the pass that computes the depth of a file with two images, in meters (docs/ARCHITECTURE.md, “Drawing”). It is drawn only if the depth
 * is read.
 *
 * - `"SCRIM_DEPTH": "over"`: that of the first image where its alpha, times `opacity` if there is such an input, exceeds one half, else that
 *   of the second.
 * - `"SCRIM_DEPTH": "nearer"`: that of the nearer image where its alpha exceeds one half, else that of the other. An image without depth is
 *   farther than one with it.
 *
 * @throws Error if the file's depth is not computed (`definition.outputs.layer.depth` is not `true`).
 */
export function linkIsfDepth(shader: IsfShader, options: LinkOptions): PartedPass {
  const [firstPass] = planPasses(shader);
  const [topInput, bottomInput] = imageInputs(shader);
  const isNearer = shader.depth === 'nearer';
  if ((!isNearer && shader.depth !== 'over') || topInput === undefined || firstPass === undefined)
    throw new Error(`${shader.file} computes no depth.`);
  const given = givenSymbols(shader);
  const { names, images } = namePass({ shader, given, options }, firstPass);
  const top = images.get(topInput.name);
  const bottom = images.get((bottomInput ?? topInput).name);
  if (top === undefined || bottom === undefined) throw new Error(`The images of ${shader.file} have no names.`);

  const opacity = given.get(OPACITY);
  const fades = opacity?.role === 'input' && findInput(shader, OPACITY)?.type === 'float';
  const uniforms: LinkedUniform[] = fades ? [{ name: names.of(opacity as VariableSymbol), type: 'float', source: { param: OPACITY } }] : [];
  const uses = new Map([[top, new Set<ImageUse>(['color', 'depth'])]]);
  if (bottom !== top) uses.set(bottom, new Set<ImageUse>(isNearer ? ['color', 'depth'] : ['depth']));
  const texts = [...uses].map(([image, use]) => imageText(image, use, shader));
  const head = [FRAGMENT_HEAD, ...uniforms.map((u) => `uniform ${u.type} ${u.name};`), ...helpersFor(texts.join('\n'), false), ...texts];
  const alphaOf = (image: Image): string => `${colorFunction(image)}(scrim_uv).a`;
  const depthOf = (image: Image): string => `${depthFunction(image)}(scrim_uv)`;
  const opaque = `${alphaOf(top)}${uniforms.map((u) => ` * ${u.name}`).join('')} > 0.5`;
  const writer = createLineWriter(0);
  writer.own(
    isNearer
      ? `void main() {
  float first = ${depthOf(top)};
  float second = ${depthOf(bottom)};
  bool isFirst = second <= 0.0 || (first > 0.0 && first <= second);
  bool isOpaque = (isFirst ? ${alphaOf(top)} : ${alphaOf(bottom)}) > 0.5;
  scrim_output = vec4(isFirst == isOpaque ? first : second, 0.0, 0.0, 1.0);
}`
      : `void main() {
  bool isTop = ${opaque};
  scrim_output = vec4(isTop ? ${depthOf(top)} : ${depthOf(bottom)}, 0.0, 0.0, 1.0);
}`,
  );
  const samplers = [...uses].flatMap(([image, use]) => [...use].map((one) => samplerFor(image, one)));
  return {
    shader: linkedShader({ shader, options }, head.join('\n'), writer),
    passIndex: firstPass.passIndex,
    target: { kind: 'output', format: 'r32f' },
    samplers: samplers.filter((sampler) => sampler !== null),
    uniforms,
    parts: 'depth',
  };
}
