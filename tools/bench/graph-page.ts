import { once } from 'node:events';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import type { Point } from '../lib/center-of.ts';
import type { GridGraph } from './grid-graph.ts';
import { openServer } from './open-page.ts';

export interface GraphPage {
  readonly page: Page;
  close(): Promise<void>;
}

/** Opens the editor with a project of one graph. */
export async function openGraph(root: string, browser: Browser, graph: GridGraph): Promise<GraphPage> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
  await writeProject(folder, graph);
  const { server, url } = await openServer(root, folder);
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  const close = async () => {
    await page.close();
    server.kill();
    await once(server, 'exit');
    await rm(folder, { recursive: true, force: true });
  };
  try {
    await page.goto(url);
    await page.locator('.react-flow__node').first().waitFor();
  } catch (error) {
    await close();
    throw error;
  }
  return { page, close };
}

async function writeProject(folder: string, { nodes, wires, places }: GridGraph): Promise<void> {
  const graph = { nodes: Object.fromEntries(Object.entries(nodes).map(([id, node]) => [id, { ...node, version: 1 }])), wires };
  const layout = { nodes: Object.fromEntries(Object.entries(places).map(([id, [x, y]]) => [id, { x, y }])) };
  const write = (file: string, content: object) => writeFile(join(folder, file), JSON.stringify(content));
  await write('project.scrim.json', { format: 'scrim-project', version: 1, title: 'Grid', graphs: { main: graph } });
  await write('project.layout.json', { format: 'scrim-layout', version: 1, graphs: { main: layout } });
}

/** Zooms in to one node. Returns a point on its title. */
export async function zoomToNode(page: Page, id: string): Promise<Point> {
  await page.locator(`[data-node="${id}"]`).click();
  await page.keyboard.press('Shift+F');
  const title = page.locator(`[data-node="${id}"] .node-title`);
  await page.waitForFunction((node) => (document.querySelector(`[data-node="${node}"]`)?.getBoundingClientRect().width ?? 0) > 150, id);
  const box = await title.boundingBox();
  if (!box) throw new Error('The node is not on screen.');
  return { x: box.x + 8, y: box.y + box.height / 2 };
}
