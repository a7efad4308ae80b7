import { readdir, readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import { useBrowser } from '../support/browser.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const EXAMPLES = join(ROOT, 'examples');
/** Largest graphs that are opened. */
const COUNT = 3;
const SIZES = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
];

const browser = useBrowser();

test('the largest examples have no text below 11 px when they fit a window', async () => {
  const found: Record<string, unknown> = {};
  for (const name of await largestExamples()) {
    const server = await startServer({ installation: installationAt(ROOT, '0.0.0'), startPath: join(EXAMPLES, name), log: () => {} });
    const page = await browser.browser.newPage({ reducedMotion: 'reduce' });
    // The preview shows nothing of the graph, and would take most of the time.
    await page.route(`${server.previewOrigin}/**`, (route) => route.fulfill({ contentType: 'text/html', body: '' }));
    await page.goto(server.invite());
    await page.locator('.react-flow__node').first().waitFor();
    for (const size of SIZES) {
      await page.setViewportSize(size);
      await page.getByRole('button', { name: 'Fit graph to view' }).click();
      await page.waitForFunction(fitsView);
      found[`${name}, ${size.width} × ${size.height}`] = await page.evaluate(textsOfGraph);
    }
    await page.close();
    await server.close();
  }
  expect(Object.keys(found)).toHaveLength(COUNT * SIZES.length);
  expect(found).toEqual(Object.fromEntries(Object.keys(found).map((name) => [name, { small: [], isDrawn: true }])));
});

/** Runs in the page: whether all nodes are inside the canvas, which takes less than 60 % of their size. */
function fitsView(): boolean {
  const canvas = document.querySelector('.canvas')?.getBoundingClientRect();
  const zoom = Number.parseInt(document.querySelector('.zoom-figure')?.textContent ?? '100', 10);
  if (!canvas || zoom >= 60) return false;
  return [...document.querySelectorAll('[data-node]')].every((node) => {
    const { left, top, right, bottom } = node.getBoundingClientRect();
    return left >= canvas.left && top >= canvas.top && right <= canvas.right && bottom <= canvas.bottom;
  });
}

/** Runs in the page: texts on the canvas below 11 px, and whether each node has a title or an icon that can be seen. */
function textsOfGraph() {
  const canvas = document.querySelector('.react-flow__viewport');
  const zoom = canvas ? new DOMMatrix(getComputedStyle(canvas).transform).a : 0;
  const isSeen = (element: Element | null) =>
    element !== null &&
    element.getBoundingClientRect().width > 0 &&
    element.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  const texts = [...(canvas?.querySelectorAll('*') ?? [])].filter(
    (element) => isSeen(element) && [...element.childNodes].some(({ nodeType, textContent }) => nodeType === 3 && textContent?.trim()),
  );
  const small = texts
    .filter((element) => Number.parseFloat(getComputedStyle(element).fontSize) * zoom < 10.95)
    .map(({ textContent }) => textContent);
  const nodes = [...(canvas?.querySelectorAll('[data-node]') ?? [])];
  const isDrawn = nodes.every((node) => isSeen(node.querySelector('.node-title')) || isSeen(node.querySelector('.category-mark')));
  return { small, isDrawn: isDrawn && nodes.length > 10 };
}

/** Names of the examples whose nodes take the most room. */
async function largestExamples(): Promise<readonly string[]> {
  const sizes: (readonly [name: string, extent: number])[] = [];
  for (const name of await readdir(EXAMPLES)) {
    const text = await readFile(join(EXAMPLES, name, 'project.layout.json'), 'utf8').catch(() => null);
    if (text === null) continue;
    const places = Object.values(JSON.parse(text).graphs.main.nodes as Record<string, { x: number; y: number }>);
    const span = (values: readonly number[]) => Math.max(...values) - Math.min(...values);
    sizes.push([name, Math.max(span(places.map(({ x }) => x)), span(places.map(({ y }) => y)))]);
  }
  return sizes
    .sort(([, a], [, b]) => b - a)
    .slice(0, COUNT)
    .map(([name]) => name);
}
