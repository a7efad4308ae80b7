import type { Access } from '../../../nodes/kit/definition.ts';
import { calleesFirst, functionsOf } from '../check/call-graph.ts';
import type { CheckedShader } from '../check/check-shader.ts';
import { isImageType } from '../check/glsl-type.ts';
import { checkIsf } from '../isf/checked-isf.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import { classifyImageCall, type ImageCall, isTableRead } from '../link/image-call.ts';
import { varyingsOf } from '../link/link-vertex.ts';
import type { CallExpression, Expression, FunctionSymbol, Statement } from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import { createPositions } from './here.ts';
import { createTexelReads } from './pixel-grid.ts';
import { takenParts } from './taken-parts.ts';

/**
 * Finds out from the text how a shader reads its images: `neighborhood` if unknown, because the compiler may then assume nothing. A file
 * with several passes reads several pixels through its buffers.
 */
export function findAccess(shader: IsfShader): Access {
  if (shader.passes.some((pass) => pass.persistent)) return 'persistent';
  if (shader.passes.some((pass) => pass.width !== null || pass.height !== null)) return 'resize';
  const passIndex = shader.passes.length - 1;
  if (shader.passes.filter((pass, i) => pass.target !== null || i === passIndex).length > 1) return 'neighborhood';
  try {
    const { checked } = checkIsf(shader);
    // A varying of a vertex shader may be any position.
    return varyingsOf(checked).size > 0 || shader.vertex !== null ? 'neighborhood' : accessOf(checked, passIndex);
  } catch (error) {
    if (error instanceof GlslError) return 'neighborhood';
    throw error;
  }
}

/**
 * Pixels that a pass reads of an image: at the current pixel, at the center of another one (`createTexelReads`), and anywhere else. Branches
 * that are not taken count too; infinite in loops.
 */
export interface ImageReads {
  readonly here: number;
  readonly texels: number;
  readonly elsewhere: number;
}

type ReadsByImage = ReadonlyMap<string, ImageReads>;

/**
 * The pixels that a pass reads, by the author's names of images. Null if that is unclear: an image is passed to a function, or a derivative
 * is computed, which reads neighboring pixels.
 *
 * @example
 * imageReads(checkIsf(shader).checked, 0)?.get('inputImage'); // { here: 1, texels: 0, elsewhere: 0 }
 */
export function imageReads(shader: CheckedShader, passIndex: number): ReadsByImage | null {
  return countReads(shader, passIndex, createKinds(collectCalls(shader, passIndex)));
}

/** Derivatives read neighboring pixels. */
const DERIVATIVES: ReadonlySet<string> = new Set(['dFdx', 'dFdy', 'fwidth']);

function accessOf(shader: CheckedShader, passIndex: number): Access {
  const reads = imageReads(shader, passIndex);
  if (reads === null) return 'neighborhood';
  let access: Access = 'pointwise';
  for (const { here, texels, elsewhere } of reads.values()) {
    if (texels + elsewhere === 0) continue;
    if (here + texels + elsewhere > 1) return 'neighborhood';
    access = 'displaced';
  }
  return access;
}

/**
 * Counts the pixels that a pass reads of each image. Null if the count is unclear: an image is passed to a function or a derivative is
 * computed.
 */
function countReads(shader: CheckedShader, passIndex: number, kindOf: FindKind): ReadsByImage | null {
  const known = new Map<FunctionSymbol, ReadsByImage | null>();
  let unclear = false;

  function readsOf(count: (into: Map<string, ImageReads>) => void): ReadsByImage | null {
    const reads = new Map<string, ImageReads>();
    unclear = false;
    count(reads);
    return unclear ? null : reads;
  }

  function countCallee(symbol: FunctionSymbol, times: number, into: Map<string, ImageReads>): void {
    const reads = known.get(symbol) ?? null;
    if (reads === null) unclear = true;
    else for (const [image, read] of reads) add(into, image, read, times);
  }

  function countIn(part: Statement | Expression, times: number, into: Map<string, ImageReads>): void {
    const isLoop = part.kind === 'for' || part.kind === 'while' || part.kind === 'do';
    if (part.kind === 'call') countCall(part, times, into);
    // The initializer of a global runs once, before `main`, so its calls do not count.
    for (const inner of takenParts(part, passIndex)) countIn(inner, isLoop ? Number.POSITIVE_INFINITY : times, into);
  }

  function countCall(call: CallExpression, times: number, into: Map<string, ImageReads>): void {
    if (DERIVATIVES.has(call.token.text) && call.symbol === null) unclear = true;
    if (call.symbol?.kind === 'function') countCallee(call.symbol, times, into);
    const read = classifyImageCall(call);
    const [image] = call.args;
    // A curve or a gradient is the same for all pixels.
    if (read === null || isTableRead(read) || image === undefined) return;
    // The size of a texture is lost where its pass is fused with this one.
    if (read.use === 'size' && !read.isStored) return;
    if (image.kind !== 'name' || image.symbol?.role !== 'image') unclear = true;
    add(into, image.token.text, { ...NONE, [kindOf(call, read)]: 1 }, times);
  }

  for (const symbol of calleesFirst(functionsOf(shader.declarations))) {
    const { body } = symbol.declaration;
    const reads = readsOf((into) => {
      if (symbol.parameterTypes.some(isImageType)) unclear = true;
      if (body !== null) countIn(body, 1, into);
    });
    known.set(symbol, reads);
  }
  const { main, declarations } = shader;
  return readsOf((total) => {
    for (const declaration of declarations) if (declaration.kind === 'variables') countIn(declaration, 1, total);
    if (main.symbol !== null) countCallee(main.symbol, 1, total);
  });
}

const NONE: ImageReads = { here: 0, texels: 0, elsewhere: 0 };

function add(into: Map<string, ImageReads>, image: string, more: ImageReads, times: number): void {
  const reads = into.get(image) ?? NONE;
  // No read in an infinite loop is no read.
  into.set(image, {
    here: reads.here + (more.here * times || 0),
    texels: reads.texels + (more.texels * times || 0),
    elsewhere: reads.elsewhere + (more.elsewhere * times || 0),
  });
}

type FindKind = (call: CallExpression, read: ImageCall) => keyof ImageReads;

function createKinds(calls: Map<FunctionSymbol, CallExpression[]>): FindKind {
  const positionOf = createPositions(calls);
  const isTexel = createTexelReads(calls);

  function isHere(call: CallExpression, read: ImageCall): boolean {
    if (read.use === 'size') return read.isStored !== true;
    if (isTableRead(read) || (read.use === 'color' && read.position === 'here')) return true;
    const [image, at] = call.args;
    if (image === undefined || at === undefined) return false;
    const position = positionOf(at, image.token.text);
    if (read.use === 'depth' || read.position === 'norm') return position === 'here-norm';
    return read.position === 'pixel' && position === 'here-pixel';
  }

  return (call, read) => (isHere(call, read) ? 'here' : isTexel(call) ? 'texels' : 'elsewhere');
}

/** Collects the calls of each function in a shader, except those in branches that the pass cannot take. */
function collectCalls(shader: CheckedShader, passIndex: number): Map<FunctionSymbol, CallExpression[]> {
  const calls = new Map<FunctionSymbol, CallExpression[]>();

  function visit(part: Statement | Expression): void {
    if (part.kind === 'call' && part.symbol?.kind === 'function') {
      const known = calls.get(part.symbol);
      if (known === undefined) calls.set(part.symbol, [part]);
      else known.push(part);
    }
    for (const inner of takenParts(part, passIndex)) visit(inner);
  }

  for (const declaration of shader.declarations) {
    if (declaration.kind === 'variables') visit(declaration);
    else if (declaration.body !== null) visit(declaration.body);
  }
  return calls;
}
