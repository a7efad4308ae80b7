import { describe, expect, test } from '@jest/globals';
import {
  AnimationClip,
  Bone,
  BoxGeometry,
  Group,
  Mesh,
  NumberKeyframeTrack,
  type Object3D,
  Skeleton,
  SkinnedMesh,
  VectorKeyframeTrack,
} from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetService, ModelAsset } from '../../kit/assets.ts';
import type { ParamValue } from '../../kit/definition.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** Two clips of 2 s: `rise` moves the part from 0 to 2 m, `slide` to the side. */
function model(): ModelAsset {
  return {
    instantiate: () => {
      const root = new Group();
      const part = new Mesh(new BoxGeometry());
      part.name = 'part';
      return root.add(part);
    },
    clips: [
      new AnimationClip('rise', 2, [new VectorKeyframeTrack('part.position', [0, 2], [0, 0, 0, 0, 2, 0])]),
      new AnimationClip('slide', 2, [new NumberKeyframeTrack('part.position[x]', [0, 2], [0, 2])]),
    ],
  };
}

interface LateModel {
  value: ModelAsset | null;
  released: number;
}

function make(params: Record<string, ParamValue>, asset: LateModel = { value: model(), released: 0 }) {
  const handle = {
    kind: 'model' as const,
    get value() {
      return asset.value;
    },
    settled: Promise.resolve(),
    release: () => {
      asset.released++;
    },
  };
  const assets = { model: () => handle } as Partial<AssetService> as AssetService;
  const fake = fakeContext(definition, { params: { model: 'a', ...params }, services: { assets } });
  const node = create(fake.ctx);
  const { items } = fake.ctx.outputs.objects;
  const position = (): number[] => {
    const part = items[0]?.root.getObjectByName('part');
    return part ? [part.matrixWorld.elements[12], part.matrixWorld.elements[13]] : [];
  };
  /** Goes on by so many seconds, draws a frame and tells where the part stands in the world. */
  const play = (deltaS: number): number[] => {
    fake.tick(deltaS);
    node.update({} as never);
    return position().map((x) => Math.round(x * 1e9) / 1e9);
  };
  return { ...fake, node, items, play, asset };
}

describe('source/model', () => {
  test('outputs nothing until the model has loaded, then one object', () => {
    const asset: LateModel = { value: null, released: 0 };
    const { play, items, ctx } = make({}, asset);
    play(0.1);
    expect([items.length, ctx.outputs.objects.version]).toEqual([0, 0]);
    asset.value = model();
    play(0.1);
    play(0.1);
    expect([items.length, ctx.outputs.objects.version]).toEqual([1, 1]);
  });

  test('plays the first clip by the clock and starts over', () => {
    const { play } = make({});
    expect([play(0.5), play(1), play(1)]).toEqual([
      [0, 0.5],
      [0, 1.5],
      [0, 0.5],
    ]);
  });

  test('does not depend on the loading time or the number of frames', () => {
    const asset: LateModel = { value: null, released: 0 };
    const late = make({}, asset);
    late.play(0.7);
    asset.value = model();
    const many = make({});
    for (let i = 0; i < 11; i++) many.play(0.1);
    expect(late.play(0.4)).toEqual([0, 1.1]);
    expect(many.play(0)).toEqual([0, 1.1]);
  });

  test('plays the clip of the given name, or none', () => {
    expect(make({ clip: 'slide' }).play(0.5)).toEqual([0.5, 0]);
    expect(make({ clip: 'none' }).play(0.5)).toEqual([0, 0]);
  });

  test('reports the names of the clips if none matches', () => {
    const { play, reports } = make({ clip: 'jump' });
    expect(play(0.5)).toEqual([0, 0]);
    play(0.5);
    expect(reports).toEqual([expect.objectContaining({ code: 'SCR018', port: 'clip', fix: 'Choose one of "rise", "slide".' })]);
  });

  test('pauses, resumes and changes speed without a jump', () => {
    const { play, set } = make({});
    play(0.5);
    set('playing', false);
    expect([play(0), play(3)]).toEqual([
      [0, 0.5],
      [0, 0.5],
    ]);
    set('playing', true);
    set('speed', 2);
    expect([play(0), play(0.25)]).toEqual([
      [0, 0.5],
      [0, 1],
    ]);
    set('speed', -1);
    play(0);
    expect(play(0.75)).toEqual([0, 0.25]);
  });

  test('a reset starts the clip anew', () => {
    const { play, node } = make({});
    play(1.25);
    node.reset?.();
    expect([play(0), play(0.25)]).toEqual([
      [0, 0],
      [0, 0.25],
    ]);
  });

  test('releases the asset and disposes the skeleton of its instance', () => {
    const bone = new Bone();
    const skinned = new SkinnedMesh(new BoxGeometry());
    skinned.add(bone);
    skinned.bind(new Skeleton([bone]));
    skinned.skeleton.computeBoneTexture();
    const asset: LateModel = { value: { instantiate: (): Object3D => skinned, clips: [] }, released: 0 };
    const { node, play } = make({}, asset);
    play(0);
    node.dispose();
    expect([asset.released, skinned.skeleton.boneTexture]).toEqual([1, null]);
  });
});
