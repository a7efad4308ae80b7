import { encode } from 'fast-png';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import type { LinkedSampler } from '../../export/glsl/link/linked-pass.ts';
import type { PassOperation, PassSampler, ProgramAsset } from '../../export/program/program.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import { definition as occlusion } from '../../nodes/layer/depth-occlusion/definition.ts';
import occlusionShader from '../../nodes/layer/depth-occlusion/occlusion.fs';
import * as cameraVideo from '../../nodes/source/camera-video/runtime.ts';
import * as imageFile from '../../nodes/source/image-file/runtime.ts';
import { trackGl } from '../support/gl-leaks.ts';
import {
  colorSampler,
  createGl,
  frame,
  HEIGHT,
  MEASURED_DEPTH,
  pass,
  pixel,
  program,
  shader,
  sourceOperation,
  stand,
  target,
  texture,
  view,
  WIDTH,
} from './runtime-kit.ts';

const SHOW = shader(
  'show',
  'vec2 at = (picture_uvFromViewUv * vec3(uv, 1.0)).xy; color = texture(picture, at);',
  'uniform sampler2D picture; uniform mat3 picture_uvFromViewUv;',
);

/** What the generated registry would hand a page. */
const MODULES = {
  'source/camera-video': cameraVideo,
  'source/image-file': imageFile,
  'world/depth': MEASURED_DEPTH,
} satisfies Record<string, NodeModule>;

/** The camera's picture, and what takes its place. */
export async function camera() {
  const gl = createGl();
  const leaks = trackGl(gl);
  const showing = (withoutImage: string) =>
    program({
      slots: { numbers: [1, 0.5, 0, 0.5], texts: [], slots: [{ type: 'color', offset: 0 }], params: { 'source/camera-video.color': 0 } },
      resources: [{ id: 'video', kind: 'external', domain: 'view' }],
      shaders: [SHOW],
      operations: [
        sourceOperation('source/camera-video', 'layer', 'video', { params: { color: 0 }, config: { withoutImage } }),
        pass('show', 0, 'screen', { samplers: [colorSampler('picture', 'video')] }),
      ],
    });
  const { player } = await stand(showing('transparent'), { gl, modules: MODULES });
  // Blue below, green above; the matrix turns it over.
  const picture = texture(gl, 1, 2, [0, 0, 255, 255, 0, 255, 0, 255]);
  const image = { texture: picture, widthPx: 1, heightPx: 2, uvFromViewUv: new Float32Array([1, 0, 0, 0, -1, 0, 0, 1, 1]) };
  player.draw(frame(0, [view(0, 0, WIDTH, HEIGHT, { cameraImage: image })]));
  const seen = [pixel(gl, 3, 2), pixel(gl, 3, HEIGHT - 3)];
  player.draw(frame(1));
  const transparent = pixel(gl, 3, 3);
  await player.replaceProgram(showing('color'));
  player.draw(frame(2));
  const color = pixel(gl, 3, 3);
  player.setParam('source/camera-video', 'color', [0, 0, 1, 1]);
  player.draw(frame(3));
  const changed = pixel(gl, 3, 3);
  player.dispose();
  gl.deleteTexture(picture);
  return { seen, transparent, color, changed, leaks: leaks.report(), error: gl.getError() };
}

/** A picture of two by two pixels, from the top left: red, green, half-transparent blue, nothing. */
function png(): ArrayBuffer {
  const data = Uint8Array.of(255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 200, 128, 90, 90, 90, 0);
  return new Uint8Array(encode({ width: 2, height: 2, data, depth: 8, channels: 4 })).buffer;
}

const ASSETS: readonly ProgramAsset[] = [
  { id: 'photo', kind: 'image', path: 'assets/photo.png' },
  { id: 'torn', kind: 'image', path: 'assets/torn.png' },
  { id: 'gone', kind: 'image', path: 'assets/gone.png' },
  { id: 'robot', kind: 'model', path: 'assets/robot.glb' },
];

function showing(assetId: string | null, title = 'test') {
  return program({
    title,
    resources: [{ id: 'picture', kind: 'external', domain: 'image' }],
    shaders: [SHOW],
    operations: [
      sourceOperation('source/image-file', 'layer', 'picture', { assets: { file: assetId } }),
      pass('show', 0, 'screen', { samplers: [colorSampler('picture', 'picture')] }),
    ],
    assets: ASSETS.filter((asset) => asset.id === assetId),
  });
}

/** A file is decoded once, stays while programs that use it follow each other, and goes with the last. */
export async function image() {
  const gl = createGl();
  const leaks = trackGl(gl);
  const loads: string[] = [];
  const load = async (path: string): Promise<ArrayBuffer> => {
    loads.push(path);
    return png();
  };
  const { player, diagnostics } = await stand(showing('photo'), { gl, modules: MODULES, assets: { load } });
  player.draw(frame(0));
  const corners = [pixel(gl, 1, HEIGHT - 2), pixel(gl, WIDTH - 2, HEIGHT - 2), pixel(gl, 1, 1), pixel(gl, WIDTH - 2, 1)];
  await player.replaceProgram(showing('photo', 'renamed'));
  player.draw(frame(1));
  const still = pixel(gl, 1, HEIGHT - 2);
  const before = player.counts().textures;
  await player.replaceProgram(showing(null));
  player.draw(frame(2));
  const without = pixel(gl, 1, HEIGHT - 2);
  const freed = before - player.counts().textures;
  player.dispose();
  return { corners, still, without, freed, loads, diagnostics: diagnostics(), leaks: leaks.report(), error: gl.getError() };
}

/** Assets that cannot be had are told once, at the node, and the rest plays on. */
export async function brokenAssets() {
  const told: Diagnostic[] = [];
  for (const id of ['torn', 'gone', 'robot', 'nowhere']) {
    const load = async (path: string): Promise<ArrayBuffer> => {
      if (path !== 'assets/torn.png') throw new Error('there is no such file');
      return png().slice(0, 40);
    };
    const stage = await stand(showing(id), { modules: MODULES, assets: { load } });
    stage.player.draw(frame(0));
    stage.player.draw(frame(1));
    told.push(...stage.diagnostics());
    stage.player.dispose();
  }
  return told;
}

const { output: isf } = readIsf(occlusionShader, occlusion.lowering.shader);

/** The node's own shader over a layer of red whose depth grows from left to right, before a room that grows upwards. */
export async function hide(biasM: number, softnessM: number, roomM: number[]) {
  if (!isf) throw new Error('The shader cannot be read.');
  const { output: passes } = linkIsf(isf, { node: 'occlusion' });
  const linked = passes?.[0];
  if (!linked) throw new Error('The shader cannot be linked.');
  const samplerOf = ({ name, source: from }: LinkedSampler): PassSampler => {
    if (from.kind === 'room-depth') return { name, source: { kind: 'room-depth', resource: 'room' }, fit: 'none' };
    if (from.kind === 'input-depth')
      return { name, source: { kind: 'depth', depth: { resource: 'meters', encoding: 'meters' } }, fit: 'none' };
    return { name, source: { kind: 'color', resource: 'layer' }, fit: 'none' };
  };
  const slotOf: Record<string, number> = { biasM: 0, softnessM: 1, borderPx: 2 };
  const uniforms = linked.uniforms.map(({ name, type, source: from }): PassOperation['uniforms'][number] => ({
    name,
    type,
    source: 'builtin' in from ? from : { slot: 'param' in from ? (slotOf[from.param] ?? -1) : -1 },
  }));
  const hiding = program({
    slots: {
      numbers: [biasM, softnessM, 0],
      texts: [],
      slots: [0, 1, 2].map((offset) => ({ type: 'number' as const, offset })),
      params: {},
    },
    resources: [target('layer'), target('meters', { format: 'r32f' }), { id: 'room', kind: 'room-depth' }],
    shaders: [shader('red', 'color = vec4(1.0, 0.0, 0.0, 1.0);'), shader('meters', 'color = vec4(floor(uv.x * 4.0));'), linked.shader],
    operations: [
      sourceOperation('world/depth', 'depth', 'room'),
      pass('red', 0, 'layer'),
      pass('meters', 1, 'meters'),
      pass('hide', 2, 'screen', { samplers: linked.samplers.map(samplerOf), uniforms }),
    ],
  });
  const { gl, player } = await stand(hiding, { modules: MODULES });
  const room = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, room);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, 1, roomM.length, 0, gl.RED, gl.FLOAT, new Float32Array(roomM));
  const depth = {
    texture: room,
    widthPx: 1,
    heightPx: roomM.length,
    uvFromViewUv: new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 1]),
    worldFromDepth: new Float32Array(16),
  };
  player.draw(frame(0, [view(0, 0, WIDTH, HEIGHT, { depth })]));
  const rows = roomM.map((_, row) =>
    [0, 1, 2, 3].map((column) => pixel(gl, column * (WIDTH / 4) + 4, Math.floor(((row + 0.5) / roomM.length) * HEIGHT))),
  );
  player.draw(frame(1));
  const unknown = pixel(gl, WIDTH - 4, 4);
  player.dispose();
  return {
    alphas: rows.map((row) => row.map((rgba) => rgba[3])),
    reds: rows.map((row) => row.map((rgba) => rgba[0])),
    unknown,
    error: gl.getError(),
  };
}
