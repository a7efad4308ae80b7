import type { DrawOperation, NodeOperation, Program, ShadowMapOperation, Slot } from '../../export/program/program.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import type { NodeDefinition, ParamDefinition } from '../../nodes/kit/definition.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import { VALUE_SIZES } from '../../nodes/kit/wire-types.ts';
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
import { trackGl } from '../support/gl-leaks.ts';
import { colorSampler, frame, pass, program, shader, stand, target } from './runtime-kit.ts';
import { createGl, HEIGHT, lookingAt, pixel, project, readPixels, viewOf, WIDTH } from './scenes-kit.ts';

const MODULES = {
  'layer/scene': sceneLayer,
  'layer/shadow': shadowLayer,
  'light/directional': light,
  'objects/phantom': phantom,
  'objects/primitive': primitive,
  'objects/transform': transform,
  'source/model': model,
} satisfies Record<string, NodeModule>;

type Value = number | boolean | string | readonly number[];

/** Lays out slots and writes node operations from definitions, as the compiler does. */
function createBuilder() {
  const numbers: number[] = [];
  const texts: string[] = [];
  const slots: Slot[] = [];
  const params: Record<string, number> = {};
  const slot = (node: string, name: string, { type }: ParamDefinition, value: Value): number => {
    const kind = type === 'choice' || type === 'asset' ? 'number' : type;
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
    values: Readonly<Record<string, Value>> = {},
  ): NodeOperation => {
    const ofStage = <T>(stage: string, make: (name: string, param: ParamDefinition, value: Value) => T): Record<string, T> =>
      Object.fromEntries(
        Object.entries(definition.params)
          .filter(([, param]) => param.stage === stage)
          .map(([name, param]) => [name, make(name, param, values[name] ?? param.default)]),
      );
    const draws = Object.values(definition.outputs).some(({ type }) => type === 'layer');
    const outputs = draws ? {} : Object.fromEntries(Object.keys(definition.outputs).map((port) => [port, `${id}.${port}`]));
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

function shadowMaps(id: string, casters: string[], lights: string): ShadowMapOperation {
  return { kind: 'shadow-maps', id, node: id, view: 'once', reads: [...casters, lights], writes: [id], casters, lights };
}

/** A red box on a phantom floor, its shadow under it in a layer of its own, both over green. */
function boxOnFloor(color: readonly number[]): Program {
  const { node, table } = createBuilder();
  const operations = [
    node('box', primitiveDefinition, {}, { sizeM: [0.4, 0.4, 0.4], color, roughness: 1 }),
    node('up', transformDefinition, { objects: ['box.objects'] }, { positionM: [0, 0.2, 0] }),
    node('plane', primitiveDefinition, {}, { shape: 'plane', sizeM: [5, 0, 5] }),
    node('floor', phantomDefinition, { objects: ['plane.objects'] }),
    // From the left, 45 degrees up.
    node('sun', lightDefinition, {}, { azimuthRad: -Math.PI / 2, elevationRad: Math.PI / 4 }),
    shadowMaps('maps', ['up.objects'], 'sun.lights'),
    drawn(
      node('shadow', shadowDefinition, { casters: ['up.objects'], receivers: ['floor.objects'], lights: ['sun.lights'] }, { strength: 1 }),
      'shadow.layer',
      'maps',
    ),
    drawn(
      node('scene', sceneDefinition, { objects: ['up.objects', 'floor.objects'], lights: ['sun.lights'] }, { ambient: 0 }),
      'scene.layer',
      'maps',
    ),
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
      { id: 'sun.lights', kind: 'lights' },
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
