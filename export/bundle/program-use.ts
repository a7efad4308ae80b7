import type { Capability } from '../../nodes/kit/definition.ts';
import type { TableType } from '../../nodes/kit/wire-types.ts';
import { mayRest } from '../program/may-rest.ts';
import type { Tier } from '../program/needs.ts';
import type { NodeOperation, Operation, Program, ProgramAsset, Resource, SizeExpression, TargetSize } from '../program/program.ts';
import { drawsScenes, readsView } from '../program/reads-view.ts';

/** The parts of Scrim that a program needs. */
export interface ProgramUse {
  /** The nodes that are played. */
  readonly nodes: readonly Pick<NodeOperation, 'type' | 'config' | 'inputs' | 'outputs'>[];
  /** Their types, sorted. */
  readonly nodeTypes: readonly string[];
  /** Whether three.js is needed. */
  readonly scenes: boolean;
  /** Whether hit tests and anchors are needed. */
  readonly spatial: boolean;
  /** Whether pointers, taps or controllers are read. */
  readonly input: boolean;
  /**
   * Whether its image depends on the pose or the projection of the view. Where it does not, as where effects filter an image or the camera
   * video, looking around changes nothing.
   */
  readonly readsView: boolean;
  /** Whether it reads panoramas. */
  readonly panoramas: boolean;
  /** Whether techniques of the program show what is behind their objects. Models may contain glass without this. */
  readonly glass: boolean;
  /** Whether materials compute effects. */
  readonly materialEffects: boolean;
  /** Whether techniques of the program draw edges as lines. */
  readonly techniqueEdges: boolean;
  /** Whether a technique reads the direction field of meshes. */
  readonly techniqueDirections: boolean;
  /** Whether a technique reads the radial curvature of meshes. */
  readonly techniqueRadial: boolean;
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
  readonly operationKinds: ReadonlySet<Operation['kind']>;
  readonly resourceKinds: ReadonlySet<Resource['kind']>;
  /** Whether the size of a target is another than that of what it is relative to. */
  readonly computedSizes: boolean;
  /** Types of the params that its shaders read from textures. */
  readonly tableTypes: ReadonlySet<TableType>;
  /** Kinds of the assets that operations refer to. */
  readonly assetKinds: ReadonlySet<ProgramAsset['kind']>;
  /** Whether it draws depth meshes of captures. */
  readonly depthMeshes: boolean;
  /** Whether it draws captures with weights per vertex. */
  readonly vertexWeights: boolean;
  /** Whether its shaders import images. */
  readonly importsImages: boolean;
  /** Whether a pass is drawn once per frame, whatever the number of views. */
  readonly passesOnce: boolean;
  /** Whether frames may repeat the last image: nothing draws objects, and no layer comes from the camera. */
  readonly mayRest: boolean;
  /** Whether frames with objects, or with images that the CPU computes, may repeat the last image. */
  readonly objectsMayRest: boolean;
  /** Whether nodes send or receive pulses. */
  readonly pulses: boolean;
  /** Whether nodes receive poses. */
  readonly poses: boolean;
  /** What its nodes ask of a session. */
  readonly capabilities: ReadonlySet<Capability>;
  readonly tiers: ReadonlySet<Tier['id']>;
  /** Ids of the assets that operations refer to. */
  readonly assets: ReadonlySet<string>;
}

export function programUse(program: Program): ProgramUse {
  const nodes = program.operations.filter((operation) => 'type' in operation);
  const passes = program.operations.filter((operation) => operation.kind === 'pass');
  const imported = passes.flatMap(({ samplers }) => samplers.flatMap(({ source }) => (source.kind === 'import' ? source.assets : [])));
  const assets = new Set([...nodes.flatMap((node) => Object.values(node.assets)), ...imported].filter((id) => id !== null));
  const resourceKinds = new Set(program.resources.map(({ kind }) => kind));
  const uses = (...kinds: ProgramAsset['kind'][]) => program.assets.some(({ id, kind }) => kinds.includes(kind) && assets.has(id));
  const working = program.operations.filter(
    (operation) => operation.kind === 'cpu' || ('worker' in operation && operation.worker === true),
  );
  const capabilities = new Set(program.needs.map(({ capability }) => capability));
  const spatial = capabilities.has('hit-test') || capabilities.has('anchors');
  const controls = (program.controls ?? []).length > 0;
  // The panel with controls in the room reads pointers; those on the page are elements.
  const input = spatial || (controls && program.tiers.some(({ id }) => id !== 'orbit')) || program.readsInput === true;
  const scenes = drawsScenes(program);
  const takesPanorama = nodes.some(({ type }) => type === 'source/panorama-capture');
  const poses = nodes.some((node) => node.poses !== undefined);
  return {
    nodes,
    nodeTypes: [...new Set(nodes.map((node) => node.type))].sort(),
    scenes,
    spatial,
    input,
    readsView: readsView(program),
    panoramas: uses('environment'),
    glass: program.operations.some((operation) => 'glass' in operation && operation.glass === true),
    materialEffects: program.operations.some((operation) => 'effects' in operation && operation.effects !== undefined),
    techniqueEdges: program.resources.some(
      (resource) => resource.kind === 'technique' && resource.passes.some(({ side }) => side === 'edges'),
    ),
    techniqueRadial: program.resources.some((resource) => resource.kind === 'technique' && resource.fragment.includes(RADIAL)),
    techniqueDirections: program.resources.some(
      (resource) => resource.kind === 'technique' && DIRECTIONS.some((field) => resource.fragment.includes(field)),
    ),
    workers: working.length > 0,
    workerTypes: new Set(working.flatMap((operation) => ('type' in operation ? [operation.type] : []))),
    controls,
    takesPanorama,
    labels: nodes.some(({ type }) => type === 'objects/label'),
    operationKinds: new Set(program.operations.map(({ kind }) => kind)),
    resourceKinds,
    computedSizes: program.resources.some((resource) => resource.kind === 'target' && isComputed(resource.size)),
    tableTypes: new Set(program.resources.flatMap((resource) => (resource.kind === 'table' ? [resource.of] : []))),
    assetKinds: new Set(program.assets.filter(({ id }) => assets.has(id)).map(({ kind }) => kind)),
    depthMeshes: program.assets.some(({ depthMeshes }) => depthMeshes),
    vertexWeights: nodes.some(({ type, config }) => type === 'source/capture' && Number(config.updateFrames) > 0),
    importsImages: imported.length > 0,
    passesOnce: passes.some(({ view }) => view === 'once'),
    mayRest: !program.operations.some(({ kind }) => RESTLESS.has(kind)) && !program.resources.some(isCamera),
    objectsMayRest:
      program.operations.some(({ kind }) => kind === 'draw' || (RESTLESS.has(kind) && !program.resources.some(isCamera))) &&
      mayRest(program),
    pulses: resourceKinds.has('pulses') || nodes.some(({ pulses }) => pulses !== undefined),
    poses,
    capabilities,
    tiers: new Set(program.tiers.map(({ id }) => id)),
    assets,
  };
}

/** As in `export/runtime/scenes/materials/curvature/direction-parts.ts`. A test compares them. */
export const DIRECTIONS: readonly string[] = ['.along', '.smoothNormal'];

/** As in `export/runtime/scenes/materials/curvature/radial-parts.ts`. */
export const RADIAL = '.radial';

const RESTLESS: ReadonlySet<Operation['kind']> = new Set(['draw', 'cpu', 'shadow-maps', 'readback']);

/** Layers of the view domain that no pass draws come from the camera. */
function isCamera(resource: Resource): boolean {
  return resource.kind === 'external' && resource.domain === 'view';
}

function isComputed({ width, height }: TargetSize): boolean {
  return !isDimension(width, 'width') || !isDimension(height, 'height');
}

function isDimension([token, ...rest]: SizeExpression, op: 'width' | 'height'): boolean {
  return rest.length === 0 && typeof token === 'object' && 'op' in token && token.op === op;
}
