import { mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { ALL_FORMATS, BufferSource, type EncodedPacket, EncodedPacketSink, Input } from 'mediabunny';
import { useBrowser } from '../support/browser.ts';
import { chooseOption } from '../support/choose-option.ts';
import { FLAG_PX } from '../support/editor-driver.ts';
import { decodeImage, type RgbaImage } from '../support/image.ts';
import { keyframedSepia } from '../support/keyframed-sepia.ts';
import { type GraphText, type OpenEditor, openEditor } from '../support/open-editor.ts';
import { countDifferent } from '../support/pixels.ts';
import { succeed } from '../support/scrim.ts';

/** The camera's image in a tone that keyframes change, and grain that is another one in every frame and moves with a count of pulses. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': keyframedSepia({ timeS: 0, value: 0, easing: 'linear' }, { timeS: 3, value: 1, easing: 'linear' }),
    'sand-aaaa': { type: 'filter/sand' },
    'every-aaaa': { type: 'pulse/every', params: { periodS: 0.3 } },
    'count-aaaa': { type: 'value/counter' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'video-aaaa.layer -> sepia-aaaa.inputImage',
    'sepia-aaaa.layer -> sand-aaaa.inputImage',
    'sand-aaaa.layer -> screen-aaaa.layer',
    'every-aaaa.pulse -> count-aaaa.up',
    'count-aaaa.number -> sand-aaaa.steps',
  ],
  places: {
    'video-aaaa': [0, 0],
    'sepia-aaaa': [220, 0],
    'sand-aaaa': [440, 0],
    'screen-aaaa': [660, 0],
    'every-aaaa': [0, 200],
    'count-aaaa': [220, 200],
  },
  shaders: {
    'sand.fs': `/*{ "DESCRIPTION": "Grain", "ISFVSN": "2", "CATEGORIES": ["Test"], "INPUTS": [
  { "NAME": "inputImage", "TYPE": "image" },
  { "NAME": "steps", "TYPE": "float", "MIN": 0, "MAX": 100 }
] }*/
void main() {
  vec2 cell = floor(isf_FragNormCoord * 40.0) + float(FRAMEINDEX) * vec2(17.0, 31.0) + steps * vec2(5.0, 3.0);
  float grain = fract(sin(dot(cell, vec2(12.9898, 78.233))) * 43758.5453);
  gl_FragColor = IMG_THIS_PIXEL(inputImage) * (0.8 + 0.2 * grain);
}
`,
  },
};

const browser = useBrowser();
let open: OpenEditor;
beforeAll(async () => {
  open = await openEditor(browser.browser, GRAPH, { colorScheme: 'dark' });
  await open.editor.settled();
  await open.editor.press('Pause');
});
afterAll(async () => {
  // The browser itself says so of every call that is refused.
  expect(open.errors.filter((error) => !error.includes('422'))).toEqual([]);
  await open.close();
  for (const kind of ['frames', 'frames-cli', 'video', 'foreign', 'cancelled', 'room', 'room-cli', 'room-turned'])
    await rm(`${open.project}-${kind}`, { recursive: true, force: true });
});

const dialog = () => open.page.getByRole('dialog', { name: 'Render frames' });

/** Opens the dialogue by keys, and fills it in. */
async function ask(fields: Readonly<Record<string, string>>, as?: 'video'): Promise<void> {
  const { page } = open;
  await page.keyboard.press('Control+Shift+E');
  await dialog().waitFor();
  if (as) await chooseOption(dialog().getByRole('combobox', { name: 'Format' }), as);
  for (const [name, text] of Object.entries(fields)) await dialog().getByRole('textbox', { name, exact: true }).fill(text);
}

async function read(path: string): Promise<RgbaImage> {
  return decodeImage(await readFile(path));
}

test('pictures are those of the command line from frame 0 and of the preview, byte for byte', async () => {
  const { page, editor, project } = open;
  const size = await page.locator('iframe[title="Preview"]').boundingBox();
  if (!size) throw new Error('There is no preview.');
  const [width, height] = [Math.round(size.width), Math.round(size.height)];
  const out = `${project}-frames`;
  await ask({ 'First frame': '11', 'Last frame': '13', Width: String(width), Height: String(height), Folder: out });
  expect(await dialog().getByRole('status').textContent()).toContain('3 frames, 0.30 s.');
  if (process.env.SHOT) await page.screenshot({ path: '/tmp/hd-render-dialog.png' });
  await page.keyboard.press('Enter');
  await page.getByText('Rendered 3 frames to').waitFor();
  expect((await readdir(out)).sort()).toEqual(['000011.png', '000012.png', '000013.png', 'sequence.json']);

  const session = resolve(import.meta.dirname, '../../examples/sessions/studio');
  const mine = `${out}-cli`;
  await succeed('render', project, '--out', mine, '--frames', '0..13', '--size', `${width}x${height}`, '--session', session);
  for (const name of ['000011.png', '000012.png', '000013.png']) {
    expect(Buffer.compare(await readFile(join(out, name)), await readFile(join(mine, name)))).toBe(0);
  }
  const [first, second] = [await read(join(out, '000011.png')), await read(join(out, '000012.png'))];
  expect(countDifferent(first, second).pixels).toBeGreaterThan(1000);

  await editor.press('Go to first frame');
  for (let i = 0; i < 12; i++) await editor.press('Next frame');
  await page.waitForFunction(() => document.querySelector('.transport-time span')?.textContent === '12');
  const shown = await editor.restingImage();
  const whole = { ...second, height: second.height - FLAG_PX, data: second.data.slice(second.width * FLAG_PX * 4) };
  expect([shown.width, shown.height]).toEqual([whole.width, whole.height]);
  expect(countDifferent(shown, whole).pixels).toBe(0);
});

test('a video has every frame once, in its time', async () => {
  const { page } = open;
  await ask({ 'First frame': '3', 'Last frame': '8', Width: '320', Height: '240' }, 'video');
  const waiting = page.waitForEvent('download');
  await page.keyboard.press('Enter');
  const download = await waiting;
  expect(download.suggestedFilename()).toMatch(/^Test\.(mp4|webm)$/);
  const input = new Input({ source: new BufferSource(await readFile(await download.path())), formats: ALL_FORMATS });
  const track = await input.getPrimaryVideoTrack();
  if (!track) throw new Error('There is no picture in the video.');
  const packets: EncodedPacket[] = [];
  for await (const packet of new EncodedPacketSink(track).packets()) packets.push(packet);
  expect([track.displayWidth, track.displayHeight]).toEqual([320, 240]);
  // Milliseconds are what WebM counts in.
  expect(packets.map(({ timestamp }) => timestamp)).toEqual([0, 0.1, 0.2, 0.3, 0.4, 0.5].map((s) => expect.closeTo(s, 3)));
  expect(packets[0]?.type).toBe('key');
  expect(await input.computeDuration()).toBeCloseTo(0.6, 2);
});

test('a folder that holds other things is left alone; a cancelled rendering leaves nothing', async () => {
  const { page, project } = open;
  const foreign = `${project}-foreign`;
  await mkdir(foreign);
  await writeFile(join(foreign, 'mine.txt'), 'mine');
  await ask({ 'First frame': '0', 'Last frame': '1', Folder: foreign });
  await page.keyboard.press('Enter');
  await page.getByText('holds files that Scrim did not write').first().waitFor();
  expect(await readdir(foreign)).toEqual(['mine.txt']);

  // The second frame is held until the person has cancelled.
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  let count = 0;
  await page.route('**/api/call/frames.add', async (route) => {
    if (++count === 2) await held;
    await route.continue();
  });
  try {
    const out = `${project}-cancelled`;
    await ask({ 'First frame': '0', 'Last frame': '30', Folder: out });
    await page.keyboard.press('Enter');
    await page.getByText('Frame 2 of 31').waitFor();
    await page.getByRole('button', { name: 'Cancel', exact: true }).click();
    release();
    await page.getByText('Rendering canceled.').waitFor();
    await page.getByRole('button', { name: 'Export', exact: true }).first().waitFor();
    const parent = join(project, '..');
    const begun = project.split('/').at(-1) ?? '';
    await expectNone(parent, `${begun}-cancelled`);
  } finally {
    release();
    await page.unroute('**/api/call/frames.add');
  }
});

test('an emulated room is rendered from where the preview stands: at first, where the command line stands, too', async () => {
  const { page, editor, project } = open;
  await chooseOption(page.getByRole('combobox', { name: 'Preview source' }), 'room/studio');
  await editor.settled();
  const [out, turned, mine] = [`${project}-room`, `${project}-room-turned`, `${project}-room-cli`];
  const fields = { 'First frame': '1', 'Last frame': '2', Width: '160', Height: '120' };
  await ask({ ...fields, Folder: out });
  await chooseOption(dialog().getByRole('combobox', { name: 'Frame rate (fps)' }), '60');
  expect(await dialog().getByRole('status').textContent()).toContain(
    '2 frames, 0.03 s. Frames show the room from the preview’s current position',
  );
  await dialog().getByRole('button', { name: 'Render', exact: true }).click();
  await page.getByText(`Rendered 2 frames to ${out}`).waitFor();
  expect((await readdir(out)).sort()).toEqual(['000001.png', '000002.png', 'sequence.json']);
  await succeed('render', project, '--out', mine, '--frames', '1..2', '--size', '160x120', '--session', 'room:studio');
  const [first, same] = [await read(join(out, '000002.png')), await read(join(mine, '000002.png'))];
  // Where one stands has gone through 32-bit numbers.
  expect(countDifferent(first, same, 8).pixels).toBeLessThan(40);

  const frame = await page.locator('iframe[title="Preview"]').boundingBox();
  if (!frame) throw new Error('There is no preview.');
  const middle = { x: frame.x + frame.width / 2, y: frame.y + frame.height / 2 };
  await editor.press('Play');
  await editor.drag(middle, { x: middle.x + 120, y: middle.y });
  await editor.hold();
  await ask({ ...fields, Folder: turned });
  await page.keyboard.press('Enter');
  await page.getByText(`Rendered 2 frames to ${turned}`).waitFor();
  expect(countDifferent(first, await read(join(turned, '000002.png')), 8).pixels).toBeGreaterThan(5000);

  await ask(fields, 'video');
  const waiting = page.waitForEvent('download');
  await page.keyboard.press('Enter');
  const input = new Input({ source: new BufferSource(await readFile(await (await waiting).path())), formats: ALL_FORMATS });
  const track = await input.getPrimaryVideoTrack();
  expect([track?.displayWidth, track?.displayHeight]).toEqual([160, 120]);
  expect(await input.computeDuration()).toBeCloseTo(2 / 30, 2);
});

/** Of a folder, or of what was being made for it. */
async function expectNone(parent: string, start: string): Promise<void> {
  const endMs = Date.now() + 60_000;
  while ((await readdir(parent)).some((name) => name.startsWith(start))) {
    if (Date.now() > endMs) throw new Error('Something is left of it.');
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}
