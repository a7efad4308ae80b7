import { expect, test } from '@jest/globals';
import { LIBRARY } from '../support/library.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';

const COLUMNS = 14;
const SPACING = { x: 264, y: 260 };

/** Each kind of node, and one whose inputs have several wires. */
function everyNode(): GraphText {
  const types = [...LIBRARY.types()].filter((type) => LIBRARY.definition(type)?.lowering.kind !== 'present').sort();
  const ids = types.map((type, i) => [`${type.split('/').at(-1)}-a${i}`, type] as const);
  const idOf = (type: string) => `${type.split('/').at(-1)}-a${types.indexOf(type)}`;
  return {
    nodes: {
      ...Object.fromEntries(ids.map(([id, type]) => [id, { type }])),
      'transform-bbbb': { type: 'objects/transform' },
      'screen-aaaa': { type: 'output/screen' },
    },
    wires: [
      `${idOf('objects/transform')}.objects -> ${idOf('layer/scene')}.objects`,
      `transform-bbbb.objects -> ${idOf('layer/scene')}.objects`,
      `${idOf('source/camera-video')}.layer -> screen-aaaa.layer`,
    ],
    places: Object.fromEntries(
      ['screen-aaaa', 'transform-bbbb', ...ids.map(([id]) => id)].map((id, i) => [
        id,
        [(i % COLUMNS) * SPACING.x, Math.floor(i / COLUMNS) * SPACING.y],
      ]),
    ),
  };
}

const open = useOneEditor(everyNode(), { size: { width: 1024, height: 768 } });

/** In the page: what of the inspector reaches beyond its sides, or is cut off there. */
function overflowing(): string[] {
  const inspector = document.querySelector('.inspector');
  if (!inspector) return ['no inspector'];
  const { left, right } = inspector.getBoundingClientRect();
  return [...inspector.querySelectorAll('*')].flatMap((element) => {
    const box = element.getBoundingClientRect();
    const isHidden = box.width === 0 || element.closest('.visually-hidden') !== null;
    return !isHidden && (box.left < left - 0.5 || box.right > right + 0.5) ? [`${element.tagName}.${element.getAttribute('class')}`] : [];
  });
}

test('whatever node is selected, in a small window, nothing of the inspector is cut off at its sides', async () => {
  const { page } = open;
  const nodes = page.locator('[data-node]');
  await expect(nodes.count()).resolves.toBeGreaterThan(100);
  const found: Record<string, readonly string[]> = {};
  for (const id of await nodes.evaluateAll((all) => all.map((node) => node.getAttribute('data-node') ?? ''))) {
    // By keys: the minimap covers some nodes.
    await page.locator(`.react-flow__node[data-id="${id}"]`).press('Enter');
    await page.locator('.inspector-kind code', { hasText: id }).waitFor();
    const beyond = await page.evaluate(overflowing);
    if (beyond.length > 0) found[id] = beyond;
  }
  expect(found).toEqual({});
});
