import { describe, expect, test } from '@jest/globals';
import { type FakeContext, fakeContext } from '../../../tests/support/node-context.ts';
import { type LayerTexture, MAY_CHANGE } from '../../kit/runtime.ts';
import type { CameraImage, SessionFrame } from '../../kit/session.ts';
import type { Writable } from '../../kit/value-views.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const UPRIGHT = [1, 0, 0, 0, 1, 0, 0, 0, 1];

function image(name: string): CameraImage {
  return {
    texture: { name } as unknown as WebGLTexture,
    widthPx: 640,
    heightPx: 480,
    uvFromViewUv: Float32Array.of(1, 0, 0, 0, -1, 0, 0, 1, 1),
  };
}

function frame(...images: (CameraImage | null)[]): SessionFrame {
  return { viewCount: images.length, views: images.map((cameraImage) => ({ cameraImage })) } as unknown as SessionFrame;
}

function start(): FakeContext<typeof definition> {
  const fake = fakeContext(definition);
  const views = fake.ctx.outputs.layer.views as Writable<LayerTexture>[];
  for (let i = 0; i < 2; i++) views.push({ texture: null, widthPx: 0, heightPx: 0, uvFromViewUv: new Float32Array(9), version: -1 });
  return fake;
}

describe('camera video', () => {
  test('is the camera image of each view, with its transform', () => {
    const { ctx } = start();
    const [left, right] = [image('left'), image('right')];
    create(ctx).update(frame(left, right));
    expect(ctx.outputs.layer.views.map((view) => view.texture)).toEqual([left.texture, right.texture]);
    expect(ctx.outputs.layer.views[1]).toMatchObject({ widthPx: 640, heightPx: 480 });
    expect([...(ctx.outputs.layer.views[0]?.uvFromViewUv ?? [])]).toEqual([...left.uvFromViewUv]);
  });

  test('is transparent without a camera image, so that the world is visible', () => {
    const { ctx } = start();
    const node = create(ctx);
    node.update(frame(image('left'), image('right')));
    node.update(frame(null));
    expect(ctx.outputs.layer.views.map((view) => view.texture)).toEqual([null, null]);
    expect([...(ctx.outputs.layer.views[0]?.uvFromViewUv ?? [])]).toEqual(UPRIGHT);
  });

  test('tells a new image only in sessions that do', () => {
    const { ctx } = start();
    const node = create(ctx);
    const versions = [undefined, 0, 0, 1].map((version) => {
      node.update({ ...frame(image('left')), ...(version === undefined ? {} : { version }) });
      return ctx.outputs.layer.views[0]?.version;
    });
    expect(versions).toEqual([MAY_CHANGE, 0, 0, 1]);
  });

  test('asks for the camera only where a filter reads the picture, and never insists', () => {
    expect(definition.needs).toMatchObject([
      { capability: 'camera-image', when: 'sampled', required: 'alone' },
      { capability: 'camera-image', when: 'sampled', required: false },
    ]);
    expect(definition.lowering).toEqual({ kind: 'source', background: 'world' });
  });
});
