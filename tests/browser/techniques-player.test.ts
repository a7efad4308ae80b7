import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { type CompileOptions, compile } from '../../export/compiler/compile.ts';
import { driverDiagnostics } from '../../export/glsl/driver/driver-diagnostics.ts';
import type { Program } from '../../export/program/program.ts';
import type { ShaderError } from '../../export/runtime/gl/program-cache.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';
import type { Act } from './techniques-player.page.ts';

const chromium = useBrowser();
let page: PageModule;
beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/techniques-player.page.ts');
}, 60_000);
afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

const FLAT = `/*{ "DESCRIPTION": "One colour.", "INPUTS": [{ "NAME": "tint", "TYPE": "color", "DEFAULT": [0, 0.5, 0, 1] }] }*/
vec4 surface(const in Surface s) {
  return vec4(tint.rgb, 1.0);
}
`;

/** A ball drawn with a technique of the project's own. */
function studio(text: string): TestStudio {
  return new TestStudio({ library: LIBRARY, readShader })
    .source('flat.glsl', text)
    .add('ball-a', 'objects/primitive', { shape: 'sphere' })
    .add('flat-a', 'technique/flat')
    .add('apply-a', 'objects/apply-technique')
    .add('scene-a', 'layer/scene')
    .add('screen-a', 'output/screen')
    .wire('ball-a.objects -> apply-a.objects', 'flat-a.technique -> apply-a.technique', 'apply-a.objects -> scene-a.objects')
    .wire('scene-a.layer -> screen-a.layer');
}

function compiled(made: TestStudio, options: CompileOptions = {}): Program {
  const { output, diagnostics } = compile({ project: made.project, library: LIBRARY, options });
  if (!output) throw new Error(JSON.stringify(diagnostics));
  return output;
}

interface Played {
  readonly shown: readonly number[][];
  readonly outcomes: readonly string[];
  readonly errors: readonly ShaderError[];
  readonly diagnostics: readonly unknown[];
  readonly programs: number;
  readonly error: number;
}

async function play(first: Program, acts: readonly Act[]): Promise<Played> {
  const played = await page.call<Played>('play', first, acts);
  expect({ diagnostics: played.diagnostics, error: played.error }).toEqual({ diagnostics: [], error: 0 });
  return played;
}

const GREEN = [0, 128, 0, 255];
const RED = [255, 0, 0, 255];

describe('a technique of the project', () => {
  test('is drawn with its colours as the inspector shows them, and follows its params without a compile', async () => {
    const { shown } = await play(compiled(studio(FLAT)), [{ node: 'flat-a', param: 'tint', value: [1, 0, 0, 1] }]);
    expect(shown).toEqual([GREEN, RED]);
  });

  test('changes while it runs, and leaves no shader of its older texts behind', async () => {
    const swapped = FLAT.replace('tint.rgb', 'tint.bgr + vec3(0.0, 0.0, 1.0)');
    const back = { program: compiled(studio(FLAT)) };
    const forth = { program: compiled(studio(swapped)) };
    const once = await play(back.program, [forth, back]);
    expect(once.shown).toEqual([GREEN, [0, 128, 255, 255], GREEN]);
    const often = await play(back.program, [forth, back, forth, back, forth, back]);
    expect(often.programs).toBe(once.programs);
  });

  test('that the driver does not take is told on its line, and the last good one runs on', async () => {
    const broken = compiled(studio(FLAT.replace('return vec4(tint.rgb, 1.0);', 'vec3 c = tint.rgb;\n  return vec4(c, missing);')));
    const { shown, outcomes, errors } = await play(compiled(studio(FLAT)), [{ program: broken }]);
    expect(outcomes).toEqual(['kept']);
    expect(shown).toEqual([GREEN, GREEN]);
    const [error] = errors;
    const shader = broken.shaders.find(({ id }) => id === error?.shaderId);
    if (!shader || !error) throw new Error('No shader is to blame.');
    expect(driverDiagnostics(shader, error.log)).toEqual([
      expect.objectContaining({
        code: 'SCR042',
        nodeId: 'flat-a',
        file: 'shaders/flat.glsl',
        line: 4,
        message: expect.stringContaining('missing'),
      }),
    ]);
  });

  test('that cannot be read is refused on its line', () => {
    const { output, diagnostics } = compile({ project: studio(FLAT.replace('1.0);', '1.0)')).project, library: LIBRARY });
    expect(output).toBeNull();
    expect(diagnostics).toEqual([expect.objectContaining({ code: 'SCR041', nodeId: 'flat-a', file: 'shaders/flat.glsl', line: 3 })]);
  });
});

test('an export holds the techniques that it uses, and nothing to try them with', () => {
  const made = studio(FLAT).add('toon-a', 'technique/toon');
  const program = compiled(made, { sourceMaps: false });
  const techniques = program.resources.filter(({ kind }) => kind === 'technique');
  expect(techniques.map(({ id }) => id)).toEqual(['flat-a.technique']);
  expect(techniques).toMatchObject([{ trial: null }]);
  expect(program.shaders).toEqual([]);
});

test('both techniques that ship take a ball from its own colour, and show an edge where the ball ends', async () => {
  for (const type of ['technique/gooch', 'technique/toon']) {
    const made = studio(FLAT).unwire('flat-a.technique -> apply-a.technique').add('style-a', type);
    const { shown, errors } = await play(compiled(made.wire('style-a.technique -> apply-a.technique')), []);
    expect(errors).toEqual([]);
    expect(shown[0]?.[3]).toBe(255);
  }
});
