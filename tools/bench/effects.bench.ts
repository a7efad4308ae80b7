import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import type { Program } from '../../export/program/program.ts';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, quantile } from './bench.ts';
import { compiledProgram } from './compiled-program.ts';
import { frameCpuMs, openProgram, SIZE_PX, testImage } from './drawn-program.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';
import type { Contender } from './pages/effects.page.ts';

const SAMPLES = 9;

/** Eight small effects of straight colors. */
const EFFECTS = [
  'vec3 effect0(vec3 c) { return c * vec3(1.05, 1.0, 0.9); }',
  'vec3 effect1(vec3 c) { return (c - 0.5) * 1.2 + 0.5; }',
  'vec3 effect2(vec3 c) { return mix(vec3(dot(c, vec3(0.2126, 0.7152, 0.0722))), c, 0.7); }',
  'vec3 effect3(vec3 c) { return pow(max(c, 0.0), vec3(0.9)); }',
  'vec3 effect4(vec3 c) { return floor(c * 24.0 + 0.5) / 24.0; }',
  'vec3 effect5(vec3 c) { return c + 0.05 * (1.0 - c); }',
  'vec3 effect6(vec3 c) { return mix(c, vec3(1.0, 0.9, 0.7) * c, 0.5); }',
  'vec3 effect7(vec3 c) { return 1.0 - (1.0 - c) * (1.0 - c * 0.1); }',
];
const CONTENDERS: readonly Contender[] = ['by hand', 'by hand, any alpha', 'postprocessing', 'EffectComposer'];
const NAMES = ['fused', 'one pass per effect', ...CONTENDERS] as const;
type Name = (typeof NAMES)[number];

/**
 * Largest difference of a color channel from the fused image, in 8-bit steps. The libraries neither round nor clamp between effects; a step
 * of `effect4` is 11.
 */
const MOST_STEPS: Readonly<Record<Name, number>> = {
  fused: 0,
  'one pass per effect': 1,
  'by hand': 1,
  'by hand, any alpha': 0,
  postprocessing: 24,
  EffectComposer: 24,
};

/**
 * Milliseconds per frame of eight effects over an image of 1280 × 720 pixels: as Scrim exports them, with one pass per effect, in one shader
 * written by hand for opaque images and for all images, in one pass of pmndrs/postprocessing, and in three.js' EffectComposer. All are
 * measured in turn; with `/proc`, by CPU time (ADR 25).
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  let opened: Promise<Stage> | undefined;
  const timesMs = new Map<Name, number[]>(NAMES.map((name) => [name, []]));
  const median = (name: Name): number =>
    quantile(
      [...(timesMs.get(name) ?? [])].slice(1).sort((a, b) => a - b),
      0.5,
    );
  const race = async (): Promise<void> => {
    opened ??= openStage(root);
    const { pages } = await opened;
    for (const [name, page] of pages) timesMs.get(name)?.push(await frameCpuMs(page));
  };
  const rival = (name: Name): Bench => ({
    name: `8 effects over 720p, fused against ${name}`,
    unit: 'ratio',
    samples: 1,
    sample: () => median('fused') / median(name),
  });
  return [
    {
      name: '8 effects over 720p, fused',
      unit: 'ms',
      samples: SAMPLES,
      sample: async () => {
        await race();
        return timesMs.get('fused')?.at(-1) ?? Number.NaN;
      },
    },
    ...NAMES.slice(1, -1).map(rival),
    {
      ...rival('EffectComposer'),
      notes: async () => {
        const { passes } = (await opened) ?? { passes: [] };
        return `8 effects over 720p: ${passes.join(', ')}. Scrim's last pass fits the image to the view.`;
      },
      dispose: async () => (await opened)?.close(),
    },
  ];
}

interface Stage {
  readonly pages: ReadonlyMap<Name, Page>;
  /** Passes of each contender, for people. */
  readonly passes: readonly string[];
  close(): Promise<void>;
}

async function openStage(root: string): Promise<Stage> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
  await writeFile(join(folder, 'photo.png'), testImage());
  const browser = await startBenchBrowser();
  const pages = new Map<Name, Page>();
  const programs = { fused: await compiled(folder, true), 'one pass per effect': await compiled(folder, false) };
  for (const [name, program] of Object.entries(programs)) pages.set(name as Name, await openProgram(browser, root, folder, program));
  for (const name of CONTENDERS) {
    const page = await openPage(browser, root, 'tools/bench/pages/effects.page.ts', folder);
    await call(page, 'open', name, 'photo.png', ...SIZE_PX, EFFECTS);
    pages.set(name, page);
  }
  await expectSameImages(pages);
  const passes = Object.entries(programs).map(([name, { operations }]) => `${passCount(operations)} passes ${name}`);
  return {
    pages,
    passes: [...passes, '1 pass each by hand and with postprocessing', `${EFFECTS.length + 1} passes with EffectComposer`],
    close: async () => {
      await browser.close();
      await rm(folder, { recursive: true, force: true });
    },
  };
}

const passCount = (operations: Program['operations']): number => operations.filter(({ kind }) => kind === 'pass').length;

async function compiled(folder: string, fuse: boolean): Promise<Program> {
  const ids = EFFECTS.map((_, i) => `effect${i}-0000`);
  const nodes = Object.fromEntries(ids.map((id, i) => [id, { type: `filter/effect-${i}`, version: 1 }]));
  const chain = ['photo-0000', ...ids, 'screen-0000'];
  const project = {
    format: 'scrim-project',
    version: 1,
    title: 'Eight effects',
    graphs: {
      main: {
        nodes: {
          'photo-0000': { type: 'source/image-file', version: 1, params: { file: 'photo' } },
          ...nodes,
          'screen-0000': { type: 'output/screen', version: 1 },
        },
        wires: chain.slice(1).map((id, i) => `${chain[i]}.layer -> ${id}.${id.startsWith('screen') ? 'layer' : 'inputImage'}`),
      },
    },
    assets: { photo: { path: 'photo.png', kind: 'image' } },
  };
  const sources = Object.fromEntries(EFFECTS.map((text, i) => [`effect-${i}.fs`, filterOf(text, i)]));
  return compiledProgram(folder, { project: JSON.stringify(project), layout: null, sources }, { fuse });
}

function filterOf(effect: string, index: number): string {
  const header = {
    ISFVSN: '2',
    DESCRIPTION: 'Changes colors.',
    CREDIT: 'Scrim',
    INPUTS: [{ NAME: 'inputImage', TYPE: 'image', LABEL: 'Layer', DOC: 'The layer.' }],
  };
  return `/*${JSON.stringify(header)}*/
${effect}
void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(effect${index}(color.rgb), color.a);
}
`;
}

/** Throws if a contender does not draw the image that the others draw. */
async function expectSameImages(pages: ReadonlyMap<Name, Page>): Promise<void> {
  for (const [x, y] of [
    [100, 100],
    [640, 300],
    [1200, 600],
  ] as const) {
    const colors = await Promise.all([...pages].map(async ([name, page]) => [name, await call<number[]>(page, 'pixelAt', x, y)] as const));
    const [, first] = colors[0] ?? ['', []];
    for (const [name, color] of colors) {
      if (color.some((value, i) => Math.abs(value - (first[i] ?? 0)) > MOST_STEPS[name])) {
        throw new Error(`The contenders draw different colors at (${x}, ${y}): ${JSON.stringify(colors)}`);
      }
    }
  }
}
