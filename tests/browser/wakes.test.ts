import { readdirSync, readFileSync } from 'node:fs';
import { beforeAll, beforeEach, describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { eventually } from '../support/patience.ts';

/** Without them nodes do not stand where they are. */
const STYLES = [
  'node_modules/@xyflow/react/dist/base.css',
  ...['ui', 'canvas', 'inspector'].flatMap((folder) =>
    readdirSync(`renderer/${folder}`).flatMap((name) => (name.endsWith('.css') ? `renderer/${folder}/${name}` : [])),
  ),
].map((path) => readFileSync(path, 'utf8'));

describe('a drag redraws every view of its value', () => {
  const module = useModule('tests/browser/wakes.page.ts', { width: 1280, height: 1400 });
  let blur = '';
  const drawn = () => module.call<Record<string, number>>('counts');

  beforeAll(async () => {
    await module.page.addStyleTag({ content: STYLES.join('\n') });
    blur = await module.call<string>('open');
    await module.page.locator(`.react-flow__node[data-id="${blur}"]`).waitFor();
  });
  beforeEach(() => module.call('forget'));

  const drag = async (selector: string, by: number) => {
    const place = module.page.locator(selector).first();
    await place.scrollIntoViewIfNeeded();
    const box = await place.boundingBox();
    if (!box) throw new Error(`There is no ${selector}.`);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await module.page.mouse.move(x, y);
    await module.page.mouse.down();
    for (let step = 1; step <= 10; step++) await module.page.mouse.move(x + (by * step) / 10, y + step);
  };

  test('a node: the canvas, and no inspector, help or bar, also when it is let go', async () => {
    await drag(`.react-flow__node[data-id="${blur}"] .node-head`, 100);
    await eventually(async () => expect((await drawn()).canvas).toBeGreaterThan(5));
    expect(await drawn()).toMatchObject({ inspector: 0, help: 0, 'top bar': 0, 'status bar': 0 });
    await module.page.mouse.up();
    await eventually(async () => expect(await module.call('lastStep')).toBe('Move'));
    expect(await drawn()).toMatchObject({ inspector: 0, help: 0, 'top bar': 0, 'status bar': 0 });
  });

  test('a value: the inspector and the node that shows it, and no help or bar', async () => {
    await drag('.inspector input.field[inputmode="decimal"]', 60);
    await eventually(async () => expect((await drawn()).inspector).toBeGreaterThan(5));
    await module.page.mouse.up();
    expect(await module.call('lastStep')).toBe('Change Radius');
    expect(await drawn()).toMatchObject({ help: 0, 'top bar': 0, 'status bar': 0 });
  });
});
