import type { Operation, Program } from '../program/program.ts';
import type { ReportedAsset } from './assets/prepared-asset.ts';

/** What a node costs, in bytes before gzip. Passes that are drawn by one shader are one entry with several nodes. */
export interface ReportedNode {
  /** Ids of the nodes, in drawing order. */
  readonly nodes: readonly string[];
  /** Source files of its type in the script. Nodes of one type share them, so each lists them. */
  readonly script: number;
  /** Texts of its shaders in the program. */
  readonly shaders: number;
  /** Its operations in the program. */
  readonly operations: number;
  /** Files of its assets. Nodes that use one file each list it. */
  readonly assets: number;
}

/** Lists the nodes of a program with their bytes, largest first. `parts`: source file → its bytes in the script. */
export function nodeBytes(
  program: Program,
  parts: Readonly<Record<string, number>>,
  assets: readonly Pick<ReportedAsset, 'source' | 'fileBytes'>[],
): readonly ReportedNode[] {
  const made = new Map<string, Operation[]>();
  for (const operation of program.operations) {
    const key = nodesOf(operation).join('\n');
    made.set(key, [...(made.get(key) ?? []), operation]);
  }
  const reported = [...made.values()].map((operations) => ({
    nodes: operations[0] ? nodesOf(operations[0]) : [],
    script: sum(distinct(operations, typeOf).map((type) => typeBytes(parts, type))),
    shaders: sum(distinct(operations, shaderOf).map((shader) => shaderBytes(program, shader))),
    operations: sum(operations.map((operation) => JSON.stringify(operation).length)),
    assets: sum([...new Set(operations.flatMap(assetsOf))].map((id) => assetBytes(program, assets, id))),
  }));
  return reported.sort((a, b) => total(b) - total(a) || (a.nodes.join() < b.nodes.join() ? -1 : 1));
}

function nodesOf(operation: Operation): readonly string[] {
  if (operation.kind === 'pass') return operation.nodes ?? [operation.node];
  return 'effects' in operation && operation.effects ? [operation.node, ...operation.effects.nodes] : [operation.node];
}

function typeOf(operation: Operation): string | null {
  return 'type' in operation ? operation.type : null;
}

function shaderOf(operation: Operation): number | null {
  return operation.kind === 'pass' ? operation.shader : null;
}

function assetsOf(operation: Operation): string[] {
  if (operation.kind === 'pass') return operation.samplers.flatMap(({ source }) => (source.kind === 'import' ? source.assets : []));
  return 'assets' in operation ? Object.values(operation.assets).filter((id) => id !== null) : [];
}

function typeBytes(parts: Readonly<Record<string, number>>, type: string): number {
  return sum(Object.entries(parts).map(([file, bytes]) => (file.startsWith(`nodes/${type}/`) ? bytes : 0)));
}

function shaderBytes({ shaders }: Program, index: number): number {
  const shader = shaders[index];
  return shader ? shader.vertex.length + shader.fragment.length : 0;
}

function assetBytes({ assets }: Program, reported: readonly Pick<ReportedAsset, 'source' | 'fileBytes'>[], id: string): number {
  const path = assets.find((asset) => asset.id === id)?.path;
  return reported.find(({ source }) => source === path)?.fileBytes.after ?? 0;
}

function distinct<T extends string | number>(operations: readonly Operation[], of: (operation: Operation) => T | null): T[] {
  return [...new Set(operations.map(of))].filter((value) => value !== null);
}

function total({ script, shaders, operations, assets }: ReportedNode): number {
  return script + shaders + operations + assets;
}

function sum(numbers: readonly number[]): number {
  return numbers.reduce((all, n) => all + n, 0);
}
