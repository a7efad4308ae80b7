import { expect, test } from '@jest/globals';
import { chooseOption } from '../support/choose-option.ts';
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
  await chooseOption(open.page.getByRole('combobox', { name: 'Preview source' }), 'orbit');
  await open.editor.settled();
});

async function choose(name: string, role: 'menuitem' | 'menuitemcheckbox' = 'menuitem'): Promise<void> {
  await open.page.getByRole('button', { name: 'Physics', exact: true }).click();
  await open.page.getByRole(role, { name, exact: true }).click();
}

interface Shown {
  readonly bodies: number;
  /** Mean row and column of the edges of the body, from the top left, and whether they are drawn in the color of sleep. */
  readonly row: number;
  readonly column: number;
  readonly isAsleep: boolean;
}

/** What is drawn over the preview. */
async function shown(): Promise<Shown> {
  const frame = open.page.frameLocator('iframe[title="Preview"]');
  return await frame.locator('#physics').evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const data = canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data ?? new Uint8ClampedArray();
    let [count, sum, columns, blue] = [0, 0, 0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if ((data[i + 3] ?? 0) < 200) continue;
      // Edges are orange or light blue; marks of contacts, forces and centers of mass are red or violet.
      if ((data[i + 1] ?? 0) < 150) continue;
      count++;
      sum += Math.floor(i / 4 / canvas.width);
      columns += (i / 4) % canvas.width;
      if ((data[i + 2] ?? 0) > 200) blue++;
    }
    return { bodies: Number(canvas.dataset.bodies), row: sum / count, column: columns / count, isAsleep: blue > count / 2 };
  });
}

const timeS = async () => Number.parseFloat((await open.page.locator('.transport-time').textContent()) ?? '');

test('shapes of bodies are shown; physics pauses, resets and drops apart from the time of the preview', async () => {
  await choose('Show shapes of bodies', 'menuitemcheckbox');
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
  expect(Math.abs((await shown()).row - high.row)).toBeLessThan(1);

  await choose('Continue physics');
  await eventually(async () => expect((await shown()).isAsleep).toBe(true));
  // It lies on the floor again. Steps of other lengths end a little differently.
  expect(Math.abs((await shown()).row - resting.row)).toBeLessThan((resting.row - high.row) / 10);

  await choose('Pause physics');
  await open.editor.node('body').locator('.node-title').click();
  await choose('Drop selected bodies again');
  await eventually(async () => expect(Math.abs((await shown()).row - high.row)).toBeLessThan(1));
  await choose('Continue physics');
  await eventually(async () => expect((await shown()).isAsleep).toBe(true));

  // A drag by the pointer lifts the body and carries it to the right; let go, it falls and comes to rest there.
  const before = await shown();
  const iframe = await open.page.locator('iframe[title="Preview"]').boundingBox();
  if (!iframe) throw new Error('There is no preview.');
  const [x, y] = [iframe.x + before.column, iframe.y + before.row];
  await open.page.mouse.move(x, y);
  await open.page.mouse.down();
  await open.page.mouse.move(x - 20, y - 40, { steps: 10 });
  await eventually(async () => {
    const held = await shown();
    expect(held.isAsleep).toBe(false);
    expect(held.row).toBeLessThan(before.row - 25);
  });
  await open.page.mouse.move(x + 60, y - 50, { steps: 6 });
  // It hangs still before it is let go: a swinging box lands on an edge and rolls anywhere.
  await eventually(async () => {
    const [startS, start] = [await timeS(), await shown()];
    await eventually(async () => expect(await timeS()).toBeGreaterThan(startS + 1));
    const held = await shown();
    expect(held.column).toBeGreaterThan(before.column + 25);
    expect(Math.abs(held.column - start.column) + Math.abs(held.row - start.row)).toBeLessThan(1);
  });
  await open.page.mouse.up();
  const thrown = await eventually(async () => {
    const now = await shown();
    expect(now.isAsleep).toBe(true);
    return now;
  });
  expect(thrown.column).toBeGreaterThan(before.column + 15);

  await choose('Show shapes of bodies', 'menuitemcheckbox');
  await open.page.frameLocator('iframe[title="Preview"]').locator('#physics').waitFor({ state: 'hidden' });
});
