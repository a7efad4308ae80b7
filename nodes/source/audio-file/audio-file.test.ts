import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetHandle, AssetService } from '../../kit/assets.ts';
import type { ParamValue } from '../../kit/definition.ts';
import type { AudioAsset } from '../../kit/sound.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const RATE_HZ = 1000;

/** A second that counts its samples in thousandths, left up and right down. */
const RAMP: AudioAsset = {
  durationS: 1,
  sampleRateHz: RATE_HZ,
  channels: [1, -1].map((sign) => Float32Array.from({ length: RATE_HZ }, (_, i) => (sign * i) / RATE_HZ)),
};

function make(params: Record<string, ParamValue> = {}, sound: AudioAsset | null = RAMP) {
  const log: string[] = [];
  const handle: AssetHandle<AudioAsset> = { kind: 'audio', value: sound, settled: Promise.resolve(), release: () => log.push('release') };
  const assets = { audio: () => handle } as Partial<AssetService> as AssetService;
  // Volume 0: nothing is heard, so that no loudspeaker is needed.
  const fake = fakeContext(definition, { params: { file: 'song', volume: 0, ...params }, services: { assets } });
  const node = create(fake.ctx);
  const { audio, level } = fake.ctx.outputs;
  const newest = (count: number, channel = 0) =>
    [...(audio.samples[channel] ?? [])].slice(-count).map((sample) => Number(sample.toFixed(4)) + 0);
  const play = (deltaS: number) => {
    fake.tick(deltaS);
    node.update({} as never);
    return newest(3);
  };
  return { ...fake, node, play, newest, audio, level, log };
}

describe('source/audio-file', () => {
  test('gives what was played last, both channels, to the moment', () => {
    const { play, newest, audio } = make();
    expect(play(0.5)).toEqual([0.497, 0.498, 0.499]);
    expect(newest(2, 1)).toEqual([-0.498, -0.499]);
    expect([audio.channelCount, audio.sampleRateHz]).toEqual([2, RATE_HZ]);
    // Before its start it had come from its end.
    expect(audio.samples[0]?.at(-501)).toBeCloseTo(0.999, 5);
  });

  test('starts over at its end, or ends in silence', () => {
    expect(make().play(1.25)).toEqual([0.247, 0.248, 0.249]);
    const once = make({ loop: false });
    once.play(0.5);
    expect(once.audio.samples[0]?.at(-501)).toBe(0);
    once.play(1);
    expect([once.audio.channelCount, once.level.value, ...once.newest(1)]).toEqual([0, 0, 0]);
  });

  test('is silent while it is not playing, and goes on where it was', () => {
    const { play, set, audio } = make({ startS: 0.1 });
    play(0.2);
    set('playing', false);
    play(0.3);
    expect(audio.channelCount).toBe(0);
    set('playing', true);
    // A change counts from the frame that sees it.
    expect(play(0.1)).toEqual([0.597, 0.598, 0.599]);
  });

  test('tells its level: of a sine, its amplitude over the root of 2', () => {
    const tone = Float32Array.from({ length: 4000 }, (_, i) => 0.5 * Math.sin((2 * Math.PI * 125 * i) / 1000));
    const { play, level } = make({}, { durationS: 4, sampleRateHz: 1000, channels: [tone] });
    play(2);
    expect(level.value).toBeCloseTo(0.5 / Math.SQRT2, 4);
  });

  test('is silence while the file is not there, and lets go of it', () => {
    const { play, audio, level, node, log } = make({}, null);
    play(1);
    expect([audio.channelCount, level.value]).toEqual([0, 0]);
    node.dispose();
    expect(log).toEqual(['release']);
  });

  test('readers see that it changed, every frame', () => {
    const { play, audio } = make();
    play(0.1);
    const before = audio.version;
    play(0.1);
    expect(audio.version).toBe(before + 1);
  });
});
