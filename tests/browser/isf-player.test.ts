import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import type { Played } from './runtime-examples.page.ts';

const page = useModule('tests/browser/runtime-examples.page.ts', {
  mounts: { '/nodes/': join(process.cwd(), 'nodes') },
});

const SCREEN = { type: 'output/screen', version: 1 };

function compileProject(nodes: object, wires: readonly string[], sources: Readonly<Record<string, string>>): Program {
  const project = JSON.stringify({ format: 'scrim-project', version: 1, title: 'Test', graphs: { main: { nodes, wires } } });
  const loaded = loadProject({ project, layout: null, sources });
  if (!loaded.output) throw new Error(JSON.stringify(loaded.diagnostics));
  const { output, diagnostics } = compile({ project: loaded.output, library: LIBRARY });
  if (!output) throw new Error(JSON.stringify(diagnostics));
  return output;
}

async function play(program: Program): Promise<Played> {
  const played = await page.call<Played>('play', program, 'nodes/source/image-file/example/', 0, [100, 150, 200, 255], 0);
  expect({ diagnostics: played.diagnostics, error: played.error }).toEqual({ diagnostics: [], error: 0 });
  return played;
}

describe('an ISF file of a project, in the player', () => {
  test('sees an event in the frame of a pulse, and none without', async () => {
    const flash =
      '/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "flash", "TYPE": "event" }] }*/\nvoid main() { gl_FragColor = flash ? vec4(1.0) : vec4(1.0, 0.0, 0.0, 1.0); }';
    const nodes = {
      'start-a1b2': { type: 'pulse/on-start', version: 1 },
      'flash-a1b2': { type: 'generator/flash', version: 1 },
      'screen-a1b2': SCREEN,
    };
    const shown = ['flash-a1b2.layer -> screen-a1b2.layer'];
    const wired = compileProject(nodes, ['start-a1b2.pulse -> flash-a1b2.flash', ...shown], { 'flash.fs': flash });
    expect((await play(wired)).center).toEqual([255, 255, 255, 255]);
    const alone = compileProject({ 'flash-a1b2': nodes['flash-a1b2'], 'screen-a1b2': SCREEN }, shown, { 'flash.fs': flash });
    expect((await play(alone)).center).toEqual([255, 0, 0, 255]);
  });

  test('is drawn with the vertex shader beside it', async () => {
    const program = compileProject(
      { 'half-a1b2': { type: 'generator/half', version: 1 }, 'screen-a1b2': SCREEN },
      ['half-a1b2.layer -> screen-a1b2.layer'],
      {
        'half.fs': '/*{ "ISFVSN": "2" }*/\nvarying vec3 tint;\nvoid main() { gl_FragColor = vec4(tint, 1.0); }',
        'half.vs':
          'varying vec3 tint;\nvoid main() { isf_vertShaderInit(); tint = vec3(isf_FragNormCoord.x > 0.5 ? 1.0 : 0.0, 0.2, 0.4); }',
      },
    );
    const { center, corner } = await play(program);
    expect(center.slice(1)).toEqual([51, 102, 255]);
    expect(Math.abs((center[0] ?? 0) - 128)).toBeLessThan(4);
    expect(corner[0]).toBeLessThan(10);
  });

  test('reads the pictures that it imports, and cubes of them', async () => {
    const side = '../assets/SIDE';
    const leak = `/*{ "ISFVSN": "2", "IMPORTED": { "leak": { "PATH": "${side}" }, "sky": { "TYPE": "cube", "PATH": [${new Array(6).fill(`"${side}"`).join()}] } } }*/
void main() {
  vec4 flat_ = IMG_NORM_PIXEL(leak, vec2(0.5));
  vec4 around = textureCube(sky, vec3(0.0, 0.0, -1.0));
  gl_FragColor = distance(flat_, around) < 0.02 ? flat_ : vec4(1.0, 0.0, 0.0, 1.0);
}`;
    const nodes = { 'leak-a1b2': { type: 'generator/leak', version: 1 }, 'screen-a1b2': SCREEN };
    const program = compileProject(nodes, ['leak-a1b2.layer -> screen-a1b2.layer'], { 'leak.fs': leak.replaceAll('SIDE', 'sticker.png') });
    expect(program.assets).toEqual([{ id: 'imported:assets/sticker.png', kind: 'image', path: 'assets/sticker.png' }]);
    expect((await play(program)).center).toEqual([255, 205, 60, 255]);
  });

  test('a transition stands between two layers', async () => {
    const fade = 'uniform float floor_; // = 0.0\nvec4 transition(vec2 uv) { return mix(getFromColor(uv), getToColor(uv), progress); }';
    const nodes = {
      'film-a1b2': { type: 'source/camera-video', version: 1 },
      'red-a1b2': { type: 'generator/red', version: 1 },
      'fade-a1b2': { type: 'operator/fade', version: 1, params: { progress: 0.5 } },
      'screen-a1b2': SCREEN,
    };
    const wires = [
      'film-a1b2.layer -> fade-a1b2.startImage',
      'red-a1b2.layer -> fade-a1b2.endImage',
      'fade-a1b2.layer -> screen-a1b2.layer',
    ];
    const red = '/*{ "ISFVSN": "2" }*/\nvoid main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }';
    expect((await play(compileProject(nodes, wires, { 'red.fs': red, 'fade.glsl': fade }))).center).toEqual([178, 75, 100, 255]);
  });
});
