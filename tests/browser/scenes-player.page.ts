import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import type { DrawOperation, NodeOperation, Program, ShadowMapOperation, Slot } from '../../export/program/program.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { NodeDefinition, ParamDefinition, ParamValue } from '../../nodes/kit/definition.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import { VALUE_SIZES } from '../../nodes/kit/wire-types.ts';
import { definition as occlusionDefinition } from '../../nodes/layer/depth-occlusion/definition.ts';
import occlusionSource from '../../nodes/layer/depth-occlusion/occlusion.fs';
import { definition as sceneDefinition } from '../../nodes/layer/scene/definition.ts';
import * as sceneLayer from '../../nodes/layer/scene/runtime.ts';
import { definition as shadowDefinition } from '../../nodes/layer/shadow/definition.ts';
import * as shadowLayer from '../../nodes/layer/shadow/runtime.ts';
import { definition as lightDefinition } from '../../nodes/light/directional/definition.ts';
import * as light from '../../nodes/light/directional/runtime.ts';
import { definition as phantomDefinition } from '../../nodes/objects/phantom/definition.ts';
import * as phantom from '../../nodes/objects/phantom/runtime.ts';
import { definition as primitiveDefinition } from '../../nodes/objects/primitive/definition.ts';
import * as primitive from '../../nodes/objects/primitive/runtime.ts';
import { definition as transformDefinition } from '../../nodes/objects/transform/definition.ts';
import * as transform from '../../nodes/objects/transform/runtime.ts';
import { definition as modelDefinition } from '../../nodes/source/model/definition.ts';
import * as model from '../../nodes/source/model/runtime.ts';
import { definition as roomDefinition } from '../../nodes/world/depth/definition.ts';
import * as roomDepth from '../../nodes/world/depth/runtime.ts';
import { trackGl } from '../support/gl-leaks.ts';
import { colorSampler, frame, pass, program, shader, stand, target, texture } from './runtime-kit.ts';
import { covered, createGl, difference, HEIGHT, lookingAt, pixel, project, readPixels, room, viewOf, WIDTH } from './scenes-kit.ts';

const MODULES = {
  'layer/scene': sceneLayer,
  'layer/shadow': shadowLayer,
  'light/directional': light,
  'objects/phantom': phantom,
  'objects/primitive': primitive,
  'objects/transform': transform,
  'source/model': model,
  'world/depth': roomDepth,
} satisfies Record<string, NodeModule>;

/** Lays out slots and writes node operations from definitions, as the compiler does. */
function createBuilder() {
  const numbers: number[] = [];
  const texts: string[] = [];
  const slots: Slot[] = [];
  const params: Record<string, number> = {};
  const slot = (node: string, name: string, { type }: ParamDefinition, value: ParamValue): number => {
    const kind = type === 'choice' || type === 'asset' || type === 'curve' || type === 'gradient' ? 'number' : type;
    if (kind === 'text') {
      slots.push({ type: 'text', offset: texts.push(String(value)) - 1 });
    } else {
      slots.push({ type: kind, offset: numbers.length });
      const list = Array.isArray(value) ? (value as number[]) : [Number(value)];
      for (let i = 0; i < VALUE_SIZES[kind]; i++) numbers.push(list[i] ?? 0);
    }
    params[`${node}.${name}`] = slots.length - 1;
    return slots.length - 1;
  };
  /** An operation of the node type: what the wires bring, and params other than the defaults. */
  const node = (
    id: string,
    definition: NodeDefinition,
    wires: Readonly<Record<string, readonly string[]>> = {},
    values: Readonly<Record<string, ParamValue>> = {},
  ): NodeOperation => {
    const ofStage = <T>(stage: string, make: (name: string, param: ParamDefinition, value: ParamValue) => T): Record<string, T> =>
      Object.fromEntries(
        Object.entries(definition.params)
          .filter(([, param]) => param.stage === stage)
          .map(([name, param]) => [name, make(name, param, values[name] ?? param.default)]),
      );
    const made = Object.keys(definition.outputs).filter((port) => !definition.outputs[port]?.whenRead);
    const draws = made.some((port) => definition.outputs[port]?.type === 'layer');
    const outputs = draws ? {} : Object.fromEntries(made.map((port) => [port, `${id}.${port}`]));
    return {
      id,
      node: id,
      kind: 'geometry',
      type: definition.type,
      view: 'once',
      reads: Object.values(wires).flat(),
      writes: Object.values(outputs),
      inputs: Object.fromEntries(
        Object.keys(definition.inputs).map((port) => [
          port,
          (wires[port] ?? []).map((resource) => ({ kind: 'resource', resource }) as const),
        ]),
      ),
      multiple: Object.keys(definition.inputs).filter((port) => definition.inputs[port]?.multiple),
      outputs: Object.fromEntries(Object.entries(outputs).map(([port, resource]) => [port, { kind: 'resource', resource } as const])),
      params: ofStage('uniform', (name, param, value) => slot(id, name, param, value)),
      config: ofStage('structure', (_name, _param, value) => value as string),
      assets: ofStage('asset', (_name, _param, value) => (value === '' ? null : String(value))),
    };
  };
  return { node, table: () => ({ numbers, texts, slots, params }) };
}

function drawn(operation: NodeOperation, to: string, shadowMaps: string | null): DrawOperation {
  return { ...operation, kind: 'draw', view: 'each', writes: [to], target: to, shadowMaps, occlusion: null };
}

function shadowMaps(id: string, casters: string[], lights: string[]): ShadowMapOperation {
  return { kind: 'shadow-maps', id, node: id, view: 'once', reads: [...casters, ...lights], writes: [id], casters, lights };
}

/** Azimuths of lights 45 degrees up. */
const FROM_LEFT = -Math.PI / 2;
const FROM_RIGHT = Math.PI / 2;

/** A red box on a phantom floor, its shadow under it in a layer of its own, both over green. */
function boxOnFloor(color: readonly number[], azimuthsRad: readonly number[] = [FROM_LEFT]): Program {
  const { node, table } = createBuilder();
  const suns = azimuthsRad.map((azimuthRad, i) => node(`sun${i}`, lightDefinition, {}, { azimuthRad, elevationRad: Math.PI / 4 }));
  const lights = suns.map(({ id }) => `${id}.lights`);
  const operations = [
    node('box', primitiveDefinition, {}, { sizeM: [0.4, 0.4, 0.4], color, roughness: 1 }),
    node('up', transformDefinition, { objects: ['box.objects'] }, { positionM: [0, 0.2, 0] }),
    node('plane', primitiveDefinition, {}, { shape: 'plane', sizeM: [5, 0, 5] }),
    node('floor', phantomDefinition, { objects: ['plane.objects'] }),
    ...suns,
    shadowMaps('maps', ['up.objects'], lights),
    drawn(
      node('shadow', shadowDefinition, { casters: ['up.objects'], receivers: ['floor.objects'], lights }, { strength: 1 }),
      'shadow.layer',
      'maps',
    ),
    drawn(node('scene', sceneDefinition, { objects: ['up.objects', 'floor.objects'], lights }, { ambient: 0 }), 'scene.layer', 'maps'),
    pass('merge', 0, 'screen', { samplers: [colorSampler('below', 'shadow.layer'), colorSampler('above', 'scene.layer')] }),
  ];
  const objects = ['box.objects', 'up.objects', 'plane.objects', 'floor.objects'];
  return program({
    slots: table(),
    shaders: [
      shader(
        'merge',
        'vec4 over = texture(above, uv); vec4 under = texture(below, uv); under += vec4(0.0, 1.0, 0.0, 1.0) * (1.0 - under.a); color = over + under * (1.0 - over.a);',
        'uniform sampler2D above, below;',
      ),
    ],
    resources: [
      ...objects.map((id) => ({ id, kind: 'objects' }) as const),
      ...lights.map((id) => ({ id, kind: 'lights' }) as const),
      { id: 'maps', kind: 'shadow-maps' },
      target('shadow.layer', { depth: 'window' }),
      target('scene.layer', { depth: 'window' }),
    ],
    operations,
  });
}

const CAMERA = lookingAt([0, 1.5, 1.5], [0, 0, 0]);
const POINTS = { boxTop: [0, 0.4, 0], shadow: [0.4, 0, 0], floor: [-0.5, 0, 0.2] } as const;

/** Two layers of scenes through the player: drawn, changed by a param, replaced, and gone without a trace. */
export async function plays() {
  const gl = createGl();
  const tracker = trackGl(gl);
  const { player, diagnostics } = await stand(boxOnFloor([1, 0, 0, 1]), { gl, modules: MODULES, createScenes });
  let index = 0;
  const look = (): Record<string, number[]> => {
    player.draw(frame(index++, [viewOf(CAMERA)], { framebufferWidthPx: WIDTH, framebufferHeightPx: HEIGHT }));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const pixels = readPixels(gl, WIDTH, HEIGHT);
    return Object.fromEntries(Object.entries(POINTS).map(([name, point]) => [name, pixel(pixels, ...project(CAMERA, point))]));
  };
  const first = look();
  player.setParam('box', 'color', [0, 0, 0, 1]);
  player.setParam('shadow', 'strength', 0);
  const changed = look();
  const before = player.counts();
  await player.replaceProgram(boxOnFloor([1, 0, 0, 1]));
  const replaced = look();
  const after = player.counts();
  player.dispose();
  return {
    first,
    changed,
    replaced,
    same: JSON.stringify(before) === JSON.stringify(after),
    diagnostics: diagnostics(),
    alive: tracker.alive(),
    error: gl.getError(),
  };
}

/** Two lights on wires of their own: what the floor shows on either side of the box, and beside both shadows. */
export async function twoLights() {
  const gl = createGl();
  const { player } = await stand(boxOnFloor([1, 0, 0, 1], [FROM_LEFT, FROM_RIGHT]), { gl, modules: MODULES, createScenes });
  player.draw(frame(0, [viewOf(CAMERA)], { framebufferWidthPx: WIDTH, framebufferHeightPx: HEIGHT }));
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const pixels = readPixels(gl, WIDTH, HEIGHT);
  const greenAt = (x: number, z: number): number | undefined => pixel(pixels, ...project(CAMERA, [x, 0, z]))[1];
  const seen = { right: greenAt(0.4, 0), left: greenAt(-0.4, 0), front: greenAt(0, 0.5) };
  player.dispose();
  return seen;
}

/** A model that cannot be read is told at its node, and the rest is drawn. */
export async function brokenModel() {
  const { node, table } = createBuilder();
  const bytes = new TextEncoder().encode('glTF\u0002\0\0\0').buffer as ArrayBuffer;
  const { player, diagnostics } = await stand(
    program({
      slots: table(),
      assets: [{ id: 'fox', kind: 'model', path: 'assets/fox.glb' }],
      resources: [{ id: 'fox.objects', kind: 'objects' }, target('scene.layer', { depth: 'window' })],
      operations: [
        node('fox', modelDefinition, {}, { model: 'fox' }),
        drawn(node('scene', sceneDefinition, { objects: ['fox.objects'] }), 'scene.layer', null),
      ],
    }),
    { gl: createGl(), modules: MODULES, createScenes, assets: { load: () => Promise.resolve(bytes) } },
  );
  player.draw(frame(0, [viewOf(CAMERA)]));
  const told = diagnostics();
  player.dispose();
  return told;
}

const FACING = lookingAt([0, 0, 2], [0, 0, 0]);

/** Overlapping, self-overlapping and intersecting opaque things, hidden while they are drawn or after. */
function hidden(
  form: 'early' | 'late',
  params: Readonly<Record<string, number>>,
  roomParams: Readonly<Record<string, ParamValue>>,
): Program {
  const { node, table } = createBuilder();
  const thing = (id: string, shape: string, positionM: readonly number[], color: readonly number[], size: number): NodeOperation[] => [
    node(`${id}-shape`, primitiveDefinition, {}, { shape, sizeM: [size, size, size], color }),
    node(id, transformDefinition, { objects: [`${id}-shape.objects`] }, { positionM, rotationRad: [0.5, 0.4, 0] }),
  ];
  const things = [
    ...thing('ring', 'torus', [-0.3, 0.1, 0], [0.8, 0.3, 0.2, 1], 1),
    ...thing('box', 'box', [0.3, -0.2, -0.2], [0.2, 0.3, 0.8, 1], 0.7),
    ...thing('ball', 'sphere', [0.2, 0.3, 0.2], [0.3, 0.8, 0.2, 1], 0.8),
    ...thing('back', 'box', [0, 0, -1.2], [0.5, 0.5, 0.5, 1], 1.6),
    ...thing('cone', 'cone', [-0.1, -0.2, 0.3], [1, 1, 1, 1], 0.4),
  ];
  const phantoms = node('ghost', phantomDefinition, { objects: ['cone.objects'] });
  const scene = node('scene', sceneDefinition, {
    objects: ['ring.objects', 'box.objects', 'ball.objects', 'back.objects', 'ghost.objects'],
    lights: ['sun.lights'],
  });
  const occlusion = node('hide', occlusionDefinition, {}, params);
  const [linked] = linkIsf(readIsf(occlusionSource, 'occlusion.fs').output as never, { node: 'hide' }).output ?? [];
  if (!linked) throw new Error('occlusion.fs does not link');
  const sources = {
    input: { kind: 'color', resource: 'scene.layer' },
    'input-depth': { kind: 'depth', depth: { resource: 'scene.layer', encoding: 'window' } },
    'room-depth': { kind: 'room-depth', resource: 'room.depth' },
  } as const;
  const late = pass('hide', 0, 'screen', {
    samplers: linked.samplers.map(({ name, source }) => ({ name, source: sources[source.kind as keyof typeof sources], fit: 'none' })),
    uniforms: linked.uniforms.map(({ name, type, source }) => ({
      name,
      type,
      source: 'builtin' in source ? source : { slot: 'param' in source ? (occlusion.params[source.param] ?? -1) : -1 },
    })),
  });
  const early: DrawOperation = {
    ...drawn(scene, 'screen', null),
    writes: [],
    occlusion: { node: 'hide', roomDepth: 'room.depth', params: occlusion.params },
  };
  const objects = [...things, phantoms].flatMap((operation) => operation.writes);
  return program({
    slots: table(),
    shaders: [linked.shader],
    resources: [
      ...objects.map((id) => ({ id, kind: 'objects' }) as const),
      { id: 'sun.lights', kind: 'lights' },
      { id: 'room.depth', kind: 'room-depth' },
      target('scene.layer', { depth: 'window' }),
    ],
    operations: [
      ...things,
      phantoms,
      node('sun', lightDefinition),
      node('room', roomDefinition, {}, roomParams),
      ...(form === 'early' ? [early] : [drawn(scene, 'scene.layer', null), late]),
    ],
  });
}

/** The occlusion's shader over a finished layer, and the same params sunk into the draw, through a slanted room with holes. */
export async function equalForms(params: Readonly<Record<string, number>>, roomParams: Readonly<Record<string, ParamValue>> = {}) {
  const pictures: Uint8Array[] = [];
  const errors: number[] = [];
  for (const form of ['early', 'late'] as const) {
    const gl = createGl();
    // From 1.2 m on the left to 2.6 m on the right, coarse, turned a little, and reaching beyond the view's edges.
    const meters = Array.from({ length: 20 * 15 }, (_, i) => (i % 17 === 0 ? 0 : 1.2 + ((i % 20) / 19) * 1.4));
    const left = room(gl, 20, 15, meters, [0.95, 0.1, 0, -0.1, 0.95, 0, 0.12, -0.03, 1]);
    // Of the other eye: turned a quarter and cut.
    const right = room(gl, 20, 15, meters, [0, 0.8, 0, -0.9, 0, 0, 0.95, 0.1, 1]);
    const cameraImage = { texture: texture(gl, 2, 2, STRIPES), widthPx: 2, heightPx: 2, uvFromViewUv: UPRIGHT };
    const half = { y: 0, widthPx: WIDTH / 2, heightPx: HEIGHT };
    const { player } = await stand(hidden(form, params, roomParams), { gl, modules: MODULES, createScenes });
    const views = [
      { ...viewOf(FACING, { x: 0, ...half }), depth: left, cameraImage },
      { ...viewOf(FACING, { x: WIDTH / 2, ...half }), depth: right, cameraImage },
    ];
    for (const index of [0, 1]) player.draw(frame(index, views, { framebufferWidthPx: WIDTH, framebufferHeightPx: HEIGHT }));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    pictures.push(readPixels(gl, WIDTH, HEIGHT));
    player.dispose();
    errors.push(gl.getError());
  }
  const [early = new Uint8Array(), late = new Uint8Array()] = pictures;
  // One of sixteen places of a soft border is 16 levels.
  return { ...difference(early, late), apart: difference(early, late, 17).pixels, covered: covered(late), errors };
}

const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
const STRIPES = [200, 0, 0, 255, 0, 90, 0, 255, 200, 0, 0, 255, 0, 90, 0, 255];

export interface Example {
  readonly program: Program;
  readonly assetUrl: string;
}

/** Plays compiled examples one after the other; tells of each how much of the picture it covers, and in how many colors. */
export async function playExamples(examples: readonly Example[]) {
  const gl = createGl();
  const camera = lookingAt([0.3, 1, 0.8], [0, 0.3, -1]);
  let assetUrl = '';
  const load = async (path: string): Promise<ArrayBuffer> => (await fetch(`${assetUrl}${path}`)).arrayBuffer();
  const { player, diagnostics } = await stand(program({}), { gl, modules: RUNTIMES, createScenes, assets: { load } });
  const seen = [];
  for (const example of examples) {
    assetUrl = example.assetUrl;
    await player.replaceProgram(example.program);
    player.draw(frame(seen.length, [viewOf(camera)], { framebufferWidthPx: WIDTH, framebufferHeightPx: HEIGHT }));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const pixels = readPixels(gl, WIDTH, HEIGHT);
    const colors = new Set<string>();
    for (let i = 0; i < pixels.length; i += 4) colors.add(pixels.slice(i, i + 4).join());
    seen.push({ covered: covered(pixels), colors: colors.size, diagnostics: diagnostics(), error: gl.getError() });
  }
  player.dispose();
  return seen;
}
