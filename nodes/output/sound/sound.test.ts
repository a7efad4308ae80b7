import { describe, expect, test } from '@jest/globals';
import { Matrix4 } from 'three';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { useGlobals } from '../../../tests/support/page-globals.ts';
import type { ParamValue } from '../../kit/definition.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';
import { strike } from './strike.ts';
import { MAX_VOICES } from './voices.ts';

interface Heard {
  readonly amplitude: number;
  readonly rate: number;
  readonly from: readonly number[] | null;
}

/** A page whose speaker writes down what it plays. Sounds last until `finish`. */
function fakePage(refusal: string | null) {
  const listeners = new Map<string, Set<() => void>>();
  const heard: Heard[] = [];
  const ends: (() => void)[] = [];
  const log: string[] = [];
  class FakeContext {
    state = 'running';
    readonly destination = { kind: 'speaker', disconnect: () => {} };
    constructor() {
      if (refusal !== null) throw new Error(refusal);
      log.push('opened');
    }
    createBuffer = (channels: number, length: number) => ({ getChannelData: () => new Float32Array(channels * length) });
    createGain = () => {
      const gain = { gain: { value: 0 }, to: null as unknown, disconnect: () => {}, connect: (to: unknown) => Object.assign(gain, { to }) };
      return gain;
    };
    createPanner = () => ({
      positionX: { value: 0 },
      positionY: { value: 0 },
      positionZ: { value: 0 },
      connect: () => {},
      disconnect: () => {},
    });
    createBufferSource = () => {
      let gain: ReturnType<FakeContext['createGain']> | null = null;
      const source = {
        playbackRate: { value: 1 },
        onended: () => {},
        connect: (to: typeof gain) => {
          gain = to;
          return to;
        },
        start: () => {
          const panner = gain?.to as ReturnType<FakeContext['createPanner']> | { kind: string };
          const from = 'kind' in panner ? null : [panner.positionX.value, panner.positionY.value, panner.positionZ.value];
          heard.push({ amplitude: gain?.gain.value ?? 0, rate: source.playbackRate.value, from });
          ends.push(() => source.onended());
        },
      };
      return source;
    };
    resume = () => Promise.resolve();
    close = async () => void log.push('closed');
  }
  const globals = {
    document: {
      addEventListener: (name: string, listener: () => void) => listeners.set(name, new Set([...(listeners.get(name) ?? []), listener])),
      removeEventListener: (name: string, listener: () => void) => listeners.get(name)?.delete(listener),
    },
    navigator: { userActivation: { hasBeenActive: false } },
    AudioContext: FakeContext,
  };
  return {
    globals,
    heard,
    log,
    tap: () => {
      for (const listener of listeners.get('pointerdown') ?? []) listener();
    },
    finish: () => {
      for (const end of ends.splice(0)) end();
    },
    listening: () => [...listeners.values()].reduce((sum, set) => sum + set.size, 0),
  };
}

const setGlobals = useGlobals('document', 'navigator', 'AudioContext');

function make(params: Record<string, ParamValue> = {}, refusal: string | null = null) {
  const page = fakePage(refusal);
  setGlobals(page.globals);
  const play = createPulseQueue();
  const fake = fakeContext(definition, { params: { sound: 'wood', ...params }, inputs: { play } });
  const node = create(fake.ctx);
  const frame = createSessionFrame();
  const strikeWith = (strengths: readonly number[], at: readonly [number, number, number] | null = null) => {
    fake.tick(1 / 60);
    play.clear();
    for (const strength of strengths) {
      const pulse = play.emit();
      pulse.number = strength;
      if (at) pulse.setPose(new Matrix4().setPosition(...at).elements);
    }
    node.update(frame);
    return page.heard.splice(0);
  };
  return { ...fake, ...page, node, frame, strikeWith };
}

describe('output/sound', () => {
  test('is as loud as its pulses are strong, up to the volume, after the first tap', () => {
    const { strikeWith, tap, reports } = make({ loudest: 2, quietest: 0.1, volume: 0.5 });
    expect(strikeWith([2])).toEqual([]);
    tap();
    expect(strikeWith([2, 1, 0.5, 50, 0.05, Number.NaN]).map(({ amplitude }) => amplitude)).toEqual([0.5, 0.25, 0.125, 0.5]);
    expect(reports).toEqual([]);
  });

  test('comes from where the pulse is, seen from the viewer, and from everywhere without a pose', () => {
    const { strikeWith, tap, frame, set } = make();
    strikeWith([]);
    tap();
    const [view] = frame.views;
    // The viewer stands at x = 1 and looks along +x.
    const worldFromView = new Matrix4().makeRotationY(-Math.PI / 2).setPosition(1, 0, 0);
    Object.assign(frame, { viewCount: 1, views: [{ ...view, viewFromWorld: new Float32Array(worldFromView.clone().invert().elements) }] });
    const near = [0, 0, -2].map((x) => expect.closeTo(x, 5));
    expect(strikeWith([1], [3, 0, 0])).toMatchObject([{ from: near }]);
    expect(strikeWith([1])).toMatchObject([{ from: null }]);
    set('place', false);
    expect(strikeWith([1], [3, 0, 0])).toMatchObject([{ from: null }]);
  });

  test('plays as many at once as there are voices, and further ones when those have ended', () => {
    const { strikeWith, tap, finish } = make();
    strikeWith([]);
    tap();
    const many = Array.from({ length: 16 }, () => 1);
    expect(strikeWith(many)).toHaveLength(MAX_VOICES);
    expect(strikeWith(many)).toEqual([]);
    finish();
    expect(strikeWith([1])).toHaveLength(1);
  });

  test('where the browser plays no sound, the page goes on in silence and says so once', () => {
    const { strikeWith, tap, reports } = make({}, 'no device');
    strikeWith([]);
    tap();
    tap();
    expect(strikeWith([1])).toEqual([]);
    expect(reports).toMatchObject([{ code: 'SCR055', severity: 'warning', message: expect.stringContaining('no device') }]);
  });

  test('renders open no speaker; afterwards nothing listens', () => {
    const { ctx, strikeWith, tap, log, node, listening } = make();
    Object.assign(ctx.clock, { held: true });
    strikeWith([1]);
    tap();
    expect([log, listening()]).toEqual([[], 0]);
    Object.assign(ctx.clock, { held: false });
    strikeWith([]);
    tap();
    node.dispose();
    expect([log, listening()]).toEqual([['opened', 'closed'], 0]);
  });
});

describe('the sounds of materials', () => {
  const NAMES_OF = ['glass', 'metal', 'wood', 'soft'] as const;
  /** Crossings of zero per second, weighted by loudness: a measure of how bright a sound is. */
  const brightness = (samples: Float32Array, rateHz: number) => {
    let crossings = 0;
    const heard = samples.subarray(0, Math.round(0.05 * rateHz));
    for (let i = 1; i < heard.length; i++) if ((heard[i - 1] ?? 0) < 0 !== (heard[i] ?? 0) < 0) crossings++;
    return crossings / 0.05;
  };

  test('begin and end in silence, with a peak of 1', () => {
    for (const name of NAMES_OF) {
      const [samples = new Float32Array(1)] = strike(name).channels;
      expect([name, Math.abs(samples[0] ?? 1) < 1e-6, Math.abs(samples.at(-1) ?? 1) < 1e-3]).toEqual([name, true, true]);
      expect(Math.max(...samples.map(Math.abs))).toBeCloseTo(1, 5);
    }
  });

  test('glass is brighter than tin, tin than wood, wood than a thud; tin rings longest', () => {
    const made = NAMES_OF.map((name) => strike(name));
    const bright = made.map(({ channels: [samples], sampleRateHz }) => brightness(samples ?? new Float32Array(1), sampleRateHz));
    expect([...bright].sort((a, b) => b - a)).toEqual(bright);
    const energyAfter = ({ channels: [samples = new Float32Array(1)] }: ReturnType<typeof strike>) =>
      samples.subarray(Math.round(0.12 * 48_000)).reduce((sum, x) => sum + x * x, 0);
    expect(Math.max(...made.map(energyAfter))).toBe(energyAfter(made[1] as ReturnType<typeof strike>));
  });
});
