import type { Program, ProgramAsset } from '../program/program.ts';

/** What of Scrim a program needs beside it. */
export interface ProgramUse {
  /** Node types whose behavior is played, sorted. */
  readonly nodeTypes: readonly string[];
  /** Whether three.js is needed. */
  readonly scenes: boolean;
  /** Whether panoramas are read. */
  readonly panoramas: boolean;
  /** Whether visitors can set something. */
  readonly controls: boolean;
  /** Whether filters work in workers of their own. */
  readonly workers: boolean;
  /** Ids of the assets that some operation names. */
  readonly assets: ReadonlySet<string>;
}

export function programUse(program: Program): ProgramUse {
  const nodes = program.operations.filter((operation) => 'type' in operation);
  const passes = program.operations.filter((operation) => operation.kind === 'pass');
  const imported = passes.flatMap(({ samplers }) => samplers.flatMap(({ source }) => (source.kind === 'import' ? source.assets : [])));
  const assets = new Set([...nodes.flatMap((node) => Object.values(node.assets)), ...imported].filter((id) => id !== null));
  const uses = (...kinds: ProgramAsset['kind'][]) => program.assets.some(({ id, kind }) => kinds.includes(kind) && assets.has(id));
  return {
    nodeTypes: [...new Set(nodes.map((node) => node.type))].sort(),
    scenes:
      program.operations.some(({ kind }) => kind === 'geometry' || kind === 'draw' || kind === 'shadow-maps') ||
      uses('model', 'environment'),
    panoramas: uses('environment'),
    workers: program.operations.some(({ kind }) => kind === 'cpu'),
    controls: (program.controls ?? []).length > 0,
    assets,
  };
}
