import type { LayerEncoding, NodeDefinition, ParamValue } from '../../nodes/kit/definition.ts';
import { getOwn } from './record.ts';

/** What the encoding of a node's layers depends on. */
export interface EncodedNode {
  readonly definition: Pick<NodeDefinition, 'inputs' | 'outputs'>;
  /** The value of a structure param. */
  paramValue(name: string): ParamValue | undefined;
  /** Encoding of the layer that is connected to an input; null if none is. */
  encodingAt(port: string): LayerEncoding | null;
}

/**
 * The encoding of a layer output (ADR 38).
 *
 * @example
 * outputEncoding(scene, 'layer'); // 'scene' if the param that decides has this value
 */
export function outputEncoding(node: EncodedNode, port: string): LayerEncoding {
  const encoding = getOwn(node.definition.outputs, port)?.encoding ?? 'display';
  if (encoding === 'same') return sharedEncoding(node, null) ?? 'display';
  if (typeof encoding === 'string') return encoding;
  return node.paramValue(encoding.param) === 'scene' ? 'scene' : 'display';
}

/**
 * The encoding that a layer input needs, or null if it takes either.
 *
 * @param port A layer input of the node.
 * @param among The connected inputs that decide the encoding if `port` has the encoding `either`. `earlier`: those before `port`, so that
 * only one of two different layers is wrong. `others`: all but `port`.
 *
 * @example
 * neededEncoding(sepia, 'inputImage'); // 'display'
 */
export function neededEncoding(node: EncodedNode, port: string, among: 'earlier' | 'others' = 'earlier'): LayerEncoding | null {
  const encoding = getOwn(node.definition.inputs, port)?.encoding ?? 'display';
  return encoding === 'either' ? sharedEncoding(node, { port, among }) : encoding;
}

/** Encoding of the layer at the first connected input that accepts either encoding; null if there is none. */
function sharedEncoding(
  { definition, encodingAt }: EncodedNode,
  asked: { readonly port: string; readonly among: 'earlier' | 'others' } | null,
): LayerEncoding | null {
  for (const [name, input] of Object.entries(definition.inputs)) {
    if (name === asked?.port) {
      if (asked.among === 'earlier') return null;
      continue;
    }
    const encoding = input.encoding === 'either' ? encodingAt(name) : null;
    if (encoding !== null) return encoding;
  }
  return null;
}

/** The node types that convert between the encodings, by the encoding of their output. */
export const CONVERSIONS: Readonly<Record<LayerEncoding, { readonly type: string; readonly title: string }>> = {
  display: { type: 'filter/tone-map', title: 'Tone map' },
  scene: { type: 'filter/to-scene', title: 'To scene' },
};
