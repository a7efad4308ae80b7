import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { useGlobals } from '../../../tests/support/page-globals.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** A page with a microphone that hears 0.5 for ever, once it is allowed. */
function fakePage(answer: () => Promise<unknown>) {
  const listeners = new Map<string, Set<() => void>>();
  const log: string[] = [];
  class FakeContext {
    readonly state = 'running';
    readonly sampleRate = 44_100;
    createMediaStreamSource = () => ({ connect: () => {} });
    createChannelSplitter = () => ({ connect: () => {} });
    resume = () => Promise.resolve();
    close = async () => void log.push('closed');
  }
  class FakeAnalyser {
    getFloatTimeDomainData(samples: Float32Array): void {
      samples.fill(0.5);
    }
  }
  const media = {
    getUserMedia: (wishes: unknown) => {
      log.push(`asked ${Object.keys(wishes as object).join()}`);
      return answer();
    },
  };
  const globals = {
    document: {
      addEventListener: (name: string, listener: () => void) => listeners.set(name, new Set([...(listeners.get(name) ?? []), listener])),
      removeEventListener: (name: string, listener: () => void) => listeners.get(name)?.delete(listener),
    },
    navigator: { mediaDevices: media, userActivation: { hasBeenActive: false } },
    AudioContext: FakeContext,
    AnalyserNode: FakeAnalyser,
  };
  return {
    globals,
    log,
    touch: async () => {
      for (const listener of listeners.get('pointerup') ?? []) listener();
      await new Promise((resolve) => setImmediate(resolve));
    },
    listening: () => [...listeners.values()].reduce((sum, set) => sum + set.size, 0),
  };
}

const setGlobals = useGlobals('document', 'navigator', 'AudioContext', 'AnalyserNode');

function make(answer: () => Promise<unknown>) {
  const page = fakePage(answer);
  setGlobals(page.globals);
  const fake = fakeContext(definition);
  const node = create(fake.ctx);
  const hear = () => {
    fake.tick(0.1);
    node.update({} as never);
    const { audio, level } = fake.ctx.outputs;
    return [audio.channelCount, audio.sampleRateHz, audio.samples[0]?.at(-1), level.value];
  };
  return { ...fake, ...page, node, hear };
}

function stream(log: string[] = []) {
  const track = { getSettings: () => ({ channelCount: 1 }), stop: () => log.push('stopped') };
  return { getAudioTracks: () => [track], getTracks: () => [track] };
}

describe('source/microphone', () => {
  test('asks once, for sound alone, when the page is touched, and then hears', async () => {
    const { hear, touch, log, set } = make(() => Promise.resolve(stream()));
    expect([hear(), log]).toEqual([[0, 0, 0, 0], []]);
    await touch();
    await touch();
    expect(log).toEqual(['asked audio']);
    expect(hear()).toEqual([1, 44_100, 0.5, 0.5]);
    set('gain', 2);
    expect(hear()).toEqual([1, 44_100, 1, 1]);
  });

  test.each([
    ['NotAllowedError', 'The microphone was not allowed.', 'Allow it'],
    ['NotFoundError', 'No microphone was found.', 'Connect one'],
    ['NotReadableError', 'The microphone is not available.', 'Close other apps'],
  ])('goes on in silence after %s, and says so', async (name, message, fix) => {
    const { hear, touch, reports } = make(() => Promise.reject(new DOMException('no', name)));
    await touch();
    expect(hear()).toEqual([0, 0, 0, 0]);
    expect(reports).toMatchObject([{ code: 'SCR055', severity: 'warning', message: expect.stringContaining(message) }]);
    expect(reports[0]?.fix).toContain(fix);
  });

  test('releases the microphone, also if it is granted after disposal', async () => {
    const early: string[] = [];
    const first = make(() => Promise.resolve(stream(early)));
    await first.touch();
    first.node.dispose();
    expect([early, first.log, first.listening()]).toEqual([['stopped'], ['asked audio', 'closed'], 0]);
    const late: string[] = [];
    let allow = (): void => {};
    const second = make(
      () =>
        new Promise((resolve) => {
          allow = () => resolve(stream(late));
        }),
    );
    await second.touch();
    second.node.dispose();
    allow();
    await new Promise((resolve) => setImmediate(resolve));
    expect(late).toEqual(['stopped']);
  });

  test('does not ask during a render', async () => {
    const page = fakePage(() => Promise.resolve(stream()));
    setGlobals(page.globals);
    const fake = fakeContext(definition);
    Object.assign(fake.ctx.clock, { held: true });
    create(fake.ctx);
    await page.touch();
    expect(page.log).toEqual([]);
  });
});
