import type { Locator, Page } from 'playwright-core';
import { centerOf, type Point } from '../lib/center-of.ts';
import { Hands, type Interaction } from './hands.ts';

/** Options of a newcomer script, which uses the editor as a new user would. */
export interface NewcomerOptions {
  /** The editor without an open project, 1440 × 900. */
  readonly page: Page;
  /** Path of the model that is dropped. */
  readonly model: string;
  /** Folders for the project and for the exported page. They do not exist yet. */
  readonly project: string;
  readonly exportTo: string;
  readonly onDone?: (done: Interaction) => Promise<void>;
}

/**
 * Finds parts of the editor by the texts that users read, and performs steps that several scripts need. Nodes are found by the stem of
 * their id.
 */
export interface EditorSteps {
  field(name: string): Locator;
  node(stem: string): Locator;
  port(owner: Locator, name: string, side: 'source' | 'target'): Promise<Point>;
  output(stem: string, name: string): Promise<Point>;
  input(stem: string, name: string): Promise<Point>;
  /** Creates an empty project. Returns a function that converts a position on the canvas to client pixels. */
  newProject(folder: string): Promise<(x: number, y: number) => Point>;
  /** Drags a wire from a port onto the empty canvas, adds the node that the query finds, and waits for a node with the id stem `made`. */
  grow(from: Point, to: Point, query: string, made: string): Promise<void>;
  /** Selects a wire, inserts the node that the query finds, and waits for a node with the id stem `made`. */
  insert(from: Point, to: Point, query: string, made: string): Promise<void>;
  exportTo(folder: string): Promise<void>;
}

const EXPORT_MS = 300_000;

/** The point at a fraction of the straight line between the ends of a wire. The middle lies on the wire, which is symmetric about it. */
export function onWire(from: Point, to: Point, part = 0.5): Point {
  return { x: from.x + part * (to.x - from.x), y: from.y + part * (to.y - from.y) };
}

/**
 * A point on the drawn wire into an input that no node covers, in client pixels; the one nearest the middle.
 *
 * @throws If nodes cover the whole wire, or there is none.
 */
export async function freePointOnWire(page: Page, from: string, input: string): Promise<Point> {
  const point = await page.evaluate(
    ({ wire }) => {
      const path = document.querySelector<SVGPathElement>(wire);
      const matrix = path?.getScreenCTM();
      if (!path || !matrix) return null;
      const parts = Array.from({ length: 19 }, (_, i) => (i + 1) / 20).sort((a, b) => Math.abs(a - 0.5) - Math.abs(b - 0.5));
      for (const part of parts) {
        const { x, y } = path.getPointAtLength(part * path.getTotalLength()).matrixTransform(matrix);
        const all = document.elementsFromPoint(x, y);
        if (all.some((e) => e.closest('.react-flow__edge') !== null) && !all.some((e) => e.closest('.react-flow__node') !== null))
          return { x, y };
      }
      return null;
    },
    { wire: `.react-flow__edge[data-id^="${from}"][data-id$=".${input}"] .react-flow__edge-path` },
  );
  if (point === null) throw new Error(`No free point on a wire from “${from}” to “${input}” was found.`);
  return point;
}

/** How the scripts with a model begin: a new project, in which a dropped model is seen. */
export async function startWithModel({ page, model, project, onDone }: NewcomerOptions) {
  const hands = new Hands(page, onDone ?? (async () => {}));
  const steps = createEditorSteps(page, hands);
  const at = await steps.newProject(project);
  await hands.dropFile('Drop a model', model, at(30, 330));
  await steps.node('scene').waitFor();
  return { hands, at, ...steps };
}

export function createEditorSteps(page: Page, hands: Hands): EditorSteps {
  const field = (name: string) => page.getByRole('textbox', { name, exact: true });
  const node = (stem: string) => page.locator(`[data-node^="${stem}"]`);
  const port = async (owner: Locator, name: string, side: 'source' | 'target'): Promise<Point> => {
    const id = await owner.first().getAttribute('data-node');
    return centerOf(page.locator(`.react-flow__handle.${side}[data-nodeid="${id}"][data-handleid="${name}"]`));
  };
  const add = async (query: string, made: string) => {
    await hands.type(`“${query}”`, query, page.getByRole('combobox', { name: 'Search nodes' }));
    await node(made).first().waitFor();
  };
  return {
    field,
    node,
    port,
    output: (stem, name) => port(node(stem), name, 'source'),
    input: (stem, name) => port(node(stem), name, 'target'),
    newProject: async (folder) => {
      await hands.click('New project', page.getByRole('button', { name: 'New project: Empty' }));
      await hands.type('Its folder', folder, field('Folder'));
      await node('screen').waitFor();
      const canvas = await page.locator('.canvas').boundingBox();
      if (!canvas) throw new Error('There is no canvas.');
      return (x, y) => ({ x: canvas.x + x, y: canvas.y + y });
    },
    grow: async (from, to, query, made) => {
      await hands.drag('Drag a wire from a port', from, to);
      await add(query, made);
    },
    insert: async (from, to, query, made) => {
      await hands.clickAt('Select a wire', onWire(from, to));
      await hands.press('Add a node: Tab', 'Tab');
      await add(query, made);
    },
    exportTo: async (folder) => {
      await hands.click('Export', page.getByRole('button', { name: 'Export', exact: true }));
      await hands.type('Its folder', folder, field('Folder'));
      await page.getByText(/^Exported to/).waitFor({ timeout: EXPORT_MS });
    },
  };
}
