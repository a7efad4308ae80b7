import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { pixelAt } from '../support/image.ts';
import { useEditor } from '../support/open-editor.ts';

const openEditor = useEditor();

const HEADER = '/*{ "ISFVSN": "2", "INPUTS": [ { "NAME": "inputImage", "TYPE": "image" } ] }*/';

const ENDLESS = `${HEADER}
float turn(float x) {
  float y = x;
  while (y > -1.0) { y = fract(y + 0.1); }
  return y;
}
void main() {
  gl_FragColor = vec4(turn(0.5), 0.0, 0.0, 1.0) + IMG_THIS_PIXEL(inputImage);
}
`;

/** Without the loop it paints everything red. */
const MENDED = ENDLESS.replace('while (y > -1.0)', 'if (y > 0.9)').replace(' + IMG_THIS_PIXEL(inputImage)', '');

const LOOP_LINE = 4;

/** The camera's image goes through a filter of the project's own to the screen. */
const GRAPH = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'own-aaaa': [260, 0], 'screen-aaaa': [520, 0] },
} as const;

test('a shader that never ends leaves the editor live, the rest of the picture playing, and a mark on its line', async () => {
  const { page, editor, project } = await openEditor(GRAPH);
  await editor.settled();
  const plain = await editor.rewind();
  await editor.press('Play');

  await mkdir(join(project, 'shaders'), { recursive: true });
  await writeFile(join(project, 'shaders', 'own.fs'), ENDLESS);
  const path = join(project, 'project.scrim.json');
  const document = JSON.parse(await readFile(path, 'utf8'));
  document.graphs.main.nodes['own-aaaa'] = { type: 'filter/own', version: 1 };
  document.graphs.main.wires = ['video-aaaa.layer -> own-aaaa.inputImage', 'own-aaaa.layer -> screen-aaaa.layer'];
  await writeFile(path, JSON.stringify(document));

  const problem = page.getByRole('list', { name: 'Problems' }).getByRole('button', { name: 'The loops do not end in time' });
  await page.locator('.status-problems').click();
  await problem.waitFor();
  expect(await problem.textContent()).toContain(`shaders/own.fs:${LOOP_LINE}`);

  // Time goes on, and so does the editor: it selects, and shows the line.
  const frame = await editor.frame();
  await page.waitForFunction((before) => Number(document.querySelector('.transport-time span')?.textContent) > before + 5, frame);
  await problem.click();
  await page.locator('.monaco-editor .squiggly-error').first().waitFor();
  const line = await page.evaluate(() => {
    const top = (selector: string) => document.querySelector(selector)?.getBoundingClientRect().top ?? Number.NaN;
    const mark = top('.squiggly-error');
    const numbers = [...document.querySelectorAll('.line-numbers')];
    return numbers.find((number) => Math.abs(number.getBoundingClientRect().top - mark) < 3)?.textContent?.trim();
  });
  expect(line).toBe(String(LOOP_LINE));

  // What the filter gets passes through it.
  await editor.rewind();
  await editor.imageSameAs(plain);

  await writeFile(join(project, 'shaders', 'own.fs'), MENDED);
  await page.locator('.status-problems').getByText('No problems').waitFor();
  const mended = await editor.imageOtherThan(plain);
  expect(pixelAt(mended, mended.width >> 1, mended.height >> 1).slice(1)).toEqual([0, 0, 255]);
});
