import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import type { SeparateReason } from '../../export/compiler/schedule/fuse/separate-wire.ts';
import { type CompiledTwins, type Twins, twins, versionOf } from './fusion-kit.ts';

/** The reasons that only layers of objects have. `tests/compile/material-effects.test.ts` tests them. */
export const OBJECT_REASONS: readonly SeparateReason[] = ['background', 'objects', 'position', 'samples', 'textures', 'transparent'];

/** An effect over a scene: its type and its params. */
export type Effect = readonly [type: string, params?: Readonly<Record<string, unknown>>];

export interface FilteredScene {
  readonly effects: readonly Effect[];
  readonly antialias?: boolean;
  /** Whether an occlusion is between the scene and the effects; with its params. */
  readonly occlusion?: Readonly<Record<string, unknown>>;
  /** Params of the scene node. */
  readonly scene?: Readonly<Record<string, unknown>>;
  /** Further nodes, by id, and wires. */
  readonly nodes?: Readonly<Record<string, object>>;
  readonly wires?: readonly string[];
  /** The layer on the screen; that of the last effect by default. */
  readonly shown?: string;
  /** Shaders of the project. */
  readonly sources?: Readonly<Record<string, string>>;
  readonly options?: CompileOptions;
}

/** Objects that overlap each other, in colors of all tones, with a light that casts shadows. All of them are opaque. */
const OBJECTS: Readonly<Record<string, object>> = {
  'box-a': primitive('box', [0.9, 0.25, 0.1, 1]),
  'ball-a': primitive('sphere', [0.1, 0.5, 0.9, 1]),
  'ring-a': primitive('torus', [0.95, 0.9, 0.3, 1]),
  'floor-a': primitive('plane', [0.5, 0.55, 0.45, 1], [1.6, 1, 1.6]),
  'moved-a': moved([-0.35, 0.05, -1.1], [0.3, 0.5, 0]),
  'moved-b': moved([0.25, 0.1, -0.95], [0, 0, 0]),
  'moved-c': moved([0, 0.05, -0.8], [0.9, 0.4, 0]),
  'moved-d': moved([0, -0.25, -1.2], [0.15, 0.2, 0]),
  'sun-a': { type: 'light/directional', version: versionOf('light/directional') },
};

const OBJECT_WIRES = [
  'box-a.objects -> moved-a.objects',
  'ball-a.objects -> moved-b.objects',
  'ring-a.objects -> moved-c.objects',
  'floor-a.objects -> moved-d.objects',
  ...['a', 'b', 'c', 'd'].map((name) => `moved-${name}.objects -> scene-a.objects`),
  'sun-a.lights -> scene-a.lights',
];

function primitive(shape: string, color: readonly number[], sizeM: readonly number[] = [0.45, 0.45, 0.45]): object {
  return { type: 'objects/primitive', version: versionOf('objects/primitive'), params: { shape, color, sizeM } };
}

function moved(positionM: readonly number[], rotationRad: readonly number[]): object {
  return { type: 'objects/transform', version: versionOf('objects/transform'), params: { positionM, rotationRad } };
}

/** A scene with effects over it, on the screen over a color, with and without fusion. */
export function filteredScene({
  effects,
  antialias = false,
  occlusion,
  scene = {},
  nodes = {},
  wires = [],
  shown,
  sources = {},
  options = {},
}: FilteredScene): CompiledTwins {
  const drawn = occlusion === undefined ? 'scene-a' : 'hide-a';
  const isOwn = (type: string) => `${type.slice(type.indexOf('/') + 1)}.fs` in sources;
  const chain = effects.map(([type, params], i) => [`e-${i}`, { type, version: isOwn(type) ? 1 : versionOf(type), params }] as const);
  const path = [drawn, ...chain.map(([id]) => id)];
  return twins(
    {
      ...OBJECTS,
      'scene-a': { type: 'layer/scene', version: versionOf('layer/scene'), params: scene },
      ...(occlusion && {
        'depth-a': { type: 'world/depth', version: versionOf('world/depth'), params: { filter: 'nearest' } },
        'hide-a': { type: 'layer/depth-occlusion', version: versionOf('layer/depth-occlusion'), params: occlusion },
      }),
      ...Object.fromEntries(chain),
      'screen-a': {
        type: 'output/screen',
        version: versionOf('output/screen'),
        params: { antialias, background: 'color', color: [0.2, 0.45, 0.3, 1] },
      },
      ...nodes,
    },
    [
      ...OBJECT_WIRES,
      ...(occlusion ? ['scene-a.layer -> hide-a.layer', 'depth-a.depth -> hide-a.depth'] : []),
      ...path.slice(1).map((to, i) => `${path[i]}.layer -> ${to}.inputImage`),
      `${shown ?? `${path.at(-1)}.layer`} -> screen-a.layer`,
      ...wires,
    ],
    sources,
    options,
  );
}

/** Whether the materials of the scene compute the effects: there is no pass and no target. */
export function isInMaterials({ fused }: Pick<Twins, 'fused'>): boolean {
  return fused.operations.some((operation) => 'effects' in operation) && fused.presentation.mode === 'forward';
}
