import type { DrawOperation } from '../../export/program/program.ts';
import type { Player } from '../../export/runtime/player.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import * as cameraVideo from '../../nodes/source/camera-video/runtime.ts';
import {
  colorSampler,
  frame,
  HEIGHT,
  MEASURED_DEPTH,
  pass,
  program,
  shader,
  sourceOperation,
  stand,
  target,
  view,
  WIDTH,
} from './runtime-kit.ts';

const addOne: NodeModule = {
  create: (ctx) => {
    const { params, outputs } = ctx as unknown as { params: { a: { value: number } }; outputs: { result: { value: number } } };
    return {
      update: () => {
        outputs.result.value = params.a.value + 1;
      },
      dispose: () => {},
    };
  },
};

/** Draws without allocating, as nodes should. */
const drawing: NodeModule = {
  create: ({ gl }) => {
    const color = new Float32Array([0.5, 0.25, 0, 1]);
    return { update: () => {}, draw: () => gl.clearBufferfv(gl.COLOR, 0, color), dispose: () => {} };
  },
};

const PICTURE = 'uniform sampler2D picture;';

let player: Player;
let frames: SessionFrame[];

/** Something of everything that runs every frame: nodes, sizes, samplers, uniforms, both domains, both eyes, a background. */
export async function setUp() {
  const stage = await stand(
    program({
      slots: {
        numbers: [1, 0, 0.5, 0.5, 0.5, 1, 0.5],
        texts: [],
        slots: [
          { type: 'number', offset: 0 },
          { type: 'number', offset: 1 },
          { type: 'color', offset: 2 },
          { type: 'number', offset: 6 },
        ],
        params: { 'half.scale': 3, 'tint.color': 2 },
      },
      resources: [
        { id: 'photo', kind: 'external', domain: 'image' },
        { id: 'camera', kind: 'external', domain: 'view' },
        { id: 'room', kind: 'room-depth' },
        target('photo.small', { domain: 'image', size: { base: 'photo', width: [{ op: 'width' }, 2, { op: '/' }], height: [8] } }),
        target('drawn', { samples: 4, depth: 'window' }),
        target('half', { size: { base: 'view', width: [{ op: 'width' }, { slot: 3 }, { op: '*' }], height: [{ op: 'height' }] } }),
        target('smooth', { samples: 4, depth: 'window' }),
        target('history', { lifetime: 'persistent' }),
      ],
      shaders: [
        shader(
          'mix',
          'color = mix(texture(picture, (picture_uvFromViewUv * vec3(uv, 1.0)).xy), texture(other, uv), 0.5) * tint + TIME * 0.0 + picture_size.xyxy * 0.0 + texture(near, uv).r * near_decode;',
          `${PICTURE} uniform mat3 picture_uvFromViewUv; uniform vec2 picture_size; uniform sampler2D other, near; uniform vec4 near_decode, tint; uniform float TIME;`,
        ),
        shader('copy', 'color = texture(picture, uv) * value;', `${PICTURE} uniform float value;`),
      ],
      operations: [
        {
          kind: 'value',
          id: 'add',
          node: 'add',
          type: 'add',
          reads: [],
          writes: [],
          view: 'once',
          inputs: {},
          multiple: [],
          outputs: { result: { kind: 'slot', slot: 1 } },
          params: { a: 0 },
          config: {},
          assets: {},
        },
        sourceOperation('source/camera-video', 'layer', 'camera', { params: { color: 2 }, config: { withoutImage: 'color' } }),
        sourceOperation('world/depth', 'depth', 'room'),
        {
          ...sourceOperation('draw', 'layer', 'drawn', { outputs: {} }),
          kind: 'draw',
          view: 'each',
          target: 'drawn',
          shadowMaps: null,
          occlusion: null,
        } as DrawOperation,
        pass('small', 1, 'photo.small', {
          view: 'once',
          samplers: [colorSampler('picture', 'photo')],
          uniforms: [{ name: 'value', type: 'float', source: { slot: 1 } }],
        }),
        pass('half', 1, 'half', {
          samplers: [colorSampler('picture', 'camera')],
          uniforms: [{ name: 'value', type: 'float', source: { slot: 1 } }],
        }),
        pass('smooth', 1, 'smooth', { samplers: [colorSampler('picture', 'drawn')] }),
        pass('history', 0, 'history', {
          samplers: [
            colorSampler('picture', 'photo.small', 'cover'),
            colorSampler('other', 'history'),
            { name: 'near', source: { kind: 'depth', depth: { resource: 'smooth', encoding: 'window' } }, fit: 'none' },
          ],
          uniforms: [
            { name: 'tint', type: 'vec4', source: { slot: 2 } },
            { name: 'TIME', type: 'float', source: { builtin: 'TIME' } },
          ],
        }),
        pass('screen', 1, 'screen', { blend: 'over', samplers: [colorSampler('picture', 'history')] }),
      ],
    }),
    { createScenes, modules: { add: addOne, draw: drawing, 'source/camera-video': cameraVideo, 'world/depth': MEASURED_DEPTH } },
  );
  player = stage.player;
  player.setSession({ world: 'image', blend: 'opaque' });
  const eyes = [view(0, 0, WIDTH / 2, HEIGHT), view(WIDTH / 2, 0, WIDTH / 2, HEIGHT)];
  frames = Array.from({ length: 8 }, (_, i) => frame(i, eyes));
  run(200);
  return stage.gl.getError();
}

export function run(count: number): void {
  for (let i = 0; i < count; i++) {
    const next = frames[i % frames.length];
    if (next) player.draw(next);
  }
}

/** The same with one small object a frame, which the measurement has to see. */
export function runCareless(count: number): void {
  for (let i = 0; i < count; i++) {
    run(1);
    kept = careless(i);
  }
}

export let kept: unknown;

function careless(i: number): { readonly i: number } {
  return { i };
}
