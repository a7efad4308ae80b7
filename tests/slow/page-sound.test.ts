import { readFile } from 'node:fs/promises';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import type { Browser, Page } from 'playwright-core';
import { compile } from '../../export/compiler/compile.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Program } from '../../export/program/program.ts';
import { type ServedPage, servePage } from '../browser/page-kit.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { decodeImage, pixelAt } from '../support/image.ts';
import { LIBRARY } from '../support/library.ts';

// Chromium's own fake microphone beeps; and its visitor says yes to everything, or no.
const allowing = useBrowser(['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream']);
const refusing = useBrowser(['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream=deny']);

const LOUD = '/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "level", "TYPE": "float" }, { "NAME": "fft", "TYPE": "audioFFT" }] }*/\n';

/** Blue, and as red as it is loud: so red, where there is a tone anywhere in the spectrum. */
const SHADER = `${LOUD}void main() {
  float loudest = 0.0;
  for (int i = 0; i < 64; i++) loudest = max(loudest, IMG_NORM_PIXEL(fft, vec2(float(i) / 64.0, 0.5)).r);
  gl_FragColor = vec4(level > 0.01 && loudest > 0.01 ? 1.0 : 0.0, 0.0, 1.0, 1.0);
}`;

function program(source: object, assets: object = {}): Program {
  const project = JSON.stringify({
    format: 'scrim-project',
    version: 1,
    title: 'Sound',
    graphs: {
      main: {
        nodes: {
          'heard-a1b2': source,
          'loud-a1b2': { type: 'generator/loud', version: 1, params: { level: { port: 0 } } },
          'screen-a1b2': { type: 'output/screen', version: 1 },
        },
        wires: ['heard-a1b2.audio -> loud-a1b2.fft', 'heard-a1b2.level -> loud-a1b2.level', 'loud-a1b2.layer -> screen-a1b2.layer'],
      },
    },
    assets,
  });
  const loaded = loadProject({ project, layout: null, sources: { 'loud.fs': SHADER } });
  if (!loaded.output) throw new Error(JSON.stringify(loaded.diagnostics));
  const { output, diagnostics } = compile({ project: loaded.output, library: LIBRARY, options: { sourceMaps: false } });
  if (!output) throw new Error(JSON.stringify(diagnostics));
  return output;
}

let listening: ServedPage;
let playing: ServedPage;
beforeAll(async () => {
  listening = await servePage(program({ type: 'source/microphone', version: 1 }));
  const chime = { path: 'assets/chime.wav', kind: 'audio' };
  playing = await servePage(program({ type: 'source/audio-file', version: 1, params: { file: 'chime' } }, { chime }), (path) =>
    readFile(`nodes/source/audio-file/example/${path}`),
  );
});
afterAll(async () => {
  await listening.close();
  await playing.close();
});

async function open(browser: Browser, url: string): Promise<{ page: Page; errors: readonly string[] }> {
  const page = await browser.newPage({ viewport: { width: 320, height: 240 } });
  const errors = collectErrors(page);
  await page.addInitScript(() => {
    const asked: unknown[] = [];
    Object.assign(window, { asked });
    // Playwright's own scripts, screenshots among them, count as a visitor's gesture: here only real presses do.
    let hasBeenActive = false;
    window.addEventListener('pointerdown', () => (hasBeenActive = true), true);
    const userActivation = Object.defineProperty({}, 'hasBeenActive', { get: () => hasBeenActive });
    Object.defineProperty(navigator, 'userActivation', { value: userActivation });
    const ask = navigator.mediaDevices.getUserMedia.bind(navigator.mediaDevices);
    navigator.mediaDevices.getUserMedia = (wishes) => {
      asked.push(wishes);
      return ask(wishes);
    };
  });
  await page.goto(url);
  // Blue in any case, once it is drawn.
  await untilPixel(page, ([, , blue]) => blue > 200);
  return { page, errors };
}

type Pixel = readonly [number, number, number, number];

async function corner(page: Page): Promise<Pixel> {
  return pixelAt(decodeImage(await page.screenshot({ clip: { x: 316, y: 4, width: 1, height: 1 } })), 0, 0);
}

/** A image says so, not a time that has passed. */
async function untilPixel(page: Page, isRight: (pixel: Pixel) => boolean): Promise<void> {
  while (!isRight(await corner(page)));
}

function untilRed(page: Page): Promise<void> {
  return untilPixel(page, ([red]) => red > 200);
}

function askedIn(page: Page): Promise<number> {
  return page.evaluate(() => (window as unknown as { asked: unknown[] }).asked.length);
}

describe('an exported page that listens', () => {
  test('says so, asks when it is touched and not before, and shows what it hears', async () => {
    const { page, errors } = await open(allowing.browser, listening.url);
    await expect(page.locator('body').textContent()).resolves.toContain('The microphone');
    expect(await askedIn(page)).toBe(0);
    await page.mouse.click(300, 20);
    await untilRed(page);
    expect(await askedIn(page)).toBe(1);
    expect(errors).toEqual([]);
    await page.close();
  });

  test('goes on in silence for who refuses, and says what to do', async () => {
    const { page } = await open(refusing.browser, listening.url);
    await page.mouse.click(300, 20);
    await page.getByText('The microphone was not allowed.').waitFor();
    expect((await corner(page)).slice(0, 3)).toEqual([0, 0, 255]);
    await page.close();
  });

  test('brings a sound file along and plays it, with no question to anybody', async () => {
    const { page, errors } = await open(allowing.browser, playing.url);
    await untilRed(page);
    expect([await askedIn(page), playing.report.needs]).toEqual([0, []]);
    expect(errors).toEqual([]);
    await page.close();
  });
});
