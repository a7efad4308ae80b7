import type { DrawOperation, PassOperation, PassUniform } from '../../export/program/program.ts';
import { createManualClock } from '../../export/runtime/clock.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import {
  colorSampler,
  createGl,
  frame,
  HEIGHT,
  pass,
  pixel,
  program,
  shader,
  sourceOperation,
  stand,
  target,
  texture,
  upset,
  view,
  WIDTH,
} from './runtime-kit.ts';

const PICTURE = 'uniform sampler2D picture;';

function uniform(name: string, type: PassUniform['type'], source: PassUniform['source']): PassUniform {
  return { name, type, source };
}

/** Two passes and a color param, on a context whose state is as bad as can be. */
export async function playsPasses() {
  const { gl, player } = await stand(
    program({
      slots: { numbers: [0.2, 0.4, 0.6, 1], texts: [], slots: [{ type: 'color', offset: 0 }], params: { 'flat.color': 0 } },
      resources: [target('flat.out')],
      shaders: [
        shader('flat', 'color = tint;', 'uniform vec4 tint;'),
        shader('invert', 'color = vec4(1.0 - texture(picture, uv).rgb, 1.0);', PICTURE),
      ],
      operations: [
        pass('flat', 0, 'flat.out', { uniforms: [uniform('tint', 'vec4', { slot: 0 })] }),
        pass('invert', 1, 'screen', { samplers: [colorSampler('picture', 'flat.out')] }),
      ],
    }),
  );
  upset(gl);
  player.draw(frame(0));
  const before = pixel(gl, 10, 10);
  const accepted = [
    player.setParam('flat', 'color', [1, 1, 0, 1]),
    player.setParam('flat', 'nothing', 1),
    player.setParam('flat', 'color', [Number.NaN, 0, 0, 1]),
  ];
  upset(gl);
  player.draw(frame(1));
  const after = pixel(gl, WIDTH - 1, HEIGHT - 1);
  player.dispose();
  return { before, after, accepted, error: gl.getError() };
}

/** ISF's automatic uniforms. */
export async function builtins() {
  const clock = createManualClock(0, Date.UTC(2024, 1, 29, 13, 45, 30));
  const body = `
    bool ok = TIME == 0.1 && TIMEDELTA > 0.033 && TIMEDELTA < 0.034 && FRAMEINDEX == 3
      && vec4(DATE.xyz, floor(DATE.w)) == vec4(2024.0, 2.0, 29.0, 49530.0) && PASSINDEX == 2 && RENDERSIZE == vec2(${WIDTH}.0, ${HEIGHT}.0)
      && whole == 7 && flag && place == vec2(1.0, 2.0) && axis == vec3(3.0, 4.0, 5.0);
    color = ok ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);`;
  const names = ['TIME', 'TIMEDELTA', 'FRAMEINDEX', 'DATE', 'PASSINDEX', 'RENDERSIZE'] as const;
  const declarations = `uniform float TIME, TIMEDELTA; uniform int FRAMEINDEX, PASSINDEX; uniform vec4 DATE; uniform vec2 RENDERSIZE;
    uniform int whole; uniform bool flag; uniform vec2 place; uniform vec3 axis;`;
  const first = program({
    slots: {
      numbers: [7, 1, 1, 2, 3, 4, 5],
      texts: [],
      slots: [
        { type: 'number', offset: 0 },
        { type: 'toggle', offset: 1 },
        { type: 'vector2', offset: 2 },
        { type: 'vector3', offset: 4 },
      ],
      params: {},
    },
    shaders: [shader('builtins', body, declarations)],
    operations: [
      pass('builtins', 0, 'screen', {
        passIndex: 2,
        uniforms: [
          ...names.map((name) => uniform(name, 'float', { builtin: name })),
          uniform('whole', 'int', { slot: 0 }),
          uniform('flag', 'bool', { slot: 1 }),
          uniform('place', 'vec2', { slot: 2 }),
          uniform('axis', 'vec3', { slot: 3 }),
        ],
      }),
    ],
  });
  const gl = createGl();
  const opened = stand(first, { gl, clock });
  const { player } = await runUntil(clock, opened);
  player.draw(frame(3, undefined, { timeS: Math.fround(0.1) }));
  const result = pixel(gl, 5, 5);
  player.dispose();
  return { result, error: gl.getError() };
}

/** What comes with a picture, in shaders that read nothing else of it: its size, its placement, how its depth is read. */
export async function asideFromImage() {
  const resources = [target('small', { size: { base: 'view', width: [20], height: [10] }, depth: 'window' })];
  const depth = { name: 'picture', source: { kind: 'depth', depth: { resource: 'small', encoding: 'window' } }, fit: 'none' } as const;
  const read = async (declaration: string, body: string, sampler: PassOperation['samplers'][number]) => {
    const { gl, player } = await stand(
      program({
        resources,
        shaders: [shader('fill', 'color = vec4(1.0);'), shader('read', body, `uniform sampler2D picture; ${declaration}`)],
        operations: [pass('fill', 0, 'small'), pass('read', 1, 'screen', { samplers: [sampler] })],
      }),
    );
    player.draw(frame(0));
    const seen = pixel(gl, 5, 5);
    player.dispose();
    return seen;
  };
  const color = colorSampler('picture', 'small');
  return {
    size: await read('uniform vec2 picture_size;', 'color = vec4(picture_size / 255.0, 0.0, 1.0);', color),
    placement: await read(
      'uniform mat3 picture_uvFromViewUv;',
      'color = vec4((picture_uvFromViewUv * vec3(0.2, 0.4, 1.0)).xy, 0.0, 1.0);',
      color,
    ),
    // Near 0.1 m and far 100 m.
    decode: await read(
      'uniform vec4 picture_decode;',
      'color = abs(picture_decode.x + 1.002) < 0.001 && abs(picture_decode.y + 0.2002) < 0.001 && picture_decode.w == 1.0 ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0);',
      depth,
    ),
  };
}

/** Runs a manual clock until its result is there; drivers answer after an unknown time, and promises need turns in between. */
async function runUntil<T>(clock: { advance(s: number): void }, awaited: Promise<T>): Promise<T> {
  let there = false;
  const note = () => {
    there = true;
  };
  void awaited.then(note, note);
  while (!there) {
    clock.advance(0.01);
    await new Promise((resolve) => setTimeout(resolve, 0));
  }
  return awaited;
}

const COUNT = 'color = texture(before, uv) + vec4(16.0 / 255.0, 0.0, 0.0, 1.0);';

function counter(viewCount: 1 | 2) {
  return {
    program: program({
      resources: [target('count.buffer', { lifetime: 'persistent' })],
      shaders: [shader('count', COUNT, 'uniform sampler2D before;'), shader('show', 'color = texture(picture, uv);', PICTURE)],
      operations: [
        pass('count', 0, 'count.buffer', { samplers: [colorSampler('before', 'count.buffer')] }),
        pass('show', 1, 'screen', { samplers: [colorSampler('picture', 'count.buffer')] }),
      ],
    }),
    views: viewCount === 1 ? [view(0, 0, WIDTH, HEIGHT)] : [view(0, 0, WIDTH / 2, HEIGHT), view(WIDTH / 2, 0, WIDTH / 2, HEIGHT)],
  };
}

/** A persistent buffer counts frames, per view, over a resize, and starts over on reset. */
export async function persistent() {
  const { program: counting, views } = counter(2);
  const { gl, player } = await stand(counting);
  const red = (x: number) => pixel(gl, x, 4)[0];
  for (let i = 0; i < 3; i++) player.draw(frame(i, views));
  const left = red(2);
  const right = red(WIDTH - 2);
  const smaller = [view(0, 0, 16, 16), view(WIDTH / 2, 0, 16, 16)];
  player.draw(frame(3, smaller));
  const resized = red(2);
  player.reset();
  player.draw(frame(0, smaller));
  const restarted = red(2);
  player.dispose();
  return { left, right, resized, restarted, error: gl.getError() };
}

/** Sizes are computed in each frame, from the view, other targets, pictures and slots. */
export async function sizes() {
  const show = 'color = vec4(vec2(textureSize(picture, 0)) / 255.0, 0.0, 1.0);';
  const first = program({
    slots: { numbers: [0.25], texts: [], slots: [{ type: 'number', offset: 0 }], params: { 'small.scale': 0 } },
    resources: [
      // Written before its base, to be resized in the right order all the same.
      target('smaller', {
        size: { base: 'small', width: [{ op: 'width' }, 2, { op: '-' }], height: [{ op: 'height' }, 3, { op: '/' }, { op: 'ceil' }] },
      }),
      target('small', {
        size: {
          base: 'view',
          width: [{ op: 'width' }, { slot: 0 }, { op: '*' }, { op: 'floor' }],
          height: [{ op: 'height' }, { slot: 0 }, { op: '*' }, 5, { op: 'max' }],
        },
      }),
    ],
    shaders: [shader('fill', 'color = vec4(1.0);'), shader('show', show, PICTURE)],
    operations: [
      pass('fill-smaller', 0, 'smaller'),
      pass('fill-small', 0, 'small'),
      pass('show', 1, 'screen', { samplers: [colorSampler('picture', 'smaller')] }),
    ],
  });
  const { gl, player } = await stand(first);
  player.draw(frame(0));
  const quarter = pixel(gl, 1, 1);
  player.setParam('small', 'scale', 0.5);
  player.draw(frame(1));
  const half = pixel(gl, 1, 1);
  player.draw(frame(2, [view(0, 0, 40, 30)]));
  const other = pixel(gl, 1, 1);
  player.dispose();
  return { quarter, half, other, error: gl.getError() };
}

/** Two eyes side by side, each with a camera picture of its own behind; the second, narrow one of the emulator is skipped. */
export async function views() {
  const first = program({
    shaders: [shader('half', 'color = uv.x < 0.5 ? vec4(0.0) : vec4(0.0, 0.0, 0.2, 0.2);')],
    operations: [pass('half', 0, 'screen', { blend: 'over' })],
  });
  const { gl, player } = await stand(first);
  const flipX = new Float32Array([-1, 0, 0, 0, 1, 0, 1, 0, 1]);
  const identity = new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 1]);
  const red = { texture: texture(gl, 1, 1, [255, 0, 0, 255]), widthPx: 1, heightPx: 1, uvFromViewUv: identity };
  // Left half green, right half white; shown mirrored.
  const two = { texture: texture(gl, 2, 1, [0, 255, 0, 255, 255, 255, 255, 255]), widthPx: 2, heightPx: 1, uvFromViewUv: flipX };
  const eyes = [view(0, 0, 32, HEIGHT, { eye: 'left', cameraImage: red }), view(32, 0, 32, HEIGHT, { eye: 'right', cameraImage: two })];
  player.setSession({ world: 'image', blend: 'opaque' });
  player.draw(frame(0, eyes));
  const world = [pixel(gl, 4, 4), pixel(gl, 28, 4), pixel(gl, 36, 4), pixel(gl, 60, 4)];
  player.setSession({ world: 'device', blend: 'alpha' });
  player.draw(frame(1, eyes));
  const device = [pixel(gl, 4, 4), pixel(gl, 28, 4)];
  await player.replaceProgram({ ...first, presentation: { ...first.presentation, background: [1, 1, 0, 0.4] } });
  player.draw(frame(2, [view(0, 0, WIDTH, HEIGHT), view(WIDTH, 0, 0, HEIGHT)]));
  const colored = [pixel(gl, 4, 4), pixel(gl, 60, 4)];
  player.dispose();
  return { world, device, colored, error: gl.getError() };
}

/** Fills the left or right half of its view at a window depth, tested against what the target holds. */
function painter(red: number, half: 0 | 1): NodeModule {
  return {
    create: ({ gl }) => ({
      update: () => {},
      draw: ({ viewport: { x, y, widthPx, heightPx } }) => {
        gl.enable(gl.SCISSOR_TEST);
        gl.scissor(x + (half * widthPx) / 2, y, widthPx / 2, heightPx);
        const depth = new Float32Array(1);
        gl.clearBufferfv(gl.COLOR, 0, new Float32Array([red, 1, 0, 1]));
        // As near as can be: nothing drawn later would pass a depth test, were it not cleared.
        gl.clearBufferfv(gl.DEPTH, 0, depth);
        gl.disable(gl.SCISSOR_TEST);
      },
      dispose: () => {},
    }),
  };
}

/** Draws the whole view at half the depth, in blue, where the depth test lets it. */
const tested: NodeModule = {
  create: ({ gl }) => {
    const program = gl.createProgram();
    const sources = [
      [
        gl.VERTEX_SHADER,
        '#version 300 es\nvoid main() { gl_Position = vec4(float(gl_VertexID == 1) * 4.0 - 1.0, float(gl_VertexID == 2) * 4.0 - 1.0, 0.0, 1.0); }',
      ],
      [gl.FRAGMENT_SHADER, '#version 300 es\nprecision highp float; out vec4 color; void main() { color = vec4(0.0, 0.0, 1.0, 1.0); }'],
    ] as const;
    for (const [type, source] of sources) {
      const made = gl.createShader(type) as WebGLShader;
      gl.shaderSource(made, source);
      gl.compileShader(made);
      gl.attachShader(program, made);
    }
    gl.linkProgram(program);
    return {
      update: () => {},
      draw: () => {
        gl.useProgram(program);
        gl.enable(gl.DEPTH_TEST);
        gl.depthFunc(gl.LESS);
        gl.disable(gl.BLEND);
        gl.bindVertexArray(null);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
      },
      dispose: () => gl.deleteProgram(program),
    };
  },
};

function drawing(type: string): DrawOperation {
  const { kind: _kind, ...rest } = sourceOperation(type, 'none', 'none', { writes: [], outputs: {} });
  return { ...rest, kind: 'draw', view: 'each', target: 'screen', shadowMaps: null, occlusion: null };
}

/** Nodes that draw to the screen: each finds a depth of its own in its view, and the other view untouched. */
export async function screenDraws() {
  const gl = createGl({ depth: true });
  const modules = { left: painter(1, 0), tested, right: painter(0, 1) };
  const { player } = await stand(program({ operations: [drawing('left'), drawing('tested'), drawing('right')] }), { gl, modules });
  upset(gl);
  player.draw(frame(0, [view(0, 0, 32, HEIGHT)]));
  const result = { over: pixel(gl, 4, 4), last: pixel(gl, 28, 4), beside: pixel(gl, 40, 4), error: gl.getError() };
  player.dispose();
  return result;
}

/** Two views of different sizes do not share their targets. */
export async function unequalViews() {
  const show = 'color = vec4(vec2(textureSize(picture, 0)) / 255.0, 0.0, 1.0);';
  const { gl, player } = await stand(
    program({
      resources: [target('out')],
      shaders: [shader('fill', 'color = vec4(1.0);'), shader('show', show, PICTURE)],
      operations: [pass('fill', 0, 'out'), pass('show', 1, 'screen', { samplers: [colorSampler('picture', 'out')] })],
    }),
  );
  const unequal = [view(0, 0, 40, 30), view(40, 0, 20, 10)];
  player.draw(frame(0, unequal));
  const made = player.counts().textures;
  for (let i = 1; i < 10; i++) player.draw(frame(i, unequal));
  const shown = [pixel(gl, 1, 1), pixel(gl, 41, 1)];
  const kept = player.counts().textures === made;
  player.draw(frame(10, [view(0, 0, 20, 20), view(20, 0, 20, 20)]));
  const shared = made - player.counts().textures;
  player.dispose();
  return { shown, kept, shared, error: gl.getError() };
}
