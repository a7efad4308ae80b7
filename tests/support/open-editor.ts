import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { afterAll, afterEach, beforeAll, expect } from '@jest/globals';
import type { Browser, Page } from 'playwright-core';
import { startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import { collectErrors, useBrowser } from './browser.ts';
import { EditorDriver } from './editor-driver.ts';

const ROOT = resolve(import.meta.dirname, '../..');

export interface OpenEditor {
  readonly page: Page;
  readonly editor: EditorDriver;
  /** Absolute path. */
  readonly project: string;
  readonly errors: readonly string[];
  close(): Promise<void>;
}

export interface GraphText {
  readonly nodes: Readonly<Record<string, { readonly type: string; readonly params?: Readonly<Record<string, unknown>> }>>;
  readonly wires: readonly string[];
  readonly places: Readonly<Record<string, readonly [x: number, y: number]>>;
  /** Shaders of the project, by file name. */
  readonly shaders?: Readonly<Record<string, string>>;
  readonly assets?: Readonly<Record<string, { readonly path: string; readonly kind: string }>>;
  /** Files in `assets/`. */
  readonly assetFiles?: Readonly<Record<string, Uint8Array>>;
}

export interface EditorPageOptions {
  readonly size?: { readonly width: number; readonly height: number };
  readonly colorScheme?: 'light' | 'dark';
  /** Emulates touch input, as on a tablet. */
  readonly hasTouch?: boolean;
  /** Runs before all scripts of the page and of the preview. */
  readonly before?: () => void;
  /**
   * `small`: a wide graph beside a small preview that fills its panel, which tests of both draw in the same time on all machines.
   * Default: `small`.
   */
  readonly panels?: 'small' | 'usual';
  /** Opens the project as one that was left playing. False: as for the first time, so recordings stand at their first frame. Default: true. */
  readonly playing?: boolean;
  /** Whether the projects folder is an own one, `projects` in the project, instead of that of the person. Default: false. */
  readonly ownProjects?: boolean;
}

/** Opens the built editor on loopback with a project of one graph in its own folder. */
export async function openEditor(browser: Browser, graph: GraphText, options: EditorPageOptions = {}): Promise<OpenEditor> {
  const {
    size = { width: 1440, height: 900 },
    colorScheme = 'light',
    hasTouch = false,
    before,
    panels = 'small',
    playing = true,
    ownProjects = false,
  } = options;
  const project = await mkdtemp(join(tmpdir(), 'scrim-editor-'));
  for (const [path, text] of Object.entries(filesOf(graph))) {
    await mkdir(dirname(join(project, path)), { recursive: true });
    await writeFile(join(project, path), text);
  }
  const log = (message: string) => process.stderr.write(`${message}\n`);
  const installed = installationAt(ROOT, '0.0.0');
  const installation = ownProjects ? { ...installed, projectsDir: join(project, 'projects') } : installed;
  const server = await startServer({ installation, startPath: project, log });
  // Animations would only slow down tests.
  const page = await browser.newPage({ viewport: size, colorScheme, hasTouch, reducedMotion: 'reduce' });
  if (before) await page.addInitScript(before);
  if (playing) await page.addInitScript(storeLeftPlaying, project);
  if (panels === 'small') await page.addInitScript(storePanels, size.width < 1200 ? SMALLEST_PANELS : SMALL_PANELS);
  const errors = collectErrors(page);
  await page.goto(server.invite());
  await page.locator('.react-flow__node').first().waitFor();
  return {
    page,
    editor: new EditorDriver(page),
    project,
    errors,
    close: async () => {
      await page.close();
      await server.close();
      await rm(project, { recursive: true, force: true });
    },
  };
}

const SMALL_PANELS = { sideWidthPx: 413, previewHeightPx: 330, bottomHeightPx: 280, helpWidthPx: 300, frame: 'fill' };
const SMALLEST_PANELS = { sideWidthPx: 363, previewHeightPx: 270, bottomHeightPx: 250, helpWidthPx: 240, frame: 'fill' };

/** Runs in the page. Sizes that a test has changed stay when it reloads the page. */
function storePanels(sizes: Readonly<Record<string, number | string>>): void {
  if (window.top === window && localStorage.getItem('scrim-panels') === null) localStorage.setItem('scrim-panels', JSON.stringify(sizes));
}

/** Runs in the page. */
function storeLeftPlaying(project: string): void {
  if (window.top !== window || localStorage.getItem('scrim-views') !== null) return;
  localStorage.setItem('scrim-views', JSON.stringify([[project, { graph: 'main', place: null, nodes: [], held: null }]]));
}

/** Opens editors, one per test. Each is closed after its test; console errors fail the test. */
export function useEditor(): (graph: GraphText, options?: EditorPageOptions) => Promise<OpenEditor> {
  const chromium = useBrowser();
  let open: OpenEditor | null = null;
  afterEach(async () => {
    const errors = open?.errors ?? [];
    await open?.close();
    open = null;
    expect(errors).toEqual([]);
  });
  return async (graph, options) => {
    open = await openEditor(chromium.browser, graph, options);
    return open;
  };
}

export interface OneEditor extends Omit<OpenEditor, 'close'> {
  readonly browser: Browser;
}

/**
 * Opens one editor for all tests of a file, which continue from each other. Console errors fail the file.
 *
 * @param begin Runs before the first test.
 * @param switches Additional switches of Chromium.
 */
export function useOneEditor(
  graph: GraphText,
  options: EditorPageOptions & { readonly switches?: readonly string[] },
  begin: () => Promise<unknown> = async () => {},
): OneEditor {
  const chromium = useBrowser(options.switches);
  let open: OpenEditor | null = null;
  const opened = () => {
    if (!open) throw new Error('The editor is only there inside tests.');
    return open;
  };
  beforeAll(async () => {
    open = await openEditor(chromium.browser, graph, options);
    await begin();
  });
  afterAll(async () => {
    const errors = open?.errors ?? [];
    await open?.close();
    expect(errors).toEqual([]);
  });
  return {
    get browser() {
      return chromium.browser;
    },
    get page() {
      return opened().page;
    },
    get editor() {
      return opened().editor;
    },
    get project() {
      return opened().project;
    },
    get errors() {
      return opened().errors;
    },
  };
}

export interface SavedGraph {
  readonly nodes: Readonly<Record<string, { readonly type: string; readonly params?: Readonly<Record<string, unknown>> }>>;
  readonly wires: readonly string[];
  readonly exposed?: { readonly inputs: readonly object[]; readonly outputs: readonly object[] };
}

/** Saves by keys, and returns the graphs of the project file. */
export async function saveGraphs({ page, project }: Pick<OpenEditor, 'page' | 'project'>): Promise<Readonly<Record<string, SavedGraph>>> {
  await page.keyboard.press('Control+s');
  await page.locator('.unsaved').waitFor({ state: 'detached' });
  return JSON.parse(await readFile(join(project, 'project.scrim.json'), 'utf8')).graphs;
}

function filesOf({ nodes, wires, places, shaders = {}, assets = {}, assetFiles = {} }: GraphText): Record<string, string | Uint8Array> {
  const whole = Object.fromEntries(Object.entries(nodes).map(([id, node]) => [id, { version: 1, ...node }]));
  const layout = Object.fromEntries(Object.entries(places).map(([id, [x, y]]) => [id, { x, y }]));
  return {
    'project.scrim.json': JSON.stringify({
      format: 'scrim-project',
      version: 1,
      title: 'Test',
      graphs: { main: { nodes: whole, wires } },
      assets,
    }),
    'project.layout.json': JSON.stringify({ format: 'scrim-layout', version: 1, graphs: { main: { nodes: layout } } }),
    ...Object.fromEntries(Object.entries(shaders).map(([name, text]) => [`shaders/${name}`, text])),
    ...Object.fromEntries(Object.entries(assetFiles).map(([name, bytes]) => [`assets/${name}`, bytes])),
  };
}
