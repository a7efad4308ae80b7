import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import type { PortAddress, Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import {
  defineNode,
  type InputPort,
  type NodeDefinition,
  type NodeLibrary,
  type OutputPort,
  type ParamValue,
} from '../../../nodes/kit/definition.ts';
import type { Place } from '../editor/canvas-state.ts';

/** Several connected nodes that are added as one entry of the palette. After that they are ordinary nodes. */
export interface Recipe {
  /** Palette entry. Its type is `combination/NAME`; its ports are the keys of `ports`. */
  readonly definition: NodeDefinition;
  /** Nodes of the recipe by name. Names are valid only inside the recipe. The first node is placed at the chosen position and selected. */
  readonly nodes: Readonly<Record<string, RecipeNode>>;
  readonly wires: readonly (readonly [from: string, to: string])[];
  /** Ports of the palette entry: for each, the port `node.port` inside the recipe. */
  readonly ports: Readonly<Record<string, string>>;
  /** Input `node.port` that takes all lights of the graph, or a new one. */
  readonly lit?: string;
  /** Whether the objects that it gives already have their place in the room. */
  readonly isPlaced?: true;
}

interface RecipeNode extends Place {
  readonly type: string;
  readonly params?: Readonly<Record<string, ParamValue>>;
}

interface RecipeData extends Omit<Recipe, 'definition' | 'ports'> {
  readonly name: string;
  readonly title: string;
  readonly doc: string;
  readonly keywords: readonly string[];
  readonly inputs: Readonly<Record<string, string>>;
  readonly outputs: Readonly<Record<string, string>>;
}

const COLUMN_PX = 240;
const ROW_PX = 120;

const FLOOR = {
  plane: { type: 'objects/primitive', params: { shape: 'plane', sizeM: [5, 0, 5] } },
  floor: { type: 'objects/phantom' },
} as const;

const RECIPES: readonly RecipeData[] = [
  {
    name: 'real-floor',
    title: 'Real floor',
    doc: 'A phantom of 5 × 5 m on the real floor, which receives shadows. Adds a Primitive and a Phantom.',
    keywords: ['ground', 'plane', 'shadow catcher', 'phantom'],
    nodes: { floor: { ...FLOOR.floor, x: 0, y: 0 }, plane: { ...FLOOR.plane, x: -COLUMN_PX, y: 0 } },
    wires: [['plane.objects', 'floor.objects']],
    isPlaced: true,
    inputs: {},
    outputs: { objects: 'floor.objects' },
  },
  {
    name: 'shadow-on-floor',
    title: 'Shadow on the real floor',
    doc: 'A layer with the shadow of objects on the real floor, to composite over the camera feed. Real objects in front of the shadow hide it. Adds a Shadow layer, a Phantom of the floor, a Depth occlusion and, if the graph has no light, a Directional light.',
    keywords: ['shadow catcher', 'ground', 'contact'],
    nodes: {
      shadow: { type: 'layer/shadow', x: 0, y: 0 },
      // Depth sensors have an error of a few centimeters, and the shadow lies at the same depth as the real floor.
      clip: { type: 'layer/depth-occlusion', params: { biasM: 0.06, softnessM: 0.04 }, x: COLUMN_PX, y: 0 },
      floor: { ...FLOOR.floor, x: -COLUMN_PX, y: ROW_PX },
      plane: { ...FLOOR.plane, x: -2 * COLUMN_PX, y: ROW_PX },
    },
    wires: [
      ['plane.objects', 'floor.objects'],
      ['floor.objects', 'shadow.receivers'],
      ['shadow.layer', 'clip.layer'],
    ],
    inputs: { casters: 'shadow.casters', lights: 'shadow.lights' },
    lit: 'shadow.lights',
    outputs: { layer: 'clip.layer' },
  },
  {
    name: 'soft-occlusion',
    title: 'Soft occlusion where depth is uncertain',
    doc: 'Hides what is behind real objects, and blurs the result where the room depth is uncertain: at borders, in noise and in filled holes. Adds a Depth occlusion, a Gaussian blur, a Matte and a Room depth, whose confidence is the mask.',
    keywords: ['confidence', 'uncertainty', 'feather', 'soft edge'],
    nodes: {
      choose: { type: 'operator/choose-by-mask', x: 0, y: 0 },
      blur: { type: 'filter/gaussian-blur', params: { radius: 6 }, x: -COLUMN_PX, y: ROW_PX },
      hide: { type: 'layer/depth-occlusion', x: -2 * COLUMN_PX, y: 0 },
      depth: { type: 'world/depth', x: -3 * COLUMN_PX, y: ROW_PX },
    },
    wires: [
      ['depth.depth', 'hide.depth'],
      ['hide.layer', 'choose.inside'],
      ['hide.layer', 'blur.inputImage'],
      ['blur.layer', 'choose.outside'],
      ['depth.confidence', 'choose.mask'],
    ],
    inputs: { layer: 'hide.layer' },
    outputs: { result: 'choose.layer' },
  },
  attached({
    to: 'hand',
    doc: 'Puts objects on the palm of a bare hand. Adds a Hand',
    keywords: ['palm', 'finger', 'wrist', 'hold'],
    source: { type: 'input/hand', port: 'palm' },
    lagS: 0.05,
    offsetM: [0, 0.05, 0],
  }),
  attached({
    to: 'controller',
    doc: 'Puts objects on a controller of a headset. Adds a Controller',
    keywords: ['gamepad', 'grip', 'hold', 'tool'],
    source: { type: 'input/gamepad', port: 'grip' },
    lagS: 0.05,
    offsetM: [0, 0.05, -0.1],
  }),
  attached({
    to: 'head',
    doc: 'Keeps objects 1 m in front of the visitor. Adds a Head pose',
    keywords: ['camera', 'viewer', 'hud', 'screen', 'gaze', 'lazy'],
    source: { type: 'input/head', port: 'pose' },
    lagS: 0.3,
    offsetM: [0, 0, -1],
  }),
  {
    name: 'billboard',
    title: 'Billboard',
    doc: 'Puts objects at a pose and turns their front to the visitor, upright. Adds a Place at pose, a Look at and a Head pose.',
    keywords: ['face', 'sprite', 'towards', 'camera'],
    nodes: {
      place: { type: 'objects/at-pose', x: 0, y: 0 },
      turn: { type: 'pose/look-at', params: { upright: true }, x: -COLUMN_PX, y: ROW_PX },
      head: { type: 'input/head', x: -2 * COLUMN_PX, y: 2 * ROW_PX },
    },
    wires: [
      ['head.pose', 'turn.target'],
      ['turn.pose', 'place.pose'],
    ],
    isPlaced: true,
    inputs: { objects: 'place.objects', pose: 'turn.pose' },
    outputs: { objects: 'place.objects' },
  },
];

interface AttachedData {
  readonly to: 'hand' | 'controller' | 'head';
  /** The text of the entry, up to the first of the added nodes. */
  readonly doc: string;
  readonly keywords: readonly string[];
  /** The node and port that give the pose. */
  readonly source: { readonly type: string; readonly port: string };
  readonly lagS: number;
  readonly offsetM: readonly [number, number, number];
}

/** Objects at an offset from a pose of the visitor, which they follow with a lag. */
function attached({ to, doc, keywords, source, lagS, offsetM }: AttachedData): RecipeData {
  return {
    name: `attach-to-${to}`,
    title: `Attach to ${to}`,
    doc: `${doc}, a Follow, whose time constant is the lag, an Offset pose and a Place at pose.`,
    keywords: ['follow', 'lag', 'parent', ...keywords],
    nodes: {
      place: { type: 'objects/at-pose', x: 0, y: 0 },
      offset: { type: 'pose/offset', params: { offsetM }, x: -COLUMN_PX, y: ROW_PX },
      follow: { type: 'pose/follow', params: { timeConstantS: lagS }, x: -2 * COLUMN_PX, y: ROW_PX },
      [to]: { type: source.type, x: -3 * COLUMN_PX, y: ROW_PX },
    },
    wires: [
      [`${to}.${source.port}`, 'follow.pose'],
      ['follow.pose', 'offset.pose'],
      ['offset.pose', 'place.pose'],
    ],
    isPlaced: true,
    inputs: { objects: 'place.objects' },
    outputs: { objects: 'place.objects' },
  };
}

/** The recipes whose node types exist in the library, and one per technique that applies it to objects. */
export function recipesOf(library: NodeLibrary): readonly Recipe[] {
  const techniques = [...library.types()].flatMap((type) => {
    const definition = library.definition(type);
    return definition?.lowering.kind === 'technique' ? [appliedTechnique(definition)] : [];
  });
  return [...RECIPES, ...techniques].flatMap((recipe) => toRecipe(library, recipe) ?? []);
}

function appliedTechnique({ type, title, doc, keywords = [] }: NodeDefinition): RecipeData {
  return {
    name: `on-objects-${type.replaceAll('/', '-')}`,
    title: `${title} on objects`,
    doc: `${doc} Adds a Set material node, too, which applies it to objects.`,
    keywords,
    nodes: { apply: { type: 'objects/apply-technique', x: 0, y: 0 }, technique: { type, x: -COLUMN_PX, y: ROW_PX } },
    wires: [['technique.technique', 'apply.technique']],
    inputs: { objects: 'apply.objects' },
    outputs: { objects: 'apply.objects' },
  };
}

function toRecipe(library: NodeLibrary, data: RecipeData): Recipe | null {
  const { name, title, doc, keywords, nodes, wires, inputs, outputs, lit, isPlaced } = data;
  if (Object.values(nodes).some(({ type }) => library.definition(type) === undefined)) return null;
  const definitionOf = (address: string) => {
    const { node, port } = parse(address);
    return { definition: library.definition(getOwn(nodes, node)?.type ?? ''), port };
  };
  const taken: Record<string, InputPort> = {};
  for (const [port, address] of Object.entries(inputs)) {
    const inner = definitionOf(address);
    const found = inner.definition?.inputs[inner.port];
    if (found) taken[port] = found;
  }
  const given: Record<string, OutputPort> = {};
  for (const [port, address] of Object.entries(outputs)) {
    const inner = definitionOf(address);
    const found = inner.definition?.outputs[inner.port];
    if (found) given[port] = found;
  }
  const definition = defineNode({
    type: `combination/${name}`,
    version: 1,
    title,
    doc,
    keywords,
    inputs: taken,
    outputs: given,
    params: {},
    lowering: { kind: 'behavior' },
  });
  return { definition, nodes, wires, ports: { ...inputs, ...outputs }, ...(lit !== undefined && { lit }), ...(isPlaced && { isPlaced }) };
}

export interface AddedRecipe {
  /** The first node of the recipe. */
  readonly main: string;
  readonly ids: readonly string[];
  /** The port of an added node, by port of the recipe. */
  readonly portOf: (port: string) => PortAddress | null;
  readonly change: (project: Project) => Change;
  /** Connects the lights of the graph, or a new one, if nothing lights the recipe yet. Comes after the wires of the person. */
  readonly light: (project: Project) => Change;
}

interface AddRecipe extends Place {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly random: () => number;
  readonly project: Project;
}

export function addRecipe(recipe: Recipe, context: AddRecipe): AddedRecipe {
  const { library, graph, random, project, x, y } = context;
  const ids = new Map(Object.entries(recipe.nodes).map(([name, { type }]) => [name, makeNodeId(project, type, random)]));
  const idOf = (name: string) => ids.get(name) ?? name;
  const place = (address: string): PortAddress => {
    const { node, port } = parse(address);
    return { node: idOf(node), port };
  };
  const adds = Object.entries(recipe.nodes).map(
    ([name, node]) =>
      (before: Project): Change =>
        addNode(before, {
          library,
          graph,
          id: idOf(name),
          type: node.type,
          x: x + node.x,
          y: y + node.y,
          ...(node.params && { params: node.params }),
        }),
  );
  const wires = recipe.wires.map(
    ([from, to]) =>
      (before: Project): Change =>
        connect(before, { library, graph, from: place(from), to: place(to) }),
  );
  return {
    main: [...ids.values()][0] ?? '',
    ids: [...ids.values()],
    portOf: (port) => {
      const address = getOwn(recipe.ports, port);
      return address === undefined ? null : place(address);
    },
    change: (before) => sequence(before, ...adds, ...wires),
    light: (before) => (recipe.lit === undefined ? unchanged(before) : bringLight(before, place(recipe.lit), context)),
  };
}

/** All outputs with lights in a graph. */
export function lightsOf(project: Project, library: NodeLibrary, graph: string): PortAddress[] {
  return Object.entries(project.graphs[graph]?.nodes ?? {}).flatMap(([node, { type }]) =>
    Object.entries(library.definition(type)?.outputs ?? {}).flatMap(([port, output]) => (output.type === 'lights' ? [{ node, port }] : [])),
  );
}

function bringLight(project: Project, to: PortAddress, { library, graph, random, x, y }: AddRecipe): Change {
  const { wires = [] } = project.graphs[graph] ?? {};
  if (wires.some((wire) => wire.to.node === to.node && wire.to.port === to.port)) return unchanged(project);
  const lights = lightsOf(project, library, graph);
  const type = 'light/directional';
  const id = makeNodeId(project, type, random);
  const from = lights.length > 0 ? lights : [{ node: id, port: 'lights' }];
  return sequence(
    project,
    (before) =>
      lights.length > 0 ? unchanged(before) : addNode(before, { library, graph, id, type, x: x - COLUMN_PX, y: y + 2 * ROW_PX }),
    ...from.map((light) => (before: Project) => connect(before, { library, graph, from: light, to })),
  );
}

function parse(address: string): PortAddress {
  const [node = '', port = ''] = address.split('.');
  return { node, port };
}
