import { expect, test } from '@jest/globals';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** A box that falls on the floor, in front of the viewer. */
const GRAPH: GraphText = {
  nodes: {
    'box-aaaa': { type: 'objects/primitive', params: { sizeM: [0.4, 0.4, 0.4] } },
    'high-aaaa': { type: 'objects/transform', params: { positionM: [0, 0.9, 0] } },
    'body-aaaa': { type: 'physics/body' },
    'world-aaaa': { type: 'physics/world' },
    'sun-aaaa': { type: 'light/directional' },
    'scene-aaaa': { type: 'layer/scene' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'box-aaaa.objects -> high-aaaa.objects',
    'high-aaaa.objects -> body-aaaa.objects',
    'body-aaaa.body -> world-aaaa.bodies',
    'body-aaaa.objects -> scene-aaaa.objects',
    'sun-aaaa.lights -> scene-aaaa.lights',
    'scene-aaaa.layer -> screen-aaaa.layer',
  ],
  places: {
    'box-aaaa': [0, 0],
    'high-aaaa': [210, 0],
    'body-aaaa': [420, 0],
    'world-aaaa': [630, 160],
    'sun-aaaa': [420, 260],
    'scene-aaaa': [630, 0],
    'screen-aaaa': [840, 0],
  },
};

const open = useOneEditor(GRAPH, {}, async () => {
  await open.page.getByRole('combobox', { name: 'Preview source' }).selectOption({ label: 'No background (orbit)' });
  await open.editor.settled();
});

async function choose(name: string, role: 'menuitem' | 'menuitemradio' = 'menuitem'): Promise<void> {
  await open.page.getByRole('button', { name: 'Physics', exact: true }).click();
  await open.page.getByRole(role, { name, exact: true }).click();
}

interface Shown {
  readonly bodies: number;
  /** Mean row of what is drawn, from the top, and whether it is drawn in the color of sleep. */
  readonly row: number;
  readonly isAsleep: boolean;
}

/** What is drawn over the preview. */
async function shown(): Promise<Shown> {
  const frame = open.page.frameLocator('iframe[title="Preview"]');
  return await frame.locator('#physics').evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const data = canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data ?? new Uint8ClampedArray();
    let [count, sum, blue] = [0, 0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if ((data[i + 3] ?? 0) < 200) continue;
      count++;
      sum += Math.floor(i / 4 / canvas.width);
      if ((data[i + 2] ?? 0) > 200) blue++;
    }
    return { bodies: Number(canvas.dataset.bodies), row: sum / count, isAsleep: blue > count / 2 };
  });
}

const timeS = async () => Number.parseFloat((await open.page.locator('.transport-time').textContent()) ?? '');

test('shapes of bodies are shown; physics pauses, resets and drops apart from the time of the preview', async () => {
  await choose('Show shapes of bodies', 'menuitemradio');
  const resting = await eventually(async () => {
    const now = await shown();
    expect(now).toMatchObject({ bodies: 1, isAsleep: true });
    return now;
  });

  await choose('Pause physics');
  await choose('Reset bodies');
  const high = await eventually(async () => {
    const now = await shown();
    expect(now.row).toBeLessThan(resting.row - 10);
    return now;
  });
  const beforeS = await timeS();
  await eventually(async () => expect(await timeS()).toBeGreaterThan(beforeS + 0.5));
  expect((await shown()).row).toBeCloseTo(high.row, 0);

  await choose('Continue physics');
  await eventually(async () => expect((await shown()).isAsleep).toBe(true));
  // Steps of other lengths end a little differently.
  expect(Math.abs((await shown()).row - resting.row)).toBeLessThan(3);

  await choose('Pause physics');
  await open.editor.node('body').locator('.node-title').click();
  await choose('Drop selected bodies again');
  await eventually(async () => expect((await shown()).row).toBeCloseTo(high.row, 0));
  await choose('Continue physics');
  await eventually(async () => expect((await shown()).isAsleep).toBe(true));

  await choose('Show shapes of bodies', 'menuitemradio');
  await open.page.frameLocator('iframe[title="Preview"]').locator('#physics').waitFor({ state: 'hidden' });
});
