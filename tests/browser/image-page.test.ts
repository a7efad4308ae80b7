import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import sharp from 'sharp';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { twins } from '../support/fusion-kit.ts';
import { decodeImage, pixelAt } from '../support/image.ts';
import { eventually } from '../support/patience.ts';
import { type ServedPage, servePage } from './page-kit.ts';

const chromium = useBrowser();

const node = (type: string, params: object = {}) => ({ type, version: 1, params });

/** A photograph with more effects than most pages have: passes of several kinds, a curve, a gradient, a mask and a slider. */
const NODES = {
  'photo-a': node('source/image-file', { file: 'photo' }),
  'slider-a': node('input/slider', { label: 'Warmth', value: 0 }),
  'blur-a': node('filter/gaussian-blur', { radius: 2 }),
  'bloom-a': node('filter/bloom'),
  'curves-a': node('filter/curves'),
  'map-a': node('filter/gradient-map'),
  'skin-a': node('filter/skin-mask'),
  'choose-a': node('operator/choose-by-mask'),
  'sepia-a': node('filter/sepia'),
};
const WIRES = [
  'photo-a.layer -> blur-a.inputImage',
  'blur-a.layer -> bloom-a.inputImage',
  'bloom-a.layer -> curves-a.inputImage',
  'curves-a.layer -> choose-a.inside',
  'photo-a.layer -> skin-a.inputImage',
  'photo-a.layer -> map-a.inputImage',
  'skin-a.layer -> choose-a.mask',
  'curves-a.layer -> choose-a.outside',
  'map-a.layer -> sepia-a.inputImage',
  'choose-a.layer -> sepia-b.inputImage',
  'slider-a.number -> sepia-b.amount',
  'sepia-b.layer -> screen-a.layer',
];

const photo = () =>
  sharp({ create: { width: 64, height: 48, channels: 3, background: { r: 40, g: 90, b: 200 } } })
    .jpeg()
    .toBuffer();

let served: ServedPage;
beforeAll(async () => {
  const { fused } = twins({ ...NODES, 'sepia-b': node('filter/sepia') }, WIRES, {}, { opaqueImages: ['photo'], fold: true });
  served = await servePage({ ...fused, title: 'A photograph' }, photo);
});
afterAll(() => served.close());

describe('a page that filters a photograph', () => {
  test('has at most 30 KB of script', () => {
    const scripts = served.report.files.filter(({ kind }) => kind === 'script');
    expect(scripts.map(({ path }) => path.split('-')[0])).toEqual(['page']);
    expect(scripts.reduce((sum, { gzip }) => sum + gzip, 0)).toBeLessThanOrEqual(30_000);
  });

  test('contains nothing of the sessions that it does not offer, and its report says why', () => {
    const { modules, tiers, devices, note } = served.report;
    expect(Object.keys(modules.page).filter((file) => /webxr|sessions.camera|room-panel/.test(file))).toEqual([]);
    expect(modules.sessions).toBeNull();
    expect(tiers).toEqual([{ id: 'orbit', without: [] }]);
    expect(new Set(devices.map(({ tier }) => tier))).toEqual(new Set(['orbit']));
    expect(note).toContain('covers the view');
  });

  test('shows its image and its control, and neither a button nor a word of AR', async () => {
    const page = await chromium.browser.newPage({ viewport: { width: 640, height: 480 } });
    const errors = collectErrors(page);
    await page.goto(served.url);
    const slider = page.getByRole('slider', { name: 'Warmth' });
    await slider.waitFor();
    const shown = async () => pixelAt(decodeImage(await page.screenshot()), 320, 40);
    await eventually(async () => expect((await shown())[2]).toBeGreaterThan(180));
    expect(await page.getByRole('button').allTextContents()).toEqual(['', 'Controls']);
    expect(await page.locator('main').textContent()).not.toMatch(/\bAR\b|\bVR\b|camera|browser/i);
    await slider.fill('1');
    await eventually(async () => expect((await shown())[2]).toBeLessThan(120));
    expect(errors).toEqual([]);
    await page.close();
  });
});

describe('a page that filters an image with transparency', () => {
  const passes = Object.fromEntries(Object.entries(NODES).filter(([id]) => !['slider-a', 'curves-a', 'map-a', 'sepia-a'].includes(id)));
  const wires = [
    'photo-a.layer -> blur-a.inputImage',
    'blur-a.layer -> bloom-a.inputImage',
    'bloom-a.layer -> choose-a.inside',
    'photo-a.layer -> skin-a.inputImage',
    'skin-a.layer -> choose-a.mask',
    'blur-a.layer -> choose-a.outside',
    'choose-a.layer -> sepia-b.inputImage',
    'sepia-b.layer -> screen-a.layer',
  ];

  test('has at most 30 KB of script, with the sessions in which the room shows through', async () => {
    const { fused } = twins({ ...passes, 'sepia-b': node('filter/sepia') }, wires, {}, { fold: true });
    const page = await servePage({ ...fused, title: 'A cutout' }, photo);
    const scripts = page.report.files.filter(({ kind }) => kind === 'script');
    expect(scripts.map(({ path }) => path.split('-')[0]).sort()).toEqual(['page', 'sessions']);
    expect(scripts.reduce((sum, { gzip }) => sum + gzip, 0)).toBeLessThanOrEqual(30_000);
    await page.close();
  });
});
