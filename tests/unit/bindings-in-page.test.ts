import { resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { bundlePage } from '../../export/bundle/bundle-page.ts';
import type { Binding } from '../../export/graph/project.ts';
import { LIBRARY } from '../support/library.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';

const ROOT = resolve(import.meta.dirname, '../..');

/** The script of a page whose one filter has its strength bound so, and what of Scrim is in it. */
async function page(binding: Binding) {
  const studio = new TestStudio({ library: LIBRARY, readShader })
    .add('video-a', 'source/camera-video')
    .add('sepia-a', 'filter/sepia')
    .add('screen-a', 'output/screen')
    .wire('video-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer')
    .bind('sepia-a.amount', binding);
  const { output } = studio.compile();
  if (output === null) throw new Error('The project does not compile.');
  let script = '';
  const { output: report } = await bundlePage({
    program: output,
    page: { description: '', language: 'en' },
    generator: 'Scrim 0.0.0',
    root: ROOT,
    readAsset: () => Promise.reject(new Error('there is none')),
    sink: {
      write: async (path, bytes) => {
        if (path.endsWith('.js')) script = new TextDecoder().decode(bytes);
      },
    },
  });
  const parts = report?.script ?? {};
  return { bindings: Object.keys(parts).filter((part) => part.startsWith('nodes/binding/')), parts, script };
}

test('a page holds the player of expressions or tracks only where a param is bound so, and runs no text as code', async () => {
  const plain = await page({ value: 0.5 });
  expect(plain.bindings).toEqual([]);
  const moved = await page({ expression: 'sin(time)' });
  expect(moved.bindings).toEqual(['nodes/binding/expression']);
  expect(moved.script).not.toMatch(/\beval\(|\bFunction\(/);
  expect(moved.script.length - plain.script.length).toBeLessThan(4000);
  const keys = [{ timeS: 0, value: 1, easing: 'linear' as const }];
  expect((await page({ track: { keys, repeat: 'loop' } })).bindings).toEqual(['nodes/binding/track']);
});
