import type { Frame, Page } from 'playwright-core';

/**
 * Time of each step from a key press to a changed image, in milliseconds since the epoch. If a step occurs several times, the last one
 * counts.
 */
type Marks = Readonly<Record<string, number>>;

/** The steps in order, each with a description of what happens before it. */
const STEPS = [
  ['request', 'the page takes the text over'],
  ['answer', 'the worker compiles, and its answer waits for the page'],
  ['program', 'the page takes the program over'],
  ['received', 'the message goes to the preview'],
  ['linked', 'the driver links'],
  ['frame', 'the frame is drawn'],
] as const;

/** Script that runs in every page and frame before its own scripts. Records the times at which the messages of the steps pass. */
const RECORD = `(() => {
  const marks = (globalThis.scrimMarks = {});
  const mark = (name) => { marks[name] = performance.timeOrigin + performance.now(); };
  addEventListener('keydown', () => mark('key'), true);
  const kindOf = (data) => (data && typeof data === 'object' ? data.kind : undefined);
  const toPort = MessagePort.prototype.postMessage;
  const toWorker = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (message, ...rest) {
    if (message && message.project && 'revision' in message) {
      mark('request');
      // A message to itself comes once the page has nothing else to do.
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => mark('free');
      toPort.call(port2, null);
    }
    return toWorker.call(this, message, ...rest);
  };
  MessagePort.prototype.postMessage = function (message, ...rest) {
    const kind = kindOf(message);
    if (kind === 'program') mark('program');
    if (kind === 'shader-errors') mark('linked');
    if (kind === 'playing') {
      // The frame that is drawn next is on the screen at the start of the one after it.
      requestAnimationFrame(() => requestAnimationFrame(() => mark('frame')));
    }
    return toPort.call(this, message, ...rest);
  };
  const before = (type, see) => {
    const onmessage = Object.getOwnPropertyDescriptor(type.prototype, 'onmessage');
    const set = function (handler) {
      onmessage.set.call(this, handler && ((event) => (see(event.data), handler.call(this, event))));
    };
    Object.defineProperty(type.prototype, 'onmessage', { ...onmessage, set });
  };
  before(Worker, (data) => {
    if (!data || !('tookMs' in data)) return;
    mark('answer');
    marks.took = data.tookMs;
  });
  before(MessagePort, (data) => kindOf(data) === 'program' && mark('received'));
})()`;

/** Measures each step from a key press to the changed image. */
export interface KeyParts {
  /** Installs the recording script. Must be called before the page is opened. */
  prepare(page: Page): Promise<void>;
  /** Collects the times of the last key press. Called when the changed image is shown. */
  take(page: Page): Promise<void>;
  /** Text with one line per step: the median and the 95th percentile, in milliseconds. */
  print(): string;
}

export function createKeyParts(quantile: (sorted: readonly number[], q: number) => number): KeyParts {
  const taken: Marks[] = [];
  const marksIn = (frame: Frame): Promise<Marks> =>
    frame.evaluate(() => (globalThis as unknown as { scrimMarks?: Marks }).scrimMarks ?? {}).catch(() => ({}));
  return {
    prepare: async (page) => {
      await page.addInitScript(RECORD);
    },
    take: async (page) => {
      const marks = Object.assign({}, ...(await Promise.all(page.frames().map(marksIn)))) as Record<string, number>;
      taken.push(marks);
    },
    print: () => {
      const lines = STEPS.map(([step, words], i) => line(words, between(taken, STEPS[i - 1]?.[0] ?? 'key', step)));
      const within = [
        line(
          'of this, the compiler’s own time',
          taken.flatMap(({ took }) => took ?? []),
        ),
        line('of this, the page’s thread is busy with the change', between(taken, 'request', 'free')),
      ];
      lines.splice(2, 0, ...within.map((text) => `  ${text}`));
      return ['From a key to a picture, in ms (median, p95):', ...lines, line('all', between(taken, 'key', 'frame'))].join('\n');
    },
  };

  function line(words: string, times: readonly number[]): string {
    const sorted = [...times].sort((a, b) => a - b);
    return `  ${words}: ${quantile(sorted, 0.5).toFixed(1)}, ${quantile(sorted, 0.95).toFixed(1)}`;
  }
}

function between(taken: readonly Marks[], from: string, to: string): number[] {
  return taken.flatMap((marks) => {
    const [start, end] = [marks[from], marks[to]];
    return start === undefined || end === undefined || end < start ? [] : [end - start];
  });
}
