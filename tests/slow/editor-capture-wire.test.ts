import { expect, test } from '@jest/globals';
import { frameOf } from '../../tools/lib/frame-of.ts';
import { withBall } from '../support/ball-project.ts';
import { useEditor } from '../support/open-editor.ts';

const open = useEditor();

test('the inspector says which params of a mesh come from the wire of a capture, and gives them back when it is removed', async () => {
  const ball = await withBall();
  const { editor, errors } = await open({
    ...ball,
    nodes: {
      'place-aaaa': { type: 'source/capture', params: { file: 'ball', positionM: [0, 0.8, -1.2] } },
      'mesh-aaaa': { type: 'source/capture-mesh' },
      'scene-aaaa': { type: 'layer/scene' },
      'over-aaaa': { type: 'operator/over' },
      'screen-aaaa': { type: 'output/screen' },
    },
    wires: [
      'place-aaaa.capture -> mesh-aaaa.capture',
      'mesh-aaaa.objects -> scene-aaaa.objects',
      'place-aaaa.layer -> over-aaaa.bottom',
      'scene-aaaa.layer -> over-aaaa.top',
      'over-aaaa.layer -> screen-aaaa.layer',
    ],
    places: { 'place-aaaa': [0, 0], 'mesh-aaaa': [260, 160], 'scene-aaaa': [520, 160], 'over-aaaa': [780, 0], 'screen-aaaa': [1040, 0] },
  });
  await editor.settled();
  await editor.node('mesh').locator('.node-title').click();
  const params = editor.inspector.getByRole('region', { name: 'Parameters' });
  const replaced = params.getByText('From input “Capture”');
  await replaced.first().waitFor();
  expect(await replaced.count()).toBe(4);
  await editor.inspector.getByRole('button', { name: 'Disconnect ball' }).click();
  await params
    .getByRole('textbox', { name: 'Scale' })
    .or(params.getByRole('spinbutton', { name: 'Scale' }))
    .first()
    .waitFor();
  expect(await replaced.count()).toBe(0);
  expect(errors).toEqual([]);
});

test('a capture whose loading the loss of the graphics device interrupts is shown when the device is restored', async () => {
  const ball = await withBall();
  const { page, editor } = await open({
    ...ball,
    nodes: {
      'place-aaaa': { type: 'source/capture', params: { file: 'ball', positionM: [0, 0.8, -1.2] } },
      'screen-aaaa': { type: 'output/screen' },
    },
    wires: ['place-aaaa.layer -> screen-aaaa.layer'],
    places: { 'place-aaaa': [0, 0], 'screen-aaaa': [400, 0] },
  });
  await editor.settled();
  const whole = await editor.rewind();
  let answer = () => {};
  const answered = new Promise<void>((done) => {
    answer = done;
  });
  await page.context().route(/ball\.capture\/mesh\.bin/, async (route) => {
    await answered;
    await route.continue();
  });
  const asking = page.waitForRequest(/ball\.capture\/mesh\.bin/);
  await page.reload();
  await asking;
  const frame = await frameOf(page);
  const device = await frame.evaluateHandle(() =>
    document.querySelector<HTMLCanvasElement>('#picture')?.getContext('webgl2')?.getExtension('WEBGL_lose_context'),
  );
  await device.evaluate((extension) => extension?.loseContext());
  const notice = page.getByText('The graphics device was lost');
  await notice.waitFor();
  answer();
  await device.evaluate((extension) => extension?.restoreContext());
  await notice.waitFor({ state: 'detached' });
  await editor.settled();
  await editor.imageSameAs(whole);
});
