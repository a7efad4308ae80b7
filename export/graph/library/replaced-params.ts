import type { InputPort } from '../../../nodes/kit/definition.ts';

/**
 * The params that a node does not read because of what is connected to its inputs (`InputPort.replaces`).
 *
 * @returns Param → the input that replaces it; empty for most nodes.
 *
 * @example
 * replacedParams(definition, (port) => wires.some(({ to }) => to.node === id && to.port === port));
 */
export function replacedParams(
  { inputs }: { readonly inputs: Readonly<Record<string, InputPort>> },
  isConnected: (port: string) => boolean,
): ReadonlyMap<string, string> {
  const replaced = Object.entries(inputs).flatMap(([port, { replaces }]) =>
    replaces !== undefined && isConnected(port) ? replaces.map((param) => [param, port] as const) : [],
  );
  return replaced.length === 0 ? NONE : new Map(replaced);
}

const NONE: ReadonlyMap<string, string> = new Map();
