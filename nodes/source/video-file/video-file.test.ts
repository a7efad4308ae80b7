import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetHandle, AssetService, ImageAsset, VideoAsset } from '../../kit/assets.ts';
import type { ParamValue } from '../../kit/definition.ts';
import type { LayerTexture } from '../../kit/runtime.ts';
import type { Writable } from '../../kit/value-views.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const PICTURE: ImageAsset = { texture: {} as WebGLTexture, widthPx: 64, heightPx: 48 };

/** A video of 4 s; `followed` is what was asked of its playback: time, rate, loop. */
function make(params: Record<string, ParamValue> = {}) {
  const followed: [number, number, boolean][] = [];
  const log: string[] = [];
  let picture: ImageAsset | null = null;
  let pending: Promise<void> | null = null;
  const problems: ((problem: { message: string; fix: string }) => void)[] = [];
  const video: VideoAsset = {
    durationS: 4,
    widthPx: 64,
    heightPx: 48,
    open: (onProblem) => {
      problems.push(onProblem);
      return {
        get image() {
          return picture;
        },
        version: 7,
        follow: (timeS, rate, loop) => followed.push([Math.round(timeS * 1e9) / 1e9, rate, loop]),
        settle: () => pending,
        dispose: () => log.push('playback'),
      };
    },
  };
  const handle: AssetHandle<VideoAsset> = { kind: 'video', value: video, settled: Promise.resolve(), release: () => log.push('release') };
  const assets = { video: () => handle } as Partial<AssetService> as AssetService;
  const fake = fakeContext(definition, { params: { file: 'film', ...params }, services: { assets } });
  (fake.ctx.outputs.layer.views as Writable<LayerTexture>[]).push({
    texture: null,
    widthPx: 0,
    heightPx: 0,
    uvFromViewUv: new Float32Array(9),
    version: -1,
  });
  const node = create(fake.ctx);
  /** Goes on by so many seconds and tells what was asked for. */
  const play = (deltaS: number) => {
    fake.tick(deltaS);
    node.update({} as never);
    return followed.at(-1);
  };
  return {
    ...fake,
    node,
    play,
    log,
    view: fake.ctx.outputs.layer.views[0],
    problems,
    load: (loaded: ImageAsset) => {
      picture = loaded;
    },
    wait: (promise: Promise<void>) => {
      pending = promise;
    },
  };
}

describe('source/video-file', () => {
  test('plays by the clock from its start, and starts over at its end', () => {
    const { play } = make({ startS: 1 });
    expect([play(0.5), play(1), play(2.5)]).toEqual([
      [1.5, 1, true],
      [2.5, 1, true],
      [1, 1, true],
    ]);
  });

  test('without looping holds the last frame', () => {
    const { play } = make({ loop: false });
    expect([play(3), play(3)]).toEqual([
      [3, 1, false],
      [4, 0, false],
    ]);
  });

  test('pauses, resumes and changes speed without a jump', () => {
    const { play, set } = make();
    play(1);
    set('playing', false);
    expect([play(0.5), play(5)]).toEqual([
      [1.5, 0, true],
      [1.5, 0, true],
    ]);
    set('playing', true);
    set('speed', 2);
    expect([play(1), play(0.5)]).toEqual([
      [1.5, 2, true],
      [2.5, 2, true],
    ]);
  });

  test('a paused clock requests one exact frame', () => {
    const { play } = make();
    play(1);
    expect(play(0)).toEqual([1, 0, true]);
  });

  test('a reset starts it anew', () => {
    const { play, node } = make({ startS: 0.5 });
    play(2);
    node.reset?.();
    expect(play(0.25)).toEqual([0.5, 1, true]);
  });

  test('shows its picture when it is there, also when it was waited for', async () => {
    const { play, node, view, load, wait } = make();
    play(0.1);
    expect([view?.texture, view?.widthPx, node.settle?.()]).toEqual([null, 0, null]);
    let arrive = (): void => {};
    wait(
      new Promise((resolve) => {
        arrive = resolve;
      }),
    );
    const settled = node.settle?.();
    load(PICTURE);
    arrive();
    await settled;
    expect(view).toMatchObject({ texture: PICTURE.texture, widthPx: 64, heightPx: 48 });
  });

  test('reports problems, and disposes its playback', () => {
    const { play, node, reports, problems, log } = make();
    play(0.1);
    problems[0]?.({ message: 'The browser does not let it start.', fix: 'Tap.' });
    expect(reports).toEqual([
      { code: 'SCR055', severity: 'warning', port: 'file', message: 'The browser does not let it start.', fix: 'Tap.' },
    ]);
    node.dispose();
    expect(log).toEqual(['playback', 'release']);
  });
});
