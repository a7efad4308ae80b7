import { describe, expect, test } from '@jest/globals';
import { createManualClock } from './clock.ts';

describe('a manual clock', () => {
  test('runs frames and delays only when moved', async () => {
    const clock = createManualClock(100);
    const log: string[] = [];
    clock.requestFrame((timeS) => log.push(`frame at ${timeS}`));
    const cancelled = clock.requestFrame(() => log.push('cancelled'));
    clock.cancelFrame(cancelled);
    void clock.delay(0.5).then(() => log.push('awake'));
    clock.advance(0.25);
    await Promise.resolve();
    expect(log).toEqual(['frame at 100.25']);
    clock.advance(0.25);
    await Promise.resolve();
    expect(log).toEqual(['frame at 100.25', 'awake']);
  });

  test('a frame asked for within a frame comes with the next move', () => {
    const clock = createManualClock();
    const times: number[] = [];
    const again = (timeS: number): void => {
      times.push(timeS);
      clock.requestFrame(again);
    };
    clock.requestFrame(again);
    clock.advance(1);
    clock.advance(1);
    expect(times).toEqual([1, 2]);
  });
});

describe('the date', () => {
  test.each([
    '1970-01-01T00:00:00.000Z',
    '1969-12-31T23:59:59.250Z',
    '2000-02-29T12:00:00.000Z',
    '2023-03-01T00:00:00.000Z',
    '2024-12-31T23:59:59.500Z',
    '2100-02-28T06:30:15.125Z',
  ])('of %s is what Date says', (iso) => {
    const out = new Float64Array(4);
    const date = new Date(iso);
    createManualClock(0, date.getTime()).readDate(out);
    const seconds = date.getUTCHours() * 3600 + date.getUTCMinutes() * 60 + date.getUTCSeconds() + date.getUTCMilliseconds() / 1000;
    expect([...out]).toEqual([date.getUTCFullYear(), date.getUTCMonth() + 1, date.getUTCDate(), seconds]);
  });
});
