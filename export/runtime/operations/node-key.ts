import type { DrawOperation, InputRef, NodeOperation, ShadowMapOperation } from '../../program/program.ts';

/**
 * Key of a node. If it is equal after a recompile, the node is kept with its state. Slot numbers and sources of pulses are excluded,
 * because views are connected again; so is the target of a draw, because it is passed with every draw.
 */
export function nodeKey(
  operation: NodeOperation,
  slotType: (slot: number) => string,
  assetPath: (asset: string | null) => string | null,
): string {
  const ref = (input: InputRef): unknown => (input.kind === 'slot' ? ['slot', slotType(input.slot)] : input);
  const outputs = Object.entries(operation.outputs).filter(([, output]) => !(isDraw(operation) && output.kind === 'layer'));
  return JSON.stringify([
    operation.kind,
    operation.node,
    operation.type,
    sorted(operation.inputs, (refs, port) =>
      operation.pulses?.includes(port) ? 'pulses' : operation.poses?.includes(port) ? ['poses', refs.length] : refs.map(ref),
    ),
    sorted(Object.fromEntries(outputs), ref),
    sorted(operation.params, slotType),
    sorted(operation.config, (value) => value),
    sorted(operation.assets, (asset) => [asset, assetPath(asset)]),
    isDraw(operation)
      ? [operation.shadowMaps, drawOcclusion(operation, slotType), ...(operation.effects ? [operation.effects] : [])]
      : null,
  ]);
}

export function shadowMapsKey(operation: ShadowMapOperation): string {
  return JSON.stringify([operation.casters, operation.lights]);
}

export function isDraw(operation: NodeOperation): operation is DrawOperation {
  return operation.kind === 'draw';
}

function drawOcclusion(operation: DrawOperation, slotType: (slot: number) => string): unknown {
  const { occlusion } = operation;
  return occlusion && [occlusion.roomDepth, sorted(occlusion.params, slotType)];
}

function sorted<T>(record: Readonly<Record<string, T>>, value: (entry: T, key: string) => unknown): unknown {
  return Object.keys(record)
    .sort()
    .map((key) => [key, value(record[key] as T, key)]);
}
