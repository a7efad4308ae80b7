import type { Object3D } from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { objects, hiders } = ctx.inputs;
  const names = namesIn(ctx.config.names);
  const lists = [...objects, ...hiders];
  const isMasked = (item: ObjectItem): boolean => objects.some((list) => list.items.includes(item));
  const scene = ctx.scenes.createScene({
    kind: 'mask',
    shows: (item, part) => isMasked(item) && (names.size === 0 || isNamed(part, names)),
  });
  return {
    version: 0,
    update: () => scene.update(lists, NO_LIGHTS),
    draw: scene.draw,
    dispose: scene.dispose,
  };
}

const NO_LIGHTS: readonly never[] = [];

function isNamed(part: Object3D, names: ReadonlySet<string>): boolean {
  for (let at: Object3D | null = part; at !== null; at = at.parent) if (names.has(at.name)) return true;
  return false;
}

function namesIn(text: string): ReadonlySet<string> {
  const names = text.split(',').map((name) => name.trim());
  return new Set(names.filter((name) => name !== ''));
}
