import { describe, expect, test } from '@jest/globals';
import { findTerms } from '../isf/find-terms.ts';
import { isfDefinition } from '../isf/isf-definition.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import { readIsf } from '../isf/read-isf.ts';
import { linkIsf } from '../link/link-isf.ts';
import { convertShadertoy, isShadertoy, SITE_LICENCE } from './convert-shadertoy.ts';

const WAVES = `// Created by Ada Example - ada/2020
// License Creative Commons Attribution-NonCommercial-ShareAlike 3.0 Unported License.
void mainImage( out vec4 fragColor, in vec2 fragCoord )
{
    vec2 uv = fragCoord/iResolution.xy;
    fragColor = vec4(0.5 + 0.5*cos(iTime+uv.xyx+vec3(0,2,4)),1.0);
}`;

const COUNTER = `// Common
#define R iResolution.xy
#define LAST(p) texelFetch(iChannel0, ivec2(p), 0)
float hash(float x) { return fract(sin(x) * 43758.5453); }

// Buffer A
// iChannel0: self
float step1(float x) { return x + 1.0 / 64.0; }
void mainImage(out vec4 o, in vec2 p) {
  o = LAST(p);
  o.x = iFrame == 0 ? 0.0 : step1(o.x);
}

// Buffer B
// iChannel0: Buffer A
float step1(float x) { return x * 0.5; }
void mainImage(out vec4 o, in vec2 p) { o = LAST(p); o.x = step1(o.x); }

/*
   Image
*/
// iChannel0: Buffer B
// iChannel1: Buffer A
void mainImage(out vec4 o, vec2 p) { o = vec4(texture(iChannel0, p / R).x, LAST(p).x, texture(iChannel1, p / R).x, 0.0); }
`;

function convert(source: string) {
  const { output, diagnostics } = convertShadertoy(source, 'pasted.glsl');
  if (output === null) throw new Error(JSON.stringify(diagnostics));
  return { ...output, diagnostics };
}

/** Read and linked without a word: what is left to a driver is nobody's mistake here. */
function read(text: string): IsfShader {
  const { output, diagnostics } = readIsf(text, 'converted.fs');
  expect(diagnostics).toEqual([]);
  if (output === null) throw new Error('unreadable');
  expect(linkIsf(output, { node: 'a' }).diagnostics).toEqual([]);
  return output;
}

function inputNames({ inputs }: IsfShader): string[] {
  return inputs.map(({ name, type }) => `${name}:${type}`);
}

describe('one tab', () => {
  test('without channels is a generator under the author’s name and license', () => {
    const { text, diagnostics } = convert(WAVES);
    const shader = read(text);
    expect(diagnostics).toEqual([]);
    expect(shader.kind).toBe('generator');
    expect(shader.credit).toBe('Created by Ada Example - ada/2020');
    expect(shader.licence).toBe('CC BY-NC-SA 3.0');
    expect(isfDefinition(shader, 'waves')).toMatchObject({ type: 'generator/waves', licence: 'CC BY-NC-SA 3.0' });
    // The author's lines are there as they were written.
    for (const line of WAVES.split('\n')) expect(text.split('\n')).toContain(line);
  });

  test('a channel is a layer that repeats, the pointer a point', () => {
    const shader = read(
      convert('void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel2, p / iResolution.xy * 2.0) * iMouse.x; }').text,
    );
    expect(inputNames(shader)).toEqual(['inputImage:image', 'mouse:point2D']);
    expect(shader.inputs[0]?.repeat).toBe(true);
    expect(shader.kind).toBe('filter');
  });

  test('two channels make an operator, and names that are taken are left to the author', () => {
    const source = `vec3 mouse = vec3(1.0);
float inputImage(vec2 p) { return texture(iChannel0, p).x + texture(iChannel1, p).x; }
void mainImage(out vec4 c, in vec2 p) { c = vec4(mouse * inputImage(p / iResolution.xy) * iMouse.z, 1.0); }`;
    const shader = read(convert(source).text);
    expect(inputNames(shader)).toEqual(['inputImage2:image', 'image2:image', 'mouse2:point2D']);
    expect(shader.kind).toBe('operator');
  });

  test('all that the site gives is there', () => {
    const names = [
      'iTime',
      'iGlobalTime',
      'iTimeDelta',
      'float(iFrame)',
      'iFrameRate',
      'iResolution.z',
      'iMouse.w',
      'iDate.w',
      'iSampleRate',
    ];
    const sizes = ['iChannelResolution[0].x', 'iChannelResolution[1].y', 'iChannelTime[3]'];
    read(convert(`void mainImage(out vec4 c, in vec2 p) { c = vec4(${[...names, ...sizes].join(' + ')}); }`).text);
  });

  test('who asks for the size of one channel needs no others', () => {
    const layers = (index: string) =>
      read(
        convert(`void mainImage(out vec4 c, in vec2 p) { int i = 1; c = texture(iChannel0, p / iChannelResolution[${index}].xy); }`).text,
      )
        .inputs.filter(({ type }) => type === 'image')
        .map(({ name }) => name);
    expect(layers('0')).toEqual(['inputImage']);
    expect(layers('i')).toHaveLength(4);
  });
});

describe('several tabs', () => {
  test('pasted with a line before each, they become passes with their own names', () => {
    const { text, diagnostics } = convert(COUNTER);
    const shader = read(text);
    expect(diagnostics).toEqual([]);
    expect(shader.kind).toBe('generator');
    expect(shader.passes.map(({ target, persistent, float }) => ({ target, persistent, float }))).toEqual([
      { target: 'bufferA', persistent: true, float: true },
      { target: 'bufferB', persistent: false, float: true },
      { target: null, persistent: false, float: false },
    ]);
    expect(text.match(/float hash\(/g)).toHaveLength(1);
    expect(text).toContain('float step1_BufferA(float x) { return x + 1.0 / 64.0; }');
  });

  test('what a channel is, is guessed with a warning where the text does not say', () => {
    const { text, diagnostics } = convert(`// Buf A
void mainImage(out vec4 o, vec2 p) { o = texture(iChannel0, p / iResolution.xy); }
// Image
void mainImage(out vec4 o, vec2 p) { o = texture(iChannel0, p / iResolution.xy) + texture(iChannel1, p); }`);
    expect(diagnostics.map(({ severity, message }) => `${severity}: ${message}`)).toEqual([
      'warning: iChannel0 of Buffer A is not specified. Buffer A is used.',
      'warning: iChannel0 of Image is not specified. Buffer A is used.',
    ]);
    expect(inputNames(read(text))).toEqual(['inputImage:image']);
  });

  test('Common belongs to each tab where a tab declares more of the same name', () => {
    const { text } = convert(`// Common
float mixed(float x) { return x; }
struct Ray { vec3 mixed; };
// Buffer A
float mixed(vec2 x) { Ray r = Ray(vec3(mixed(x.x))); return r.mixed.x; }
void mainImage(out vec4 o, vec2 p) { o = vec4(mixed(p)); }
// Image
float mixed(vec2 x) { return mixed(x.y); }
void mainImage(out vec4 o, vec2 p) { o = vec4(mixed(p)); }`);
    read(text);
    expect(text.match(/struct Ray/g)).toHaveLength(2);
  });

  test('a comment that speaks of a tab heads none', () => {
    const { text } = convert(`/* this draws the
image
and no more */
// The image is made of waves.
${WAVES}`);
    expect(read(text).passes).toHaveLength(1);
  });

  test.each([
    ['no image', '// Buffer A\nvoid mainImage(out vec4 o, vec2 p) { o = vec4(1.0); }', 'The Image tab is missing'],
    ['nothing to draw', '// Image\nfloat a = 1.0;', 'The tab Image has no "void mainImage'],
    ['tabs that nothing parts', `${WAVES}\n${WAVES}`, 'The tab Image has 2 functions mainImage'],
  ])('%s is said', (_, source, message) => {
    const { output, diagnostics } = convertShadertoy(source, 'pasted.glsl');
    expect(output).toBeNull();
    expect(diagnostics).toMatchObject([{ code: 'SCR045', severity: 'error', file: 'pasted.glsl' }]);
    expect(diagnostics[0]?.message).toContain(message);
  });
});

describe('the site’s JSON', () => {
  const BUFFER = {
    id: 'b1',
    type: 'buffer',
    channel: 0,
    filepath: '/media/previz/buffer00.png',
    sampler: { wrap: 'clamp', filter: 'nearest' },
  };
  const STONES = { id: 't1', type: 'texture', channel: 1, filepath: '/media/a/stones.jpg', sampler: { wrap: 'repeat' } };
  const WORK = {
    ver: '0.1',
    info: { id: 'XyZ123', name: 'Ripples */ deep', username: 'ada', description: 'Rings in a pond.', tags: ['water', '2d'] },
    renderpass: [
      {
        type: 'image',
        name: 'Image',
        inputs: [BUFFER, STONES],
        outputs: [{ id: 'out', channel: 0 }],
        code: 'void mainImage(out vec4 o, vec2 p) { o = texture(iChannel0, p / iResolution.xy) * texture(iChannel1, p); }',
      },
      {
        type: 'buffer',
        name: 'Buf A',
        inputs: [{ ...BUFFER, channel: 3 }],
        outputs: [{ id: 'b1', channel: 0 }],
        code: 'void mainImage(out vec4 o, vec2 p) { o = texelFetch(iChannel3, ivec2(p), 0) + K; }',
      },
      { type: 'common', name: 'Common', inputs: [], outputs: [], code: '#define K 0.25' },
    ],
  };

  test.each([
    ['as its API answers', { Shader: WORK }],
    ['as a profile exports', { userName: 'ada', numShaders: 1, shaders: [WORK] }],
    ['as its page loads it', [WORK]],
  ])('%s', (_, json) => {
    const source = JSON.stringify(json);
    expect(isShadertoy(source)).toBe(true);
    const { title, text, diagnostics } = convert(source);
    const shader = read(text);
    expect(diagnostics).toEqual([]);
    expect(title).toBe('Ripples */ deep');
    expect(shader).toMatchObject({ title, kind: 'filter', description: 'Rings in a pond.', licence: SITE_LICENCE });
    expect(shader.credit).toBe('ada, https://www.shadertoy.com/view/XyZ123');
    expect(shader.categories).toEqual(['Shadertoy', 'water', '2d']);
    expect(shader.passes).toMatchObject([{ target: 'bufferA', persistent: true, float: true }, { target: null }]);
    expect(shader.inputs).toMatchObject([{ name: 'inputImage', repeat: true }]);
  });

  test('what a layer cannot be is said, and sound is left out', () => {
    const [image] = WORK.renderpass;
    const sound = { type: 'sound', name: 'Sound', inputs: [], outputs: [], code: 'vec2 mainSound(int s, float t) { return vec2(0.0); }' };
    const source = JSON.stringify({ ...WORK, renderpass: [{ ...image, inputs: [{ ...STONES, type: 'keyboard' }] }, sound] });
    expect(convert(source).diagnostics.map(({ severity, message }) => [severity, message])).toEqual([
      ['warning', 'iChannel1 of Image is of kind “keyboard”. A layer takes its place.'],
      ['warning', 'The tab “Sound” is left out: Scrim supports no sound tabs.'],
    ]);
  });
});

describe('terms', () => {
  test.each([
    ['// Copyright © 2013 Ada Example\n// The MIT License', 'Copyright © 2013 Ada Example', 'MIT'],
    ['/*\n * by Ada (2019), CC0\n */', 'by Ada (2019), CC0', 'CC0 (public domain)'],
    ['// License: Creative Commons Attribution 4.0', '', 'CC BY 4.0'],
    ['// CC-BY-NC 4.0\n// fork of https://www.shadertoy.com/view/abc', 'fork of https://www.shadertoy.com/view/abc', 'CC BY-NC 4.0'],
    ['// Licensed under the Hot Potato terms', '', 'As its source says: Licensed under the Hot Potato terms'],
    ['// speed by time\nfloat GPL = 1.0;', '', ''],
  ])('%j', (source, credit, licence) => {
    expect(findTerms(source)).toEqual({ credit, licence });
  });
});

test('ISF files and other texts are no Shadertoy sources', () => {
  expect(isShadertoy('/*{ "ISFVSN": "2" }*/ void mainImage(out vec4 o, vec2 p) {} void main() {}')).toBe(false);
  expect(isShadertoy('{ "format": "scrim-nodes" }')).toBe(false);
  expect(isShadertoy(WAVES)).toBe(true);
});
