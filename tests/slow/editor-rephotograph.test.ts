import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { axeFindings } from '../support/axe.ts';
import { BALL_VIEWS, withBall } from '../support/ball-project.ts';
import { chooseOption } from '../support/choose-option.ts';
import { useEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

const open = useEditor();

test('an imported capture is shown by one press of its button, and undone by one', async () => {
  const { page, editor } = await open(await withBall());
  await editor.settled();
  const before = await editor.rewind();
  await page.keyboard.press('Shift+r');
  const row = page.getByRole('row', { name: /ball\.capture/ });
  await row.getByText('on phones').waitFor();
  await row.getByRole('button', { name: 'Add a node with ball.capture' }).click();
  await editor.imageOtherThan(before, 500);
  // The performance overlay counts what the capture has on the GPU.
  await page.locator('.canvas').focus();
  await page.keyboard.press('k');
  await page
    .locator('.node-cost')
    .getByText(/^1 draw · \d\.\d MB/)
    .waitFor();
  if (process.env.SHOT) await page.screenshot({ path: `${process.env.SHOT}-shown.png` });
  await page.keyboard.press('Control+z');
  await eventually(async () => expect(await page.locator('.react-flow__node').count()).toBe(2));
  await editor.imageSameAs(before);
});

test('a capture is rephotographed: the dialog has the means, the report the images', async () => {
  const { page, editor, project } = await open(await withBall(), { colorScheme: 'dark' });
  await editor.settled();
  await page.keyboard.press('Shift+r');
  await page.getByRole('button', { name: 'Rephotograph ball.capture…' }).click();
  const dialog = page.getByRole('dialog', { name: 'Rephotograph a capture' });
  await dialog.waitFor();
  expect(await axeFindings(page)).toEqual([]);
  if (process.env.SHOT) await page.screenshot({ path: `${process.env.SHOT}-form.png` });
  await chooseOption(dialog.getByRole('combobox', { name: 'Photographs per pixel' }), '3');
  await dialog.getByRole('button', { name: 'Rephotograph' }).click();
  const result = page.getByRole('dialog', { name: 'ball.capture, rephotographed' });
  await result.waitFor();
  const rows = await result.getByRole('row').allTextContents();
  expect(rows.slice(1)).toEqual([
    expect.stringMatching(/^Plain\d\d\.\d\d dB0\.\d{3}\d+\.\d\d$/),
    expect.stringMatching(/^Nearest/),
    expect.stringMatching(/^Lumigraph/),
  ]);
  expect(await axeFindings(page)).toEqual([]);
  if (process.env.SHOT) await page.screenshot({ path: `${process.env.SHOT}-means.png` });
  const report = JSON.parse(await readFile(join(project, 'reports/ball/report.json'), 'utf8')) as {
    blended: number;
    means: { psnrDb: number }[];
  };
  expect(report.blended).toBe(3);
  expect(rows[1]).toContain(`${report.means[0]?.psnrDb.toFixed(2)} dB`);
  const [tab] = await Promise.all([page.waitForEvent('popup'), result.getByRole('button', { name: 'Open report' }).click()]);
  await tab.getByRole('heading', { name: 'ball, rephotographed' }).waitFor();
  const images = tab.getByRole('img');
  await eventually(async () => expect(await images.count()).toBe(BALL_VIEWS * 7));
  const sizeOf = (image: HTMLImageElement) => [image.naturalWidth, image.naturalHeight];
  await eventually(async () => expect(await images.nth(1).evaluate(sizeOf)).toEqual([320, 240]));
  if (process.env.SHOT) await tab.screenshot({ path: `${process.env.SHOT}-report.png` });
  await tab.close();
});

test('a report that is canceled is not written', async () => {
  const { page, editor, project } = await open(await withBall());
  await editor.settled();
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route('**/api/call/rephotograph.add', async (route) => {
    await held;
    await route.continue();
  });
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Command' }).fill('psnr');
  await page.getByRole('option', { name: /Rephotograph a capture/ }).click();
  await page.getByRole('dialog', { name: 'Rephotograph a capture' }).getByRole('button', { name: 'Rephotograph' }).click();
  try {
    await page.getByText(`Photograph 1 of ${BALL_VIEWS}`).waitFor();
    await page.getByRole('button', { name: 'Cancel', exact: true }).click();
  } finally {
    release();
  }
  await page.getByText('Rephotography canceled.').waitFor();
  await eventually(async () => expect(await readdir(project)).not.toContain('reports'));
});
