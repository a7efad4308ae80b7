import type { Capability } from '../../nodes/kit/definition.ts';
import type { TableType } from '../../nodes/kit/wire-types.ts';
import { mayRest } from '../program/may-rest.ts';
import type { Tier } from '../program/needs.ts';
import type {
  BuiltinUniform,
  NodeOperation,
  Operation,
  PassSampler,
  Program,
  ProgramAsset,
  Resource,
  SizeExpression,
  SlotType,
  TargetSize,
} from '../program/program.ts';
import { drawsScenes, readsView } from '../program/reads-view.ts';

type TargetFormat = Extract<Resource, { kind: 'target' }>['format'];

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
  /**
   * Which edges techniques of the program draw as lines: all, or those of meshes with a border, which only models may have, or none.
   */
  readonly techniqueEdges: 'all' | 'of open models' | 'none';
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
  readonly targetFormats: ReadonlySet<TargetFormat>;
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
  /** Kinds of what passes read as textures. */
  readonly samplerKinds: ReadonlySet<PassSampler['source']['kind']>;
  /** Uniforms of ISF that passes read. */
  readonly builtins: ReadonlySet<BuiltinUniform>;
  readonly slotTypes: ReadonlySet<SlotType>;
  /** Words of its expressions and of the sizes of its targets. */
  readonly words: ReadonlySet<string>;
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
    techniqueEdges: edgesOf(program),
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
    targetFormats: new Set(program.resources.flatMap((resource) => (resource.kind === 'target' ? [resource.format] : []))),
    computedSizes: program.resources.some((resource) => resource.kind === 'target' && isComputed(resource.size)),
    tableTypes: new Set(program.resources.flatMap((resource) => (resource.kind === 'table' ? [resource.of] : []))),
    assetKinds: new Set(program.assets.filter(({ id }) => assets.has(id)).map(({ kind }) => kind)),
    depthMeshes: program.assets.some(({ depthMeshes }) => depthMeshes),
    vertexWeights: nodes.some(({ type, config }) => type === 'source/capture' && Number(config.updateFrames) > 0),
    samplerKinds: new Set(passes.flatMap(({ samplers }) => samplers.map(({ source }) => source.kind))),
    builtins: new Set(passes.flatMap(({ uniforms }) => uniforms.flatMap(({ source }) => ('builtin' in source ? [source.builtin] : [])))),
    slotTypes: new Set(program.slots.slots.map(({ type }) => type)),
    words: wordsOf(program, nodes),
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

/** Node types that make objects, of which those of `source/model` have the borders that their file has. */
const CLOSED_TYPES: ReadonlySet<string> = new Set(['objects/primitive', 'source/model']);

function edgesOf(program: Program): ProgramUse['techniqueEdges'] {
  const drawn = program.resources.filter(
    (resource) => resource.kind === 'technique' && resource.passes.some(({ side }) => side === 'edges'),
  );
  const passes = drawn.flatMap((resource) => (resource.kind === 'technique' ? resource.passes : []));
  if (drawn.length === 0) return 'none';
  if (passes.some(({ side, open }) => side === 'edges' && open !== true)) return 'all';
  const isClosed = (node: NodeOperation): boolean => CLOSED_TYPES.has(node.type) && node.config.shape !== 'plane';
  return makersOf(program, new Set(drawn.map(({ id }) => id))).every(isClosed) ? 'of open models' : 'all';
}

/** The nodes that make the objects to which techniques are applied. */
function makersOf({ resources, operations }: Program, techniques: ReadonlySet<string>): readonly NodeOperation[] {
  const objects = new Set(resources.flatMap(({ id, kind }) => (kind === 'objects' ? [id] : [])));
  const nodes = operations.filter((operation) => 'type' in operation);
  const open = nodes.filter(({ reads }) => reads.some((id) => techniques.has(id)));
  const seen = new Set(open);
  const makers: NodeOperation[] = [];
  for (let node = open.pop(); node; node = open.pop()) {
    const read = node.reads.filter((id) => objects.has(id));
    if (read.length === 0) makers.push(node);
    for (const writer of nodes.filter(({ writes }) => writes.some((id) => read.includes(id)))) {
      if (!seen.has(writer)) open.push(writer);
      seen.add(writer);
    }
  }
  return makers;
}

/** Params of nodes that contain an expression in postfix notation. A test compares them with the runtimes. */
export const EXPRESSION_PARAMS = ['postfix', 'expression'];

function wordsOf({ resources }: Program, nodes: ProgramUse['nodes']): ReadonlySet<string> {
  const texts = nodes.flatMap(({ config }) => EXPRESSION_PARAMS.map((param) => String(config[param] ?? '')));
  const sizes = resources.flatMap((resource) => (resource.kind === 'target' ? [resource.size.width, resource.size.height] : []));
  const operations = sizes.flat().map((token) => (typeof token === 'object' && 'op' in token ? token.op : ''));
  return new Set([...texts.flatMap((text) => text.split(' ')), ...operations]);
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
