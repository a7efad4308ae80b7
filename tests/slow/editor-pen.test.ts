import { expect, test } from '@jest/globals';
import type { CDPSession, Page } from 'playwright-core';
import { centerOf, type Point } from '../../tools/lib/center-of.ts';
import { type GraphText, saveGraphs, useEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { holdRests, rest } from '../support/rest.ts';

const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'gaussian-blur-aaaa': { type: 'filter/gaussian-blur', params: { radius: 4 } },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'gaussian-blur-aaaa': [260, 160], 'screen-aaaa': [520, 0] },
};
const STEPS = 8;

const openEditor = useEditor();

/** A pen on the page, as the browser reports one: it hovers, touches with its tip, and its button is the secondary one. */
class Pen {
  private readonly session: CDPSession;

  private constructor(session: CDPSession) {
    this.session = session;
  }

  static async on(page: Page): Promise<Pen> {
    return new Pen(await page.context().newCDPSession(page));
  }

  async down({ x, y }: Point, button: 'left' | 'right' = 'left'): Promise<void> {
    await this.send({ type: 'mouseMoved', x, y });
    await this.send({ type: 'mousePressed', x, y, button, buttons: button === 'left' ? 1 : 2, clickCount: 1 });
  }

  async slide({ x, y }: Point): Promise<void> {
    await this.send({ type: 'mouseMoved', x, y, button: 'left', buttons: 1, force: 0.5 });
  }

  async lift({ x, y }: Point, button: 'left' | 'right' = 'left'): Promise<void> {
    await this.send({ type: 'mouseReleased', x, y, button, clickCount: 1 });
  }

  async tap(at: Point, button: 'left' | 'right' = 'left'): Promise<void> {
    await this.down(at, button);
    await this.lift(at, button);
  }

  async drag(from: Point, to: Point): Promise<void> {
    await this.down(from);
    for (let step = 1; step <= STEPS; step++) {
      const part = step / STEPS;
      await this.slide({ x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part });
    }
    await this.lift(to);
  }

  private async send(
    event: Omit<Parameters<typeof this.session.send<'Input.dispatchMouseEvent'>>[1] & object, 'pointerType'>,
  ): Promise<void> {
    await this.session.send('Input.dispatchMouseEvent', { ...event, pointerType: 'pen' });
  }
}

test('a pen moves nodes, draws wires, turns dials, and asks for the menu by resting or by its button', async () => {
  const open = await openEditor(GRAPH, { size: { width: 1024, height: 768 }, before: holdRests });
  const { page, editor } = open;
  const kinds = await page.evaluateHandle(() => {
    const seen = new Set<string>();
    window.addEventListener('pointerdown', ({ pointerType }) => seen.add(pointerType), true);
    return seen;
  });
  const pen = await Pen.on(page);
  const title = editor.node('gaussian-blur').locator('.node-title');

  const blur = await centerOf(title);
  await pen.drag(blur, { x: blur.x, y: blur.y + 80 });
  const below = await centerOf(title);
  expect(Math.abs(below.x - blur.x)).toBeLessThan(10);
  expect(below.y - blur.y).toBeGreaterThan(40);

  await pen.drag(
    await centerOf(editor.port('video-aaaa', 'layer', 'source')),
    await centerOf(editor.port('gaussian-blur-aaaa', 'inputImage', 'target')),
  );
  await page.getByRole('group', { name: 'Wire from Camera video to Gaussian blur' }).waitFor();

  await pen.tap(await centerOf(title));
  const radius = editor.inspector.getByRole('textbox', { name: 'Radius', exact: true });
  const dial = await centerOf(radius);
  await pen.drag(dial, { x: dial.x + 40, y: dial.y });
  await eventually(async () => expect(Number(await radius.inputValue())).toBeGreaterThan(4));
  await page.keyboard.press('Control+z');
  await eventually(async () => expect(await radius.inputValue()).toBe('4'));

  // A pen that rests asks for the menu, which stays when it is lifted; so does its button, at once.
  const menu = page.getByRole('menu', { name: 'Actions' });
  const at = await centerOf(title);
  await pen.down(at);
  await rest(page);
  await menu.waitFor();
  await pen.lift(at);
  await pen.tap(await centerOf(menu.getByRole('menuitemcheckbox', { name: 'Mute' })));
  await page.locator('.node-muted').waitFor();
  await menu.waitFor({ state: 'detached' });
  await pen.tap(at, 'right');
  await pen.tap(await centerOf(menu.getByRole('menuitemcheckbox', { name: 'Mute' })));
  await page.locator('.node-muted').waitFor({ state: 'detached' });

  // From a wire let go on the empty canvas to a node that takes it.
  await pen.drag(await centerOf(editor.port('gaussian-blur-aaaa', 'layer', 'source')), await editor.emptyPlace());
  await page.getByRole('combobox', { name: 'Search nodes' }).waitFor();
  await page.keyboard.type('sepia');
  await pen.tap(await centerOf(page.getByRole('option', { name: /^Sepia/ })));
  await page.getByRole('group', { name: 'Wire from Gaussian blur to Sepia' }).waitFor();

  expect(await kinds.evaluate((seen) => [...seen])).toEqual(['pen']);
  expect((await saveGraphs(open)).main?.wires).toContain('video-aaaa.layer -> gaussian-blur-aaaa.inputImage');
});
