import type { Program, ProgramAsset } from '../program/program.ts';

/** The parts of Scrim that a program needs. */
export interface ProgramUse {
  /** Node types whose runtimes are played, sorted. */
  readonly nodeTypes: readonly string[];
  /** Whether three.js is needed. */
  readonly scenes: boolean;
  /** Whether hit tests and anchors are needed. */
  readonly spatial: boolean;
  /** Whether pointers, taps or controllers are read. */
  readonly input: boolean;
  /** Whether it reads panoramas. */
  readonly panoramas: boolean;
  /** Whether techniques of the program show what is behind their objects. Models may contain glass without this. */
  readonly glass: boolean;
  /** Whether it has controls. */
  readonly controls: boolean;
  /** Whether it has labels, which are elements of the page. */
  readonly labels: boolean;
  /** Whether it takes panoramas of the room, which is a step of the page. */
  readonly takesPanorama: boolean;
  /** Whether it starts workers: those of filters or of other nodes. */
  readonly workers: boolean;
  /** Node types that have a worker and start it. */
  readonly workerTypes: ReadonlySet<string>;
  /** Ids of the assets that operations refer to. */
  readonly assets: ReadonlySet<string>;
}

export function programUse(program: Program): ProgramUse {
  const nodes = program.operations.filter((operation) => 'type' in operation);
  const passes = program.operations.filter((operation) => operation.kind === 'pass');
  const imported = passes.flatMap(({ samplers }) => samplers.flatMap(({ source }) => (source.kind === 'import' ? source.assets : [])));
  const assets = new Set([...nodes.flatMap((node) => Object.values(node.assets)), ...imported].filter((id) => id !== null));
  const uses = (...kinds: ProgramAsset['kind'][]) => program.assets.some(({ id, kind }) => kinds.includes(kind) && assets.has(id));
  const working = program.operations.filter(
    (operation) => operation.kind === 'cpu' || ('worker' in operation && operation.worker === true),
  );
  const spatial = program.needs.some(({ capability }) => capability === 'hit-test' || capability === 'anchors');
  const controls = (program.controls ?? []).length > 0;
  return {
    nodeTypes: [...new Set(nodes.map((node) => node.type))].sort(),
    scenes:
      program.operations.some(({ kind }) => kind === 'geometry' || kind === 'draw' || kind === 'shadow-maps') ||
      uses('model', 'environment'),
    spatial,
    input: spatial || controls || program.readsInput === true,
    panoramas: uses('environment'),
    glass: program.operations.some((operation) => 'glass' in operation && operation.glass === true),
    workers: working.length > 0,
    workerTypes: new Set(working.flatMap((operation) => ('type' in operation ? [operation.type] : []))),
    controls,
    takesPanorama: nodes.some(({ type }) => type === 'source/panorama-capture'),
    labels: nodes.some(({ type }) => type === 'objects/label'),
    assets,
  };
}
