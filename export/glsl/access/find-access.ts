import type { Access } from '../../../nodes/kit/definition.ts';
import { calleesFirst, functionsOf } from '../check/call-graph.ts';
import type { CheckedShader } from '../check/check-shader.ts';
import { isImageType } from '../check/glsl-type.ts';
import { checkIsf } from '../isf/checked-isf.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import { classifyImageCall, type ImageCall } from '../link/image-call.ts';
import { varyingsOf } from '../link/link-vertex.ts';
import { decideBranch, reachableStatements } from '../link/pass-condition.ts';
import type { CallExpression, Expression, FunctionSymbol, Statement } from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import { partsOf } from '../syntax/walk-tree.ts';
import { createPositions, type Position } from './here.ts';

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

/** Pixels read per image; branches that are not taken count too. */
interface Reads {
  here: number;
  elsewhere: number;
}

type ReadsByImage = ReadonlyMap<string, Reads>;

/**
 * The images, by the author's names, of which a pass reads at most the current pixel. Empty if that is unclear.
 *
 * @example
 * imagesReadHere(checkIsf(shader).checked, 0); // Set { 'inputImage' }
 */
export function imagesReadHere(shader: CheckedShader, passIndex: number): ReadonlySet<string> {
  const reads = countReads(shader, passIndex, createPositions(collectCalls(shader, passIndex)));
  return new Set([...(reads ?? [])].flatMap(([image, { elsewhere }]) => (elsewhere === 0 ? [image] : [])));
}

/** Derivatives read neighboring pixels. */
const DERIVATIVES: ReadonlySet<string> = new Set(['dFdx', 'dFdy', 'fwidth']);

function accessOf(shader: CheckedShader, passIndex: number): Access {
  const reads = countReads(shader, passIndex, createPositions(collectCalls(shader, passIndex)));
  if (reads === null) return 'neighborhood';
  let access: Access = 'pointwise';
  for (const { here, elsewhere } of reads.values()) {
    if (elsewhere === 0) continue;
    if (here + elsewhere > 1) return 'neighborhood';
    access = 'displaced';
  }
  return access;
}

/**
 * Counts the pixels that a pass reads of each image. Null if the count is unclear: an image is passed to a function or a derivative is
 * computed.
 */
function countReads(shader: CheckedShader, passIndex: number, positionOf: (expression: Expression) => Position): ReadsByImage | null {
  const known = new Map<FunctionSymbol, ReadsByImage | null>();
  let unclear = false;

  function readsOf(count: (into: Map<string, Reads>) => void): ReadsByImage | null {
    const reads = new Map<string, Reads>();
    unclear = false;
    count(reads);
    return unclear ? null : reads;
  }

  function countCallee(symbol: FunctionSymbol, times: number, into: Map<string, Reads>): void {
    const reads = known.get(symbol) ?? null;
    if (reads === null) unclear = true;
    else for (const [image, { here, elsewhere }] of reads) add(into, image, here * times || 0, elsewhere * times || 0);
  }

  function countIn(part: Statement | Expression, times: number, into: Map<string, Reads>): void {
    const isLoop = part.kind === 'for' || part.kind === 'while' || part.kind === 'do';
    if (part.kind === 'call') countCall(part, times, into);
    // The initializer of a global runs once, before `main`, so its calls do not count.
    for (const inner of taken(part, passIndex)) countIn(inner, isLoop ? Number.POSITIVE_INFINITY : times, into);
  }

  function countCall(call: CallExpression, times: number, into: Map<string, Reads>): void {
    if (DERIVATIVES.has(call.token.text) && call.symbol === null) unclear = true;
    if (call.symbol?.kind === 'function') countCallee(call.symbol, times, into);
    const read = classifyImageCall(call);
    const [image] = call.args;
    // A curve is the same for all pixels.
    if (read === null || read.use === 'size' || read.use === 'curve' || image === undefined) return;
    if (image.kind !== 'name' || image.symbol?.role !== 'image') unclear = true;
    const here = isHere(call, read, positionOf);
    add(into, image.token.text, here ? times : 0, here ? 0 : times);
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

function add(into: Map<string, Reads>, image: string, here: number, elsewhere: number): void {
  const reads = into.get(image) ?? { here: 0, elsewhere: 0 };
  reads.here += here;
  reads.elsewhere += elsewhere;
  into.set(image, reads);
}

function isHere(call: CallExpression, read: ImageCall, positionOf: (expression: Expression) => Position): boolean {
  if (read.use === 'size' || read.use === 'curve' || (read.use === 'color' && read.position === 'here')) return true;
  const at = call.args[1];
  if (at === undefined) return false;
  const position = positionOf(at);
  if (read.use === 'depth' || read.position === 'norm') return position === 'here-norm';
  return read.position === 'pixel' && position === 'here-pixel';
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
    for (const inner of taken(part, passIndex)) visit(inner);
  }

  for (const declaration of shader.declarations) {
    if (declaration.kind === 'variables') visit(declaration);
    else if (declaration.body !== null) visit(declaration.body);
  }
  return calls;
}

function taken(part: Statement | Expression, passIndex: number): readonly (Statement | Expression)[] {
  if (part.kind === 'if') {
    const branch = decideBranch(part, passIndex);
    if (branch !== undefined) return branch === null ? [] : [branch];
  }
  return part.kind === 'block' ? reachableStatements(part.statements, passIndex) : partsOf(part);
}
