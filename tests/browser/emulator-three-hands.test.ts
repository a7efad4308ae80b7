import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/emulator-three-hands.page.ts');

test('the models of controllers and hands that three.js comes with follow the emulated device', async () => {
  const { turned, told, drawn, ...rest } = await page.call<{ turned: number[]; told: number[][]; drawn: (number[][] | null)[] }>('models');
  expect(rest).toEqual({ gripsVisible: [true, true], handsVisible: [true, true], error: 0 });
  // One trigger is pulled, the other is not.
  expect([...turned].sort()).toEqual([expect.closeTo(0, 5), expect.closeTo(0.5, 5)]);
  expect(told).toHaveLength(25);
  const left = drawn.find((joints) => joints?.some(([x = 0]) => x < 0));
  expect(left).toEqual(told.map((joint) => joint.map((x) => expect.closeTo(x, 4))));
  expect(page.errors).toEqual([]);
});
