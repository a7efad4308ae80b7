import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import { driverDiagnostics } from '../../export/glsl/driver/driver-diagnostics.ts';
import type { Program } from '../../export/program/program.ts';
import type { ShaderError } from '../../export/runtime/gl/program-cache.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';
import type { Act } from './techniques-player.page.ts';

const page = useModule('tests/browser/techniques-player.page.ts');

const FLAT = `/*{ "DESCRIPTION": "One color.", "INPUTS": [{ "NAME": "tint", "TYPE": "color", "DEFAULT": [0, 0.5, 0, 1] }] }*/
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
  test('is drawn with its colors as the inspector shows them, and follows its params without a compile', async () => {
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

const WINDOW = `/*{ "DESCRIPTION": "A window.", "INPUTS": [{ "NAME": "behind", "TYPE": "image", "LABEL": "Behind" }],
"IMPORTED": { "strokes": { "PATH": "pictures/hatching-light.png" } } }*/
vec4 surface(const in Surface s) {
  vec3 paper = texture(strokes, vec2(0.5)).rgb;
  return vec4(IMG_THIS_PIXEL(behind).rgb, step(-1.0, paper.r));
}
`;

test('a technique shows each eye its own side of a layer, and gives back what it had on the GPU', async () => {
  const made = new TestStudio({ library: LIBRARY, readShader })
    .source('window.glsl', WINDOW)
    .add('wall-a', 'objects/primitive', { sizeM: [5, 5, 0.1] })
    .add('across-a', 'objects/transform', { positionM: [0, 0, -2], scale: 4 })
    .add('red-a', 'objects/primitive', { color: [1, 0, 0, 1] })
    .add('left-a', 'objects/transform', { positionM: [-5, 0, -3], scale: 10 })
    .add('green-a', 'objects/primitive', { color: [0, 1, 0, 1] })
    .add('right-a', 'objects/transform', { positionM: [5, 0, -3], scale: 10 })
    .add('back-a', 'layer/scene')
    .add('window-a', 'technique/window')
    .add('apply-a', 'objects/apply-technique')
    .add('front-a', 'layer/scene')
    .add('screen-a', 'output/screen')
    .wire('red-a.objects -> left-a.objects', 'left-a.objects -> back-a.objects')
    .wire('green-a.objects -> right-a.objects', 'right-a.objects -> back-a.objects')
    .wire('wall-a.objects -> across-a.objects', 'across-a.objects -> apply-a.objects', 'window-a.technique -> apply-a.technique')
    .wire('back-a.layer -> window-a.behind', 'apply-a.objects -> front-a.objects', 'front-a.layer -> screen-a.layer');
  interface Eyes {
    readonly first: readonly number[][];
    readonly again: readonly number[][];
    readonly textures: number;
    readonly left: number;
  }
  const { output, diagnostics } = compile({ project: made.project, library: made.library });
  expect(diagnostics).toEqual([]);
  const { first, again, textures, left, ...said } = await page.call<Eyes>('eyes', output);
  expect(said).toEqual({ shaderErrors: [], diagnostics: [], error: 0 });
  const [[red = 0, none = 1] = [], [nothing = 1, green = 0] = []] = first;
  expect([red > 80, none < red / 3, green > 80, nothing < green / 3]).toEqual([true, true, true, true]);
  expect(again).toEqual(first);
  expect(textures).toBeGreaterThan(left);
  expect(left).toBe(0);
});

test('an export holds the techniques that it uses, and nothing to try them with', () => {
  const made = studio(FLAT).add('toon-a', 'technique/toon');
  const program = compiled(made, { sourceMaps: false });
  const techniques = program.resources.filter(({ kind }) => kind === 'technique');
  expect(techniques.map(({ id }) => id)).toEqual(['flat-a.technique']);
  expect(techniques).toMatchObject([{ trial: null }]);
  expect(program.shaders).toEqual([]);
});

test('both techniques that ship take a ball from its own color, and show an edge where the ball ends', async () => {
  for (const type of ['technique/gooch', 'technique/toon']) {
    const made = studio(FLAT).unwire('flat-a.technique -> apply-a.technique').add('style-a', type);
    const { shown, errors } = await play(compiled(made.wire('style-a.technique -> apply-a.technique')), []);
    expect(errors).toEqual([]);
    expect(shown[0]?.[3]).toBe(255);
  }
});
