import type { Program, ProgramAsset } from '../program/program.ts';

/** The parts of Scrim that a program needs. */
export interface ProgramUse {
  /** Node types whose runtimes are played, sorted. */
  readonly nodeTypes: readonly string[];
  /** Whether three.js is needed. */
  readonly scenes: boolean;
  /** Whether it reads panoramas. */
  readonly panoramas: boolean;
  /** Whether it has controls. */
  readonly controls: boolean;
  /** Whether it has filters in workers. */
  readonly workers: boolean;
  /** Ids of the assets that operations refer to. */
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
