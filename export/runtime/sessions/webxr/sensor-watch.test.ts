import { expect, test } from '@jest/globals';
import { createSensorWatch, FIRST_REPORT_AFTER_S, REPORT_AFTER_S } from './sensor-watch.ts';

/** Reports on a sensor that measures at these times of a minute, at 60 fps. */
function told(measures: (timeS: number) => boolean): (readonly [working: boolean, atS: number])[] {
  const changes: (readonly [boolean, number])[] = [];
  let nowS = 0;
  const watch = createSensorWatch((working) => changes.push([working, Math.round(nowS * 10) / 10]));
  for (let i = 0; i < 3600; i++) {
    nowS = i / 60;
    watch.update(nowS, measures(nowS));
  }
  return changes;
}

test('a sensor that works, and one that leaves out frames, are not worth a word', () => {
  expect(told(() => true)).toEqual([]);
  expect(told((s) => s % 2 < 0.1)).toEqual([]);
});

test('one that falls silent is reported after a while, and at once when it is back', () => {
  expect(told((s) => s < 10 || s > 30)).toEqual([
    [false, 10 + REPORT_AFTER_S],
    [true, 30],
  ]);
});

test('the first measurement may take longer', () => {
  expect(told((s) => s > FIRST_REPORT_AFTER_S - 1)).toEqual([]);
  expect(told(() => false)).toEqual([[false, FIRST_REPORT_AFTER_S]]);
});
