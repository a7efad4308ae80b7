import { Matrix4, MeshStandardMaterial } from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import type { SessionInput } from '../../kit/session.ts';
import { setMaterialColor } from '../../kit/three/material-color.ts';
import { setShadows } from '../../kit/three/mesh-item.ts';
import { createControllerModel } from './controller-model.ts';
import type { definition } from './definition.ts';
import { createHandModel } from './hand-model.ts';

/** The model of one hand or controller, which is in the output list while it is tracked. */
interface Part {
  readonly item: ObjectItem;
  isListed: boolean;
  /** Moves the model with the hand or controller; returns false while that is not tracked. */
  follow(input: SessionInput): boolean;
  dispose(): void;
}

const SIDES = ['left', 'right'] as const;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { color, roughness } = ctx.params;
  const { show, side } = ctx.config;
  const { objects } = ctx.outputs;
  const material = new MeshStandardMaterial();
  const sides = SIDES.filter((each) => side === 'both' || side === each);
  const parts = [
    ...(show === 'controllers' ? [] : sides.map((each) => createHandPart(each, material))),
    ...(show === 'hands' ? [] : sides.map((each) => createControllerPart(each, material))),
  ];

  function list(): void {
    objects.items.length = 0;
    for (const { item, isListed } of parts) if (isListed) objects.items.push(item);
    objects.version++;
  }

  return {
    update: ({ input }) => {
      setMaterialColor(material, color.value);
      material.roughness = roughness.value;
      let isChanged = false;
      for (let i = 0; i < parts.length; i++) {
        const part = parts[i];
        if (!part) continue;
        const isTracked = part.follow(input);
        if (isTracked !== part.isListed) isChanged = true;
        part.isListed = isTracked;
        setShadows(part.item, ctx.params);
      }
      if (isChanged) list();
    },
    dispose: () => {
      for (const part of parts) part.dispose();
      material.dispose();
    },
  };
}

function createHandPart(side: 'left' | 'right', material: MeshStandardMaterial): Part {
  const model = createHandModel(side === 'left', material);
  const item = createItem(`${side}-hand`, model.root);
  return {
    item,
    isListed: false,
    follow: ({ leftHand, rightHand }) => {
      const hand = side === 'left' ? leftHand : rightHand;
      if (hand.tracked) model.follow(hand, item.worldFromObject);
      return hand.tracked;
    },
    dispose: model.dispose,
  };
}

function createControllerPart(side: 'left' | 'right', material: MeshStandardMaterial): Part {
  const model = createControllerModel(side === 'left', material);
  const item = createItem(`${side}-controller`, model.root);
  return {
    item,
    isListed: false,
    follow: (input) => {
      const { worldFromGrip, bare } = input[side];
      if (!worldFromGrip || bare) return false;
      item.worldFromObject.fromArray(worldFromGrip);
      return true;
    },
    dispose: model.dispose,
  };
}

function createItem(key: string, root: ObjectItem['root']): ObjectItem {
  return { key, root, worldFromObject: new Matrix4(), role: 'virtual', castsShadow: true, receivesShadow: true };
}
