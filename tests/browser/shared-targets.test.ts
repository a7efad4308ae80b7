import { expect, test } from '@jest/globals';
import type { Program } from '../../export/program/program.ts';
import { formatDiagnostic } from '../../nodes/kit/diagnostics.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';
import type { Drawn } from './shared-targets.page.ts';

const page = useModule('tests/browser/shared-targets.page.ts');

/** A chain that branches, meets again, has buffers of its own sizes and one that lasts, and reads an early picture late. */
const TRAILS = `/*{"ISFVSN":"2","INPUTS":[{"NAME":"inputImage","TYPE":"image"}],"PASSES":[{"TARGET":"trail","PERSISTENT":true},{}]}*/
void main() {
  if (PASSINDEX == 0) gl_FragColor = mix(IMG_THIS_PIXEL(trail), IMG_THIS_PIXEL(inputImage), 0.4);
  else gl_FragColor = IMG_THIS_PIXEL(trail);
}`;

function program(taps: readonly string[] = []): Program {
  const studio = new TestStudio({ library: LIBRARY, readShader })
    .source('trails.fs', TRAILS)
    .add('video-a', 'source/camera-video')
    .add('blur-a', 'filter/gaussian-blur')
    .add('sepia-a', 'filter/sepia', { amount: 0.5 })
    .add('sobel-a', 'filter/sobel-edges', { overPicture: true })
    .add('trails-a', 'filter/trails')
    .add('blur-b', 'filter/gaussian-blur')
    .add('warm-a', 'filter/color-temperature')
    .add('over-a', 'operator/over', { opacity: 0.5 })
    .add('sepia-b', 'filter/sepia', { amount: 0.7 })
    .add('screen-a', 'output/screen')
    .wire(
      'video-a.layer -> blur-a.inputImage',
      'blur-a.layer -> sepia-a.inputImage',
      'sepia-a.layer -> sobel-a.inputImage',
      'sobel-a.layer -> trails-a.inputImage',
      'trails-a.layer -> blur-b.inputImage',
      'blur-b.layer -> warm-a.inputImage',
      'sepia-a.layer -> over-a.top',
      'warm-a.layer -> over-a.bottom',
      'over-a.layer -> sepia-b.inputImage',
      'sepia-b.layer -> screen-a.layer',
    );
  const { output, diagnostics } = studio.compile({ taps });
  if (output === null) throw new Error(diagnostics.map(formatDiagnostic).join('\n'));
  return output;
}

/** The same, with a texture for each layer. */
function unshared(made: Program): Program {
  return { ...made, resources: made.resources.map((r) => (r.kind === 'target' ? (({ shares: _, ...own }) => own)(r) : r)) };
}

test('pictures that share textures are the same to the byte, in fewer textures, and none is left over', async () => {
  const shared = program();
  const plain = unshared(shared);
  const count = shared.resources.filter((resource) => resource.kind === 'target' && resource.shares !== undefined).length;
  expect(count).toBeGreaterThanOrEqual(4);

  const alone = await page.call<Drawn>('draw', [plain]);
  const together = await page.call<Drawn>('draw', [shared]);
  const [{ pixels, counts } = { pixels: [], counts: null }] = alone.programs;
  expect(new Set(pixels).size).toBeGreaterThan(50);
  expect(together.programs[0]?.pixels).toEqual(pixels);
  // Two views of different sizes have two of each.
  expect((counts?.textures ?? 0) - (together.programs[0]?.counts.textures ?? 0)).toBe(2 * count);
  for (const { leaks, error } of [alone, together])
    expect({ leaks: Object.values(leaks).some((n) => n !== 0), error }).toEqual({ leaks: false, error: 0 });
});

test('a running program goes from one to the other and back, and while a layer is looked at', async () => {
  const shared = program();
  const plain = unshared(shared);
  const looked = program(['blur-a.layer', 'warm-a.layer']);
  const { programs, leaks, error } = await page.call<Drawn>('draw', [shared, plain, shared, looked, shared, plain]);
  const textures = programs.map(({ counts }) => counts.textures);
  expect(textures[2]).toBe(textures[0]);
  expect(textures[4]).toBe(textures[0]);
  expect(textures[5]).toBe(textures[1]);
  expect(textures[3]).toBeGreaterThan(textures[0] ?? 0);
  // What lasts goes on over each change, so that the trails settle; then all are one picture.
  const settled = programs.slice(2).map(({ pixels }) => pixels);
  const furthest = (a: readonly number[], b: readonly number[]) => Math.max(...a.map((value, i) => Math.abs(value - (b[i] ?? 0))));
  for (const pixels of settled) expect(furthest(pixels, settled.at(-1) ?? [])).toBeLessThanOrEqual(2);
  expect({ leaks: Object.values(leaks).some((n) => n !== 0), error }).toEqual({ leaks: false, error: 0 });
});
