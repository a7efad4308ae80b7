import type { Node } from 'jsonc-parser';
import { entries, flagOf, type Header, items, numberOf, property, textOf } from './isf-header.ts';
import type { IsfImport, IsfInput, IsfPass, NamedSize } from './isf-shader.ts';
import { isIdentifier } from './read-inputs.ts';
import { isSizeProblem, parseSizeExpression } from './size-expression.ts';

/** Maximum number of passes; each is a draw call per view and frame. */
const MAX_PASSES = 64;

const SIDES = 6;

const OUTPUT_PASS: IsfPass = { target: null, persistent: false, float: false, half: false, width: null, height: null };

/** Reads `PASSES`, and `PERSISTENT_BUFFERS` of version 1. Without passes, one pass draws the output. */
export function readPasses(header: Header, inputs: readonly IsfInput[]): IsfPass[] {
  const list = property(header.root, 'PASSES');
  if (list !== undefined && list.type !== 'array' && list.type !== 'null')
    header.error(list, 'PASSES must be a list: [ { "TARGET": … }, { } ].');
  const nodes = items(list);
  if (nodes.length > MAX_PASSES) header.error(nodes[MAX_PASSES] as Node, `The shader has more than ${MAX_PASSES} passes.`);
  const buffers = readPersistentBuffers(header);
  const passes = nodes.slice(0, MAX_PASSES).map((node) => readPass(header, node, inputs, buffers));
  return passes.length === 0 ? [OUTPUT_PASS] : passes;
}

function readPass(header: Header, node: Node, inputs: readonly IsfInput[], buffers: ReadonlyMap<string, Node | null>): IsfPass {
  if (node.type !== 'object') {
    header.error(node, 'A pass must be an object: { } or { "TARGET": … }.');
    return OUTPUT_PASS;
  }
  const targetNode = property(node, 'TARGET');
  const target = textOf(targetNode)?.trim() || null;
  if (targetNode !== undefined && target !== null && !isIdentifier(target)) {
    header.error(targetNode, 'The TARGET of a pass is invalid. Use letters, digits and “_”, and start with no digit.');
  } else if (targetNode !== undefined && inputs.some((input) => input.name === target)) {
    header.error(targetNode, `The TARGET "${target}" has the name of an input.`, 'Give the target another name.');
  }
  const buffer = target === null ? undefined : buffers.get(target);
  const settings = [node, buffer ?? undefined];
  return {
    target,
    persistent: target !== null && (flagOf(property(node, 'PERSISTENT')) || buffer !== undefined),
    float: settings.some((from) => flagOf(property(from, 'FLOAT'))),
    half: settings.some((from) => flagOf(property(from, 'SCRIM_HALF'))),
    width: readSize(header, settings, 'WIDTH', inputs),
    height: readSize(header, settings, 'HEIGHT', inputs),
  };
}

function readSize(header: Header, settings: readonly (Node | undefined)[], key: string, inputs: readonly IsfInput[]): NamedSize | null {
  const node = settings.map((from) => property(from, key)).find((found) => found !== undefined);
  if (node === undefined) return null;
  const number = numberOf(node);
  if (number !== null) {
    if (number >= 1) return [number];
    header.error(node, `${key} of a pass must be at least 1 pixel.`);
    return null;
  }
  const text = textOf(node);
  if (text === null || text.trim() === '') {
    if (text === null) header.error(node, `${key} of a pass must be a number of pixels or an expression such as "$WIDTH / 2.0".`);
    return null;
  }
  const size = parseSizeExpression(text, (name) => inputs.some((input) => input.name === name && /^(float|long|bool)$/.test(input.type)));
  if (!isSizeProblem(size)) return size.length === 1 && isWhole(size[0], key) ? null : size;
  // Plus one for the opening quote.
  header.error(node.offset + 1 + size.offset, size.message);
  return null;
}

/** Whether a size is that of the layer, as in `"WIDTH": "$WIDTH"`. */
function isWhole(item: NamedSize[number] | undefined, key: string): boolean {
  return typeof item === 'object' && 'op' in item && item.op === key.toLowerCase();
}

/**
 * Reads `PERSISTENT_BUFFERS` of version 1: a list of names or of objects with a `NAME`, or an object from name to settings.
 *
 * @returns Buffer name → its settings, or null for a name alone.
 */
function readPersistentBuffers(header: Header): Map<string, Node | null> {
  const node = property(header.root, 'PERSISTENT_BUFFERS');
  const buffers = new Map<string, Node | null>();
  for (const item of items(node)) {
    const name = textOf(item) ?? textOf(property(item, 'NAME'));
    if (name !== null) buffers.set(name, item.type === 'object' ? item : null);
  }
  if (node?.type === 'object') for (const [key, value] of entries(node)) buffers.set(key.value as string, value);
  return buffers;
}

/** Reads `IMPORTED`: an object from name to `{ "PATH": … }`, or a list of `{ "NAME": …, "PATH": … }`; a cube has a list of six paths. */
export function readImported(header: Header): IsfImport[] {
  const node = property(header.root, 'IMPORTED');
  if (node === undefined) return [];
  const named: (readonly [Node, Node])[] = node.type === 'object' ? [...entries(node)] : [];
  for (const item of items(node)) {
    const name = property(item, 'NAME');
    if (name !== undefined) named.push([name, item]);
  }
  return named.map(([name, value]) => {
    const path = property(value, 'PATH');
    const paths = path?.type === 'array' ? items(path).map(textOf) : [textOf(path)];
    const { line, column } = header.place(name.offset);
    const found = paths.filter((p) => p !== null);
    const cube = textOf(property(value, 'TYPE')) === 'cube' || found.length > 1;
    if (found.length !== (cube ? SIDES : 1)) {
      const wanted = cube ? 'a PATH with six files: +x, -x, +y, -y, +z, -z' : 'a PATH';
      header.error(name, `The imported image “${String(name.value)}” needs ${wanted}.`);
    }
    return { name: String(name.value), paths: found, cube, line, column };
  });
}
