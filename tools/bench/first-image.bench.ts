import { copyFile, cp, mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser } from 'playwright-core';
import { exportProject } from '../../app/services/export-project.ts';
import { installationAt } from '../../app/services/installation.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { BARE_HTML, bundleBarePage } from './bare-page.ts';
import { type Bench, quantile } from './bench.ts';
import { startBenchBrowser } from './open-page.ts';
import { visitSlowly } from './slow-visit.ts';
import { hostFolder, type StaticHost } from './static-host.ts';

const CPU_SLOWNESS = 4;
const SAMPLES = 7;

/** Times since the start of the navigation, milliseconds. */
interface Shown {
  readonly poster: number;
  /** The first frame that the canvas shows, without the poster over it. */
  readonly image: number;
}

/**
 * Time until the first example shows its first drawn frame, over a slow network on a slow processor, and that of a page that does the same
 * in plain three.js. Both are hosted alike and visited in turn, each time without a cache.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  let opened: Promise<Stage> | undefined;
  const seen = { ours: [] as Shown[], bare: [] as Shown[] };
  const race = async (): Promise<void> => {
    opened ??= openStage(root);
    const { browser, ours, bare } = await opened;
    seen.ours.push(await visitSlowly<Shown>(browser, ours.url, CPU_SLOWNESS, watchImages));
    seen.bare.push(await visitSlowly<Shown>(browser, bare.url, CPU_SLOWNESS, watchImages));
  };
  const median = (times: readonly Shown[], of: (shown: Shown) => number): number =>
    quantile(
      times
        .slice(1)
        .map(of)
        .sort((a, b) => a - b),
      0.5,
    );
  const image = ({ image }: Shown): number => image;
  const afterPoster = ({ image, poster }: Shown): number => image - poster;
  const row = (name: string, unit: Bench['unit'], of: () => number): Bench => ({ name, unit, samples: 1, sample: of });
  return [
    {
      name: 'first image over 1.6 Mbit/s, first-light',
      unit: 'ms',
      samples: SAMPLES,
      sample: async () => {
        await race();
        return seen.ours.at(-1)?.image ?? Number.NaN;
      },
    },
    row('first image over 1.6 Mbit/s, bare page', 'ms', () => median(seen.bare, image)),
    row('first image over 1.6 Mbit/s, against the bare page', 'ratio', () => median(seen.ours, image) / median(seen.bare, image)),
    row('from poster to first image over 1.6 Mbit/s, first-light', 'ms', () => median(seen.ours, afterPoster)),
    {
      ...row('from poster to first image over 1.6 Mbit/s, bare page', 'ms', () => median(seen.bare, afterPoster)),
      dispose: async () => (await opened)?.close(),
    },
  ];
}

interface Stage {
  readonly browser: Browser;
  readonly ours: StaticHost;
  readonly bare: StaticHost;
  close(): Promise<void>;
}

async function openStage(root: string): Promise<Stage> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
  const folder = join(base, 'project');
  await cp(join(root, 'examples/first-light'), folder, { recursive: true });
  const out = join(base, 'ours');
  const poster = { bytes: await posterImage(root), type: 'jpg', widthPx: 1200, heightPx: 630, drawn: true } as const;
  const { report } = await exportProject({
    root: folder,
    projectFiles: await readProjectFiles(folder),
    out,
    installation: installationAt(root, '0.0.0'),
    drawPoster: async () => poster,
  });
  if (report === null) throw new Error('The first example cannot be exported.');
  const bareFolder = join(base, 'bare');
  await mkdir(bareFolder);
  await writeFile(join(bareFolder, 'index.html'), BARE_HTML);
  await writeFile(join(bareFolder, 'bare.js'), await bundleBarePage(root));
  await writeFile(join(bareFolder, 'poster.jpg'), poster.bytes);
  await copyFile(join(folder, 'assets/robot.glb'), join(bareFolder, 'robot.glb'));
  const browser = await startBenchBrowser();
  const [ours, bare] = [await hostFolder(out), await hostFolder(bareFolder)];
  return {
    browser,
    ours,
    bare,
    close: async () => {
      await browser.close();
      await ours.close();
      await bare.close();
      await rm(base, { recursive: true, force: true });
    },
  };
}

/** An image with the size and about the bytes of a poster. */
async function posterImage(root: string): Promise<Uint8Array<ArrayBuffer>> {
  const { default: sharp } = await import('sharp');
  const picture = sharp(join(root, 'examples/pictures/first-light.jpg')).resize(1200, 630, { fit: 'cover' });
  return Uint8Array.from(await picture.jpeg({ quality: 82 }).toBuffer());
}

/** Page code: finds out when the poster is loaded, and when the canvas shows a frame without it. */
function watchImages(): void {
  let drawn = false;
  const { prototype } = WebGL2RenderingContext;
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'] as const) {
    const own = prototype[name] as (...args: number[]) => void;
    Object.assign(prototype, {
      [name](this: WebGL2RenderingContext, ...args: number[]) {
        own.apply(this, args);
        drawn ||= this.getParameter(this.DRAW_FRAMEBUFFER_BINDING) === null;
      },
    });
  }
  let poster = Number.NaN;
  const seen = new Promise((resolve) => {
    const look = (timeMs: number): void => {
      const image = document.querySelector<HTMLImageElement>('img.poster');
      if (Number.isNaN(poster) && image?.complete && image.naturalWidth > 0) poster = timeMs;
      const isGone = !Number.isNaN(poster) && (image === null || image.classList.contains('gone'));
      if (drawn && isGone) resolve({ poster, image: performance.now() });
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  Object.assign(globalThis, { seen });
}
