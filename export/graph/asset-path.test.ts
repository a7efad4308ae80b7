import { describe, expect, test } from '@jest/globals';
import { assetPathProblem } from './asset-path.ts';

describe('assetPathProblem', () => {
  test.each(['assets/fox.glb', 'assets/sub folder/Füchse (2).png', '100%.png', 'assets/a..b.png', 'assets/.hidden'])(
    'lets %j in',
    (path) => {
      expect(assetPathProblem(path)).toBeNull();
    },
  );

  test.each([
    '',
    '../fox.glb',
    'assets/../../fox.glb',
    'assets/..',
    './fox.glb',
    '/etc/passwd',
    '//server/share',
    'assets//fox.glb',
    'assets/',
    'C:/fox.glb',
    'c:fox.glb',
    'assets\\fox.glb',
    '..\\fox.glb',
    'https://example.com/fox.glb',
    'data:image/png;base64,AA',
    'assets/%2e%2e/fox.glb',
    '%2E%2E%2Ffox.glb',
    'assets/fox.glb%00.png',
    'assets/fox\u0000.glb',
    'assets/fox\n.glb',
    'assets/fox\u0085.glb',
    'assets/.. /fox.glb',
    'assets/. ./fox.glb',
    'a'.repeat(513),
  ])('keeps %j out', (path) => {
    expect(assetPathProblem(path)).not.toBeNull();
  });
});
