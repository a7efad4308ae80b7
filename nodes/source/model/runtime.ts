import { Matrix4, type Object3D } from 'three';
import type { ModelAsset } from '../../kit/assets.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import { setShadows } from '../../kit/three/mesh-item.ts';
import { type Animation, createAnimation } from './animation.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { speed, playing } = ctx.params;
  const { objects } = ctx.outputs;
  const id = ctx.assetIds.model;
  const handle = id === null ? null : ctx.assets.model(id);
  let item: ObjectItem | null = null;
  let animation: Animation | null = null;

  function begin(model: ModelAsset): ObjectItem {
    const root = model.instantiate(ctx.config.normals);
    root.updateMatrixWorld(true);
    animation = findAnimation(ctx, model, root);
    const made: ObjectItem = {
      key: 'model',
      root,
      worldFromObject: new Matrix4(),
      role: 'virtual',
      castsShadow: true,
      receivesShadow: true,
    };
    objects.items.push(made);
    objects.version++;
    return made;
  }

  return {
    get version() {
      return objects.version + (animation?.poses ?? 0);
    },
    update: () => {
      const model = handle?.value ?? null;
      if (model === null) return;
      item ??= begin(model);
      setShadows(item, ctx.params);
      animation?.update(speed.value, playing.value);
    },
    reset: () => animation?.reset(),
    dispose: () => {
      animation?.dispose();
      item?.root.traverse(disposeBones);
      handle?.release();
    },
  };
}

function findAnimation(ctx: NodeContext<typeof definition>, model: ModelAsset, root: Object3D): Animation | null {
  const { clip: name } = ctx.config;
  if (name === 'none') return null;
  const clip = name === '' ? model.clips[0] : model.clips.find((c) => c.name === name);
  if (clip) return createAnimation(root, clip, ctx.clock);
  if (name !== '') {
    const names = model.clips.map((c) => `"${c.name}"`).join(', ');
    ctx.report({
      code: 'SCR018',
      severity: 'warning',
      port: 'clip',
      message: `The model has no animation “${name}”.`,
      fix: names === '' ? 'Clear “Animation”: the model has no animations.' : `Choose one of ${names}.`,
    });
  }
  return null;
}

/** Disposes the skeletons of an instance. Each instance has its own, because three.js stores the bones in a texture of the skeleton. */
function disposeBones(object: Object3D): void {
  if ('skeleton' in object) (object as { skeleton: { dispose(): void } }).skeleton.dispose();
}
