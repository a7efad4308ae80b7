import { describe, expect, test } from '@jest/globals';
import { AnimationClip, BoxGeometry, Group, Matrix4, Mesh, MeshStandardMaterial, type Object3D, VectorKeyframeTrack } from 'three';
import { createRandom } from '../../export/runtime/random.ts';
import type { PulseQueue } from '../../export/runtime/values/pulses.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { type NodeDefinition, type ParamDefinition, type ParamValue, paramWireType } from '../../nodes/kit/definition.ts';
import { HAND_JOINTS, jointIndex } from '../../nodes/kit/hand-joints.ts';
import { createHit, type Hit, type HitRecord } from '../../nodes/kit/hit-test.ts';
import { createPose, type PoseView, writePose } from '../../nodes/kit/pose.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { ObjectList } from '../../nodes/kit/scene-lists.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import { LIBRARY } from '../support/library.ts';
import { fakeContext, pulseNumbers } from '../support/node-context.ts';
import { FIXED, IN_BROWSERS, SHOWING, SHOWN_ELSEWHERE } from './stateful-cases.ts';

/**
 * Every node type is played twice, once from frame 0 and once from frame 14, with inputs that change in every frame, and compared at
 * frame 15: what differs has to be declared stateful, and what is declared stateful has to differ.
 */
const LAST = 15;
const RATE_HZ = 10;

/** The first of the frames that are played before a reset. */
const OTHERS = 100;

const TYPES = Object.keys(RUNTIMES).filter((type) => {
  const module = RUNTIMES[type];
  return module !== undefined && 'create' in module && LIBRARY.definition(type) !== undefined && !IN_BROWSERS.includes(type);
});

function definitionOf(type: string): NodeDefinition {
  const definition = LIBRARY.definition(type);
  if (!definition) throw new Error(`There is no ${type}.`);
  return definition;
}

/** In [0, 1), of no pattern that a node could have. */
function chance(frame: number, salt: number): number {
  const wave = Math.sin(frame * 12.9898 + salt * 78.233) * 43758.5453;
  return wave - Math.floor(wave);
}

function valueAt(param: ParamDefinition, frame: number, salt: number): ParamValue {
  const between = (min: number, max: number, more = 0) => min + (max - min) * chance(frame, salt + more);
  switch (param.type) {
    case 'number':
      return between(Math.max(param.min ?? -2, -10), Math.min(param.max ?? 2, 10));
    case 'vector2':
    case 'vector3':
    case 'vector4':
      return param.default.map((_, i) => between(param.min?.[i] ?? -2, param.max?.[i] ?? 2, i));
    case 'color':
      return param.default.map((_, i) => between(0, 1, i));
    case 'toggle':
      return chance(frame, salt) < 0.5;
    case 'text':
      return `text ${frame}`;
    case 'choice':
      return param.options[Math.floor(chance(frame, salt) * param.options.length)]?.value ?? param.default;
    case 'curve':
    case 'gradient':
    case 'asset':
      return param.default as ParamValue;
  }
}

function objectList(): ObjectList {
  const root = new Mesh(new BoxGeometry(), new MeshStandardMaterial());
  const item = { key: 'box', root, worldFromObject: new Matrix4(), role: 'virtual' as const, castsShadow: true, receivesShadow: true };
  return { version: 1, items: [item] };
}

function model() {
  const clip = new AnimationClip('rise', 2, [new VectorKeyframeTrack('part.position', [0, 2], [0, 0, 0, 0, 2, 0])]);
  const part = () => Object.assign(new Mesh(new BoxGeometry()), { name: 'part' });
  return { instantiate: () => new Group().add(part()), clips: [clip] };
}

function controller(frame: number, last: number, salt: number) {
  const pressed = (more: number) => chance(frame, salt + more) < 0.5;
  return {
    connected: true,
    stick: Float32Array.of(chance(frame, salt), chance(frame, salt + 1)),
    // Within the hysteresis two frames ago, pulled before that.
    trigger: frame === last - 2 ? 1 : frame === last - 1 ? 0.45 : frame === last ? 0.6 : 0,
    squeeze: chance(frame, salt + 2),
    primary: pressed(3),
    secondary: pressed(4),
    stickPressed: pressed(5),
    worldFromRay: new Float32Array(16).fill(frame),
    worldFromGrip: null,
    haptics: null,
  };
}

/** Its tips of thumb and index finger touch two frames before the last, and are within the hysteresis of a pinch in the next one. */
function hand(frame: number, last: number) {
  const worldFromJoints = new Float32Array(16 * HAND_JOINTS.length).map((_, i) => ((i % 16) % 5 === 0 ? 1 : 0));
  worldFromJoints[16 * jointIndex('index-finger-tip') + 12] = frame === last - 2 ? 0.005 : frame === last - 1 ? 0.02 : 0.1;
  return { tracked: true, worldFromJoints, radiiM: new Float32Array(HAND_JOINTS.length) };
}

/** Each is there for two frames. */
function pointer(frame: number, salt = 0) {
  const pose = new Float32Array(16).map((_, i) => (i % 5 === 0 ? 1 : chance(frame, i + salt)));
  return {
    id: 1 + Math.floor(frame / 2),
    by: 'left',
    worldFromRay: pose,
    worldFromGrip: pose,
    pinch: chance(frame, 50),
    tapped: false,
    owner: null,
  };
}

/** A hit that changes in every frame, and is not there in every third. */
function hits(frame: number) {
  const { id, worldFromRay } = pointer(frame);
  const hit = { ...createHit(), distanceM: frame, worldFromHit: worldFromRay, pointer: id };
  return { count: frame % 3 === 0 ? 0 : 1, at: () => hit };
}

const TONE = Float32Array.from({ length: 48_000 }, (_, i) => chance(i, 5));

/** One plane that stays and changes, one that comes and goes. */
function surfaces(frame: number) {
  const surface = (id: string, size: number) => ({
    id,
    version: frame,
    label: '',
    worldFromSurface: new Float32Array(16).map((_, i) => (i % 5 === 0 ? 1 : chance(frame, i))),
    orientation: 'horizontal' as const,
    outlineXZ: Float32Array.of(0, 0, size, 0, size, size, 0, size),
    positions: Float32Array.of(0, 0, 0, size, 0, 0, 0, 0, size),
    indices: Uint32Array.of(0, 1, 2),
  });
  const found = [surface('stays', 1 + chance(frame, 1)), ...(frame % 2 === 1 ? [surface('goes', 1)] : [])];
  return { planes: found, meshes: found };
}

function sessionFrame(frame: number, first: number, last: number): SessionFrame {
  const picture = { texture: `picture ${frame}`, widthPx: 4 + frame, heightPx: 3, uvFromViewUv: new Float32Array(9).fill(frame) };
  const tapped = frame % 5 === 2;
  const phase = tapped ? 'start' : frame % 5 === 3 ? 'end' : 'hover';
  return {
    index: frame,
    timeS: frame / RATE_HZ,
    deltaS: frame === first ? 0 : 1 / RATE_HZ,
    viewCount: 1,
    views: [
      {
        eye: 'none',
        worldFromView: pointer(frame).worldFromRay,
        viewFromWorld: pointer(frame, 1).worldFromRay,
        clipFromView: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0),
        nearM: 0.1,
        viewport: { x: 0, y: 0, widthPx: 320, heightPx: 240 },
        cameraImage: picture,
        depth: { ...picture, texture: `depth ${frame}` },
      },
    ],
    light: null,
    surfaces: surfaces(frame),
    jumps: 0,
    input: {
      pointers: [{ ...pointer(frame), phase, tapped: phase === 'end' }],
      pointerCount: 1,
      taps: [{ worldFromRay: new Float32Array(16).fill(frame), by: 'screen' }],
      tapCount: tapped ? 1 : 0,
      left: controller(frame, last, 31),
      right: controller(frame, last, 37),
      leftHand: hand(frame, last),
      rightHand: hand(frame, last),
    },
  } as unknown as SessionFrame;
}

function lightAt(frame: number) {
  if (frame > 10) return null;
  return {
    sphericalHarmonics: new Float32Array(27).map((_, i) => chance(frame, i)),
    primaryDirectionWorld: Float32Array.of(chance(frame, 1), 1, 0),
    primaryIntensity: new Float32Array(3).fill(chance(frame, 2)),
  };
}

/** Everything a render could see of a node's outputs, in one text. */
function written(value: unknown): string {
  // By `this`, because three's objects write themselves otherwise, with an id that is new each time.
  return JSON.stringify(value, function (this: Readonly<Record<string, unknown>>, key) {
    const part = this[key];
    if (key === 'version' || key === 'changes' || key === 'claimant' || typeof part === 'function') return undefined;
    if (ArrayBuffer.isView(part)) return [...(part as Float32Array)];
    if (part instanceof Matrix4) return part.elements;
    if (isObject3D(part)) {
      const seen: unknown[] = [];
      part.traverse((child) => {
        const { geometry, material, instanceMatrix } = child as Partial<Mesh> & { instanceMatrix?: { array: Float32Array } };
        const { color, opacity } = (material ?? {}) as Partial<MeshStandardMaterial>;
        seen.push(child.matrixWorld.elements, geometry?.attributes.position?.array, color?.toArray(), opacity, instanceMatrix?.array);
      });
      return seen;
    }
    return part;
  });
}

function isObject3D(part: unknown): part is Object3D {
  return typeof part === 'object' && part !== null && 'isObject3D' in part;
}

/**
 * What the node gives at frame `last`, played from `first` on. Params named in `steady` keep their value. `played` is the number of other
 * frames that it plays before, and is reset after.
 */
function giveAt(
  type: string,
  first: number,
  last: number,
  start: Readonly<Record<string, ParamValue>>,
  steady: readonly string[],
  played = 0,
): string {
  const definition = definitionOf(type);
  let now = first;
  const session = {
    light: null as unknown,
    cameraMean: null as unknown,
    sessions: 1,
    panorama: null,
    frame: sessionFrame(0, 0, 0),
    anchors: {
      create: (at: Hit | ArrayLike<number>) => {
        const worldFromAnchor = Float32Array.from('worldFromHit' in at ? at.worldFromHit : at);
        return { id: 'anchor', state: 'tracked', worldFromAnchor, keeping: 'not-asked', evicted: 0, delete: () => {} };
      },
      restore: () => null,
      forget: () => {},
    },
    depthImage: () => null,
    answerRays: () => () => {},
    openHitTest: () => ({ read: () => hits(now), close: () => {} }),
    castRay: (ray: Float32Array, out: HitRecord) => {
      out.worldFromHit.set(ray);
      out.distanceM = now;
      return now % 3 !== 0;
    },
  };
  const asked: unknown[] = [];
  const playback = { picture: null, follow: (...what: unknown[]) => asked.push(what), settle: () => null, dispose: () => {} };
  const handle = (value: unknown) => () => ({ value, settled: Promise.resolve(), release: () => {} });
  const assets = {
    image: handle({ texture: 'image', widthPx: 2, heightPx: 2 }),
    video: handle({ durationS: 4, widthPx: 2, heightPx: 2, open: () => playback }),
    audio: handle({ durationS: 1, sampleRateHz: 48_000, channels: [TONE] }),
    model: handle(model()),
    environment: handle('panorama'),
    capture: handle(null),
    splats: handle(null),
  };
  const scene = { update: (...what: unknown[]) => asked.push(what), draw: () => {}, dispose: () => {} };
  const scenes = { createScene: () => scene };
  const objects = [objectList()];
  const inputs = Object.fromEntries(
    Object.entries(definition.inputs).flatMap(([name, port]): [string, unknown][] =>
      port.type === 'objects' ? [[name, objects]] : port.type === 'pose' ? [[name, createPose()]] : [],
    ),
  );
  const files = Object.fromEntries(
    Object.entries(definition.params).flatMap(([name, { stage }]) => (stage === 'asset' ? [[name, 'a']] : [])),
  );
  const random = createRandom(1, 'node');
  const workers = {
    start: () => {
      throw new Error('There is no worker.');
    },
  };
  const services = { session, assets, scenes, workers, random: random.next } as never;
  const params = { ...files, ...FIXED[type], ...start } as never;
  const fake = fakeContext(definition, { params, inputs: inputs as never, services });
  const clock = fake.ctx.clock as { timeS: number; deltaS: number; frame: number; held: boolean };
  clock.held = true;
  const { outputs } = fake.ctx;
  for (const [name, port] of Object.entries(definition.outputs)) {
    if (port.whenRead) continue;
    const { views } = outputs[name] as unknown as { views: unknown[] };
    if (port.type === 'layer') views.push({ texture: null, widthPx: 0, heightPx: 0, uvFromViewUv: new Float32Array(9) });
    if (port.type === 'depth') views.push(null);
  }
  const node = (RUNTIMES[type] as NodeModule).create(fake.ctx as never);
  const play = (frame: number, first: number, last: number) => {
    asked.length = 0;
    now = frame;
    fake.tick(0);
    Object.assign(clock, { timeS: frame / RATE_HZ, deltaS: frame === first ? 0 : 1 / RATE_HZ, frame });
    session.light = lightAt(frame);
    session.cameraMean = frame > 12 ? Float32Array.of(0.2, 0.3, chance(frame, 9)) : null;
    Object.entries(definition.params).forEach(([name, param], salt) => {
      if (paramWireType(param) === undefined || steady.includes(name) || FIXED[type]?.[name] !== undefined) return;
      fake.set(name, name === 'presses' ? frame : valueAt(param, frame, salt));
    });
    Object.entries(definition.inputs).forEach(([name, port], salt) => {
      if (port.type === 'pose')
        writePose(fake.ctx.inputs[name] as never, frame % 4 === 1 ? null : pointer(frame, 20 * salt).worldFromRay, 0);
      if (port.type !== 'pulse') return;
      const queue = fake.ctx.inputs[name] as unknown as PulseQueue;
      queue.clear();
      // None in the last two frames, where it could hide what came before.
      if (frame < last - 1 && chance(frame, salt) < 0.4) queue.emit().number = frame;
    });
    for (const { items } of objects) for (const { worldFromObject } of items) worldFromObject.makeTranslation(chance(frame, 3), 0, -2);
    session.frame = sessionFrame(frame, first, last);
    node.update(session.frame);
    node.remember?.();
  };
  // As the player does it.
  for (let frame = OTHERS; frame < OTHERS + played; frame++) play(frame, OTHERS, OTHERS + played - 1);
  if (played > 0) {
    random.reset();
    node.reset?.();
  }
  for (let frame = first; frame <= last; frame++) play(frame, first, last);
  const given = Object.entries(definition.outputs).map(([name, { type: wire }]) => {
    const output = outputs[name] as never;
    // No channel is silence, whatever else stands there.
    if (wire === 'audio' && (output as { channelCount: number }).channelCount === 0) return [name, 'silence'];
    // An invalid pose holds whatever it held.
    if (wire === 'pose') return [name, (output as PoseView).valid ? output : 'invalid'];
    if (wire === 'pulse') return [name, pulseNumbers(output)];
    // In whatever order surfaces were found.
    if (wire === 'objects')
      return [name, [...((output as ObjectList | undefined)?.items ?? [])].sort((a, b) => a.key.localeCompare(b.key))];
    return [name, output];
  });
  const text = written([given, asked]);
  node.dispose();
  return text;
}

/** The node's own config, and each other word of each of its choices. */
function configs({ params }: NodeDefinition): readonly Readonly<Record<string, ParamValue>>[] {
  return [
    {},
    ...Object.entries(params).flatMap(([name, param]) =>
      param.type === 'choice' && param.stage === 'structure' && !Object.values(FIXED).some((fixed) => name in fixed)
        ? param.options.map(({ value }) => ({ [name]: value }))
        : [],
    ),
  ];
}

/** What has to be left alone for the node to be stateless, with its values; null where it never is. */
function stateless({ stateful }: NodeDefinition): Readonly<Record<string, ParamValue>> | null {
  if (stateful === undefined) return {};
  if (stateful === true) return null;
  return 'moves' in stateful ? {} : { [stateful.param]: stateful.above };
}

function steadyParams({ stateful }: NodeDefinition): readonly string[] {
  if (stateful === undefined || stateful === true) return [];
  return 'moves' in stateful ? stateful.moves : [stateful.param];
}

test('there are nodes of both kinds', () => {
  expect(TYPES).toEqual(expect.arrayContaining(['value/math', 'value/counter', 'world/depth', 'source/model', 'layer/scene']));
});

describe.each(TYPES.filter((type) => stateless(definitionOf(type)) !== null))('%s', (type) => {
  const definition = definitionOf(type);

  test.each(configs(definition))('as it is declared stateless, gives the same frame 15 played from 14 as from 0: %j', (config) => {
    const start = { ...config, ...stateless(definition) };
    const steady = steadyParams(definition);
    expect(giveAt(type, LAST - 1, LAST, start, steady)).toBe(giveAt(type, 0, LAST, start, steady));
  });
});

describe.each(TYPES.filter((type) => definitionOf(type).stateful !== undefined && !(type in SHOWN_ELSEWHERE)))('%s', (type) => {
  test('is rightly declared stateful: a frame differs when it is played from the one before', () => {
    const start = SHOWING[type] ?? {};
    const lasts = Array.from({ length: LAST }, (_, i) => i + 5);
    const steady = Object.keys(start);
    expect(lasts.some((last) => giveAt(type, last - 1, last, start, steady) !== giveAt(type, 0, last, start, steady))).toBe(true);
  });
});

describe.each(TYPES)('%s', (type) => {
  test('begins anew after a reset', () => {
    const steady = Object.keys(SHOWING[type] ?? {});
    const givenAfter = (played: number) => [0, 1, 2, LAST].map((last) => giveAt(type, 0, last, SHOWING[type] ?? {}, steady, played));
    const fresh = givenAfter(0);
    for (const played of [4, LAST]) expect(givenAfter(played)).toEqual(fresh);
  });
});
