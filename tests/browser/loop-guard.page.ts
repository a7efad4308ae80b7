import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import type { LinkedShader, PassOperation, PassSampler, PassUniform, Program, Resource } from '../../export/program/program.ts';
import { trackGl } from '../support/gl-leaks.ts';
import { colorSampler, createGl, frame, HEIGHT, pass, pixel, program, shader, stand, target, WIDTH } from './runtime-kit.ts';

/** A file as the preview links it, and how its only pass is bound: its image to `picture`, its params to slots in order. */
function bounded(source: string): { readonly shader: LinkedShader; readonly samplers: PassSampler[]; readonly uniforms: PassUniform[] } {
  const { output } = readIsf(source, 'shaders/looped.fs');
  const [linked] = (output && linkIsf(output, { node: 'looped', loopBudget: true }).output) ?? [];
  if (!linked) throw new Error('The shader cannot be linked.');
  let slot = 0;
  return {
    shader: linked.shader,
    samplers: linked.samplers.map(({ name }) => colorSampler(name, 'picture')),
    uniforms: linked.uniforms.map(({ name, type, source: from }) => ({
      name,
      type,
      source: 'builtin' in from ? from : { slot: slot++ },
    })),
  };
}

/** A blue picture → the file → a second pass of the same node, which halves what it gets → the screen. */
function behind(source: string, value: number): Program {
  const { shader: looped, samplers, uniforms } = bounded(source);
  const operations: PassOperation[] = [
    pass('fill', 0, 'picture'),
    pass('looped.a', 1, 'between', { node: 'looped', samplers, uniforms }),
    pass('looped.b', 2, 'screen', { node: 'looped', samplers: [colorSampler('picture', 'between')] }),
  ];
  const resources: Resource[] = [target('picture'), target('between')];
  return program({
    slots: { numbers: [value], texts: [], slots: [{ type: 'number', offset: 0 }], params: { 'looped.n': 0 } },
    resources,
    operations,
    shaders: [
      shader('fill', 'color = vec4(0.0, 0.0, 1.0, 1.0);'),
      looped,
      shader('halve', 'color = vec4(texture(picture, uv).rgb * 0.5, 1.0);', 'uniform sampler2D picture;'),
    ],
  });
}

const HEAD = '/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }, { "NAME": "n", "TYPE": "long", "DEFAULT": 1 }] }*/';

/** Green, unless the picture it gets is not blue. */
const COUNTING = `${HEAD}
void main() {
  int rounds = 0;
  for (int i = 0; i < n; i++) rounds += 1;
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = rounds >= 0 && c.b == 1.0 ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
}`;

const ENDLESS = `${HEAD}
float f(float x) {
  while (x > -1.0) { x += fract(x); }
  return x;
}
void main() {
  gl_FragColor = IMG_THIS_PIXEL(inputImage) * f(TIME);
}`;

/** Its count is constant. */
const COUNTED = COUNTING.replace('i < n; i++) rounds += 1;', 'i < 150; i++) for (int j = 0; j < 200; j++) rounds += 1;').replace(
  'rounds >= 0',
  'rounds == 30000',
);

/** The GPU answers within a few frames where it is not starved. */
const PATIENCE_FRAMES = 2500;

/** Draws until what the GPU found has been told; the number of the next frame. */
async function drawUntil(player: Awaited<ReturnType<typeof stand>>['player'], from: number, done: () => boolean): Promise<number> {
  for (let i = from; i < from + PATIENCE_FRAMES; i++) {
    player.draw(frame(i));
    if (done()) return i + 1;
    await new Promise((resolve) => requestAnimationFrame(resolve));
  }
  throw new Error(`Nothing was told in ${PATIENCE_FRAMES} frames.`);
}

/** An endless loop: never drawn in full, told on its line, and gone with another shader. */
export async function endless() {
  const { gl, player, diagnostics } = await stand(behind(ENDLESS, 1));
  player.draw(frame(0));
  const first = pixel(gl, 3, 3);
  await drawUntil(player, 1, () => diagnostics().length > 0);
  const told = diagnostics();
  player.draw(frame(300));
  const bypassed = pixel(gl, WIDTH - 1, HEIGHT - 1);
  // The same shader in another program goes on being known.
  await player.replaceProgram({ ...behind(ENDLESS, 1), title: 'other' });
  player.draw(frame(301));
  const stillTold = diagnostics();
  const stillBypassed = pixel(gl, 3, 3);
  await player.replaceProgram(behind(COUNTING, 10));
  player.draw(frame(302));
  const mended = pixel(gl, 3, 3);
  const taken = diagnostics();
  player.dispose();
  return { first, told, bypassed, stillTold: stillTold.length, stillBypassed, mended, taken, error: gl.getError() };
}

/** A loop that a param makes too long, and short again. */
export async function tooLong() {
  const { gl, player, diagnostics } = await stand(behind(COUNTING, 4000));
  player.draw(frame(0));
  const heavy = pixel(gl, 3, 3);
  player.setParam('looped', 'n', 1_000_000);
  player.draw(frame(1));
  const atOnce = pixel(gl, 3, 3);
  const next = await drawUntil(player, 2, () => diagnostics().length > 0);
  player.setParam('looped', 'n', 50);
  const back = await drawUntil(player, next, () => diagnostics().length === 0);
  player.draw(frame(back));
  const again = pixel(gl, 3, 3);
  player.dispose();
  return { heavy, atOnce, again, error: gl.getError() };
}

/** Long loops with a constant count: drawn from the first frame on, and reported. */
export async function counted() {
  const { gl, player, diagnostics } = await stand(behind(COUNTED, 1));
  player.draw(frame(0));
  const first = pixel(gl, 3, 3);
  const next = await drawUntil(player, 1, () => diagnostics().length > 0);
  const told = diagnostics();
  player.draw(frame(next));
  const on = pixel(gl, 3, 3);
  await player.replaceProgram(behind(COUNTING, 10));
  player.draw(frame(next + 1));
  const taken = diagnostics();
  player.dispose();
  return { first, on, told, taken, error: gl.getError() };
}

/** Nothing of it is left with the player, though an answer was on its way. */
export async function leavesNothing() {
  const gl = createGl();
  const leaks = trackGl(gl);
  const { player } = await stand(behind(ENDLESS, 1), { gl });
  player.draw(frame(0));
  player.dispose();
  return leaks.report();
}

/** Without bounded loops there is no probe. */
export async function withoutLoops() {
  const { player } = await stand(program({ shaders: [shader('fill', 'color = vec4(1.0);')], operations: [pass('fill', 0, 'screen')] }));
  player.draw(frame(0));
  const { framebuffers, programs } = player.counts();
  player.dispose();
  return { framebuffers, programs };
}
