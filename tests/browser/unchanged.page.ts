import type { PassOperation, PassUniform, Program, Resource } from '../../export/program/program.ts';
import { createPlayer, type Player } from '../../export/runtime/player.ts';
import type { OperationMonitor } from '../../export/runtime/program-instance/step.ts';
import { readColor } from '../../export/runtime/readback.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import * as cameraVideo from '../../nodes/source/camera-video/runtime.ts';
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
  target,
  texture,
  view,
  WIDTH,
} from './runtime-kit.ts';

/** Programs whose passes have nothing new to draw in most frames. Draws are counted per frame. */

const IMAGE = 'uniform sampler2D image; uniform mat3 image_uvFromViewUv;';
const SHADERS = [
  shader(
    'tint',
    'color = texture(image, (image_uvFromViewUv * vec3(uv, 1.0)).xy) * vec4(vec3(amount), 1.0);',
    `${IMAGE} uniform float amount;`,
  ),
  shader('clock', 'color = vec4(texture(image, uv).rg, fract(TIME), 1.0);', `${IMAGE} uniform float TIME;`),
];
const AMOUNT: PassUniform = { name: 'amount', type: 'float', source: { slot: 0 } };
const TIME: PassUniform = { name: 'TIME', type: 'float', source: { builtin: 'TIME' } };
const IMAGE_SIZE = { base: 'photo', width: [{ op: 'width' }], height: [{ op: 'height' }] } as const;

let version = 0;

/** Stands for an image file: two red texels, with a version of its own. */
const PHOTO: NodeModule = {
  create: ({ outputs, gl }) => {
    const [shown] = (outputs as unknown as { layer: { views: Record<string, unknown>[] } }).layer.views;
    const red = texture(gl, 2, 1, [255, 0, 0, 255, 255, 0, 0, 255]);
    return { update: () => void Object.assign(shown ?? {}, { texture: red, widthPx: 2, heightPx: 1, version }), dispose: () => {} };
  },
};

function photoProgram(operations: readonly PassOperation[], resources: readonly Resource[] = []): Program {
  return program({
    slots: { numbers: [1], texts: [], slots: [{ type: 'number', offset: 0 }], params: { 'tint.amount': 0 } },
    resources: [{ id: 'photo', kind: 'external', domain: 'image' }, ...resources],
    shaders: SHADERS,
    operations: [sourceOperation('source/image-file', 'layer', 'photo'), ...operations],
    presentation: { mode: 'composed', antialias: false, background: [0, 0, 0, 1], blend: 'alpha' },
  });
}

const tint = (id: string, from: string, to: string, more: Partial<PassOperation> = {}): PassOperation =>
  pass(id, 0, to, { samplers: [colorSampler('image', from, to === 'screen' ? 'stretch' : 'none')], uniforms: [AMOUNT], ...more });

interface Stage {
  readonly player: Player;
  readonly gl: WebGL2RenderingContext;
  /** Draws the changes of a frame. Returns the number of draw calls. */
  next(widthPx?: number): number;
}

async function stage(shown: Program, monitor?: OperationMonitor): Promise<Stage> {
  const gl = createGl();
  version = 0;
  const modules = { 'source/image-file': PHOTO, 'source/camera-video': cameraVideo };
  const assets = { load: () => Promise.reject(new Error('there is no such file')) };
  const canvas = gl.canvas as HTMLCanvasElement;
  const options = { gl, canvas, program: shown, modules, createScenes: null, assets, seed: 1, onDiagnostics: () => {} };
  const player = createPlayer(monitor ? { ...options, monitor } : options);
  await player.ready;
  let draws = 0;
  let index = 0;
  const { drawArrays } = gl;
  gl.drawArrays = (...call) => {
    draws++;
    drawArrays.apply(gl, call);
  };
  return {
    player,
    gl,
    next: (widthPx = WIDTH) => {
      draws = 0;
      player.drawChanges(frame(index++, [view(0, 0, widthPx, HEIGHT)]));
      return draws;
    },
  };
}

/** Draw calls of each frame of a filter over a photo, and the red of the canvas after it, while things change. */
export async function still() {
  const { player, gl, next } = await stage(photoProgram([tint('tint', 'photo', 'screen')]));
  const frames: Record<string, readonly [draws: number, red: number]> = {};
  const draw = (name: string, widthPx?: number) => {
    frames[name] = [next(widthPx), pixel(gl, 5, 5)[0] ?? -1];
  };
  draw('first');
  draw('same');
  player.setParam('tint', 'amount', 0.5);
  draw('param');
  draw('same after it');
  version++;
  draw('new pixels');
  draw('smaller', WIDTH / 2);
  draw('same size', WIDTH / 2);
  player.setSession({ world: 'virtual', blend: 'opaque' } as never);
  draw('other session', WIDTH / 2);
  player.reset();
  draw('after a reset', WIDTH / 2);
  player.draw(frame(100, [view(0, 0, WIDTH / 2, HEIGHT)]));
  draw('after a full draw', WIDTH / 2);
  version = -1;
  draw('without a version', WIDTH / 2);
  draw('still without one', WIDTH / 2);
  player.contextLost();
  await player.restore();
  draw('after a lost context', WIDTH / 2);
  return frames;
}

/** Draw calls per frame where a still chain is shown through a pass that reads the time. */
export async function partly() {
  const counts = async (resources: readonly Resource[]) => {
    const [first = '', second = ''] = resources.map(({ id }) => id);
    const { player, gl, next } = await stage(
      photoProgram(
        [
          tint('one', 'photo', first, { view: 'once' }),
          tint('two', first, second, { view: 'once' }),
          pass('clock', 1, 'screen', { samplers: [colorSampler('image', second, 'stretch')], uniforms: [TIME] }),
        ],
        resources,
      ),
    );
    const draws = [next(), next(), next()];
    player.setParam('tint', 'amount', 0.5);
    draws.push(next(), next());
    return { draws, red: pixel(gl, 5, 5)[0] };
  };
  const image = { domain: 'image', size: IMAGE_SIZE } as const;
  return {
    own: await counts([target('a', image), target('b', image)]),
    // A persistent image depends on earlier frames.
    persistent: await counts([target('a', image), target('b', { ...image, lifetime: 'persistent' })]),
  };
}

/** A target that two passes share does not keep the image of the first. Returns draw calls per frame and the canvas after them. */
export async function shared() {
  const image = { domain: 'image', size: IMAGE_SIZE } as const;
  const { player, gl, next } = await stage(
    photoProgram(
      [
        tint('one', 'photo', 'a', { view: 'once' }),
        tint('two', 'a', 'b', { view: 'once' }),
        tint('three', 'b', 'c', { view: 'once' }),
        pass('clock', 1, 'screen', { samplers: [colorSampler('image', 'c', 'stretch')], uniforms: [TIME] }),
      ],
      [target('a', image), target('b', image), target('c', { ...image, shares: 'a' })],
    ),
  );
  const draws = [next(), next()];
  player.setParam('tint', 'amount', 0.5);
  draws.push(next(), next());
  return { draws, red: pixel(gl, 5, 5)[0] };
}

/** Draw calls per frame of a filter over an image that is copied to the screen, while the size of the view changes, and the canvas. */
export async function direct() {
  const size = { base: 'view', width: [WIDTH], height: [HEIGHT] };
  const copy = pass('copy', 0, 'screen', {
    samplers: [colorSampler('image', 'a', 'contain')],
    uniforms: [AMOUNT],
    blend: 'over',
    copies: true,
  });
  const { player, gl, next } = await stage(
    photoProgram([tint('tint', 'photo', 'a', { view: 'once' }), copy], [target('a', { domain: 'image', size })]),
  );
  const frames: Record<string, readonly [draws: number, red: number]> = {};
  const draw = (name: string, widthPx: number) => {
    frames[name] = [next(widthPx), pixel(gl, 5, 20)[0] ?? -1];
  };
  draw('same size as the view', WIDTH);
  draw('unchanged', WIDTH);
  draw('another size', WIDTH / 2);
  player.setParam('tint', 'amount', 0.5);
  draw('a param in another size', WIDTH / 2);
  draw('the size of the view again', WIDTH);
  return frames;
}

/** The red of an image that only a viewer shows, before and after a param changes in a frame that leaves the image out. */
export async function leftOut() {
  let isViewed = true;
  const image = { domain: 'image', size: IMAGE_SIZE } as const;
  const operations = [tint('tint', 'photo', 'screen'), tint('viewed', 'photo', 'a', { view: 'once' })];
  const shown = photoProgram(operations, [target('a', image)]);
  const taps = { 'viewed.layer': { color: 'a', depth: null } };
  const monitor = { begin: ({ id }: { readonly id: string }) => isViewed || id !== 'viewed', end: () => {} };
  const { player, next } = await stage({ ...shown, taps }, monitor);
  const red = () => readColor(player.inspect('viewed.layer'), 0)?.pixels[0];
  next();
  const before = red();
  isViewed = false;
  player.setParam('tint', 'amount', 0.5);
  next();
  isViewed = true;
  player.draw(frame(100, [view(0, 0, WIDTH, HEIGHT)]));
  return { before, after: red() };
}
