import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { compileText } from '../support/compile-project.ts';
import { projectText } from '../support/project-kit.ts';
import type { Followed } from './own-drawing.page.ts';

const page = useModule('tests/browser/own-drawing.page.ts', { mounts: { '/nodes/': join(process.cwd(), 'nodes') } });

const BALL = 'capture/example/assets/glossy-ball.capture/capture.json';
const VASE = 'splats/example/assets/vase.sog';

/** A vase of splats over a captured ball, or the camera alone. */
function compileOver(hasPlaces: boolean): Program {
  const text = projectText({
    nodes: {
      'ball-a': ['source/capture', { file: 'ball' }],
      'vase-a': ['source/splats', { file: 'vase' }],
      'video-a': 'source/camera-video',
      'over-a': 'operator/over',
      'screen-a': 'output/screen',
    },
    wires: hasPlaces
      ? ['vase-a.layer -> over-a.top', 'ball-a.layer -> over-a.bottom', 'over-a.layer -> screen-a.layer']
      : ['video-a.layer -> screen-a.layer'],
    assets: {
      ball: { path: 'assets/ball.capture/capture.json', kind: 'capture' },
      vase: { path: 'assets/vase.sog', kind: 'splats' },
    },
  });
  const program = compileText(text);
  return { ...program, assets: program.assets.map((asset) => ({ ...asset, path: asset.id === 'ball' ? BALL : VASE })) };
}

test('the GPU objects of a capture and of splats belong to their nodes and files, and go with them', async () => {
  const followed = await page.call<Followed>('follow', compileOver(true), compileOver(false), 'nodes/source/', null);
  expect(followed.error).toBe(0);
  const names = followed.owners.map(({ kind, name, isLeft }) => [kind, name, isLeft]);
  expect(names).toEqual(
    expect.arrayContaining([
      ['asset', BALL, false],
      ['asset', VASE, false],
      ['node', 'vase-a', false],
      ['node', 'ball-a', false],
    ]),
  );
  const bytes = followed.owners.reduce((sum, owner) => sum + owner.bytes, 0);
  expect(followed.owners.every((owner) => owner.objects > 0)).toBe(true);
  // Beside them there is at most a target of the program.
  expect(followed.bytes).toBeGreaterThanOrEqual(bytes);
  expect(bytes).toBeGreaterThan(0.9 * followed.bytes);
  expect(followed.after).toEqual([]);
});

test('what a node leaves when it is removed is a leak', async () => {
  const { owners, after } = await page.call<Followed>('follow', compileOver(true), compileOver(false), 'nodes/source/', 'source/splats');
  expect(owners.find(({ name }) => name === 'vase-a')).toEqual({ kind: 'node', name: 'vase-a', objects: 3, bytes: 3072, isLeft: false });
  expect(after).toEqual([{ kind: 'node', name: 'vase-a', objects: 3, bytes: 3072, isLeft: true }]);
});
