import { readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { expect } from '@jest/globals';
import type { Browser } from 'playwright-core';
import type { OpenedJob, RenderJob } from '../../app/cli/render/render.page.ts';
import { straightAlpha } from '../../app/services/encode-png.ts';
import { DECODER_FILES_FOLDER } from '../../export/gltf/decoders.ts';
import type { LayerPixels } from '../../export/runtime/readback.ts';
import { openModule } from './browser.ts';
import { compileText } from './compile-project.ts';
import type { RgbaImage } from './image.ts';

export interface LayersJob {
  /** Folders; the project has no shaders of its own. */
  readonly project: string;
  readonly session: string;
  /** As `node.port`. */
  readonly layers: readonly string[];
  /** Number of frames, from the first on. */
  readonly frames: number;
  readonly widthPx: number;
  readonly heightPx: number;
}

/**
 * Renders several layers of a recording by the page of `scrim render`, and returns the images that it would write, per layer and frame. What the
 * layers have in common is drawn once.
 */
export async function renderLayers(browser: Browser, job: LayersJob): Promise<ReadonlyMap<string, readonly RgbaImage[]>> {
  const { project, session, layers, frames, widthPx, heightPx } = job;
  const page = await openModule(browser, 'tests/support/render-layers.page.ts', {
    mounts: { '/project/': project, '/session/': session, '/decoders/': resolve(DECODER_FILES_FOLDER) },
  });
  const opened: RenderJob = {
    ...{ assetBaseUrl: 'project/', decodersBaseUrl: 'decoders/', widthPx, heightPx },
    program: compileText(await readFile(join(project, 'project.scrim.json'), 'utf8'), { taps: layers }),
    session: { kind: 'recorded', url: 'session/' },
    subject: { kind: 'screen' },
  };
  expect(await page.call<OpenedJob>('open', opened)).toMatchObject({ shaderErrors: [], diagnostics: [] });
  const images = new Map<string, RgbaImage[]>(layers.map((layer) => [layer, []]));
  for (let frame = 0; frame < frames; frame++) {
    await page.call('take', frame, layers);
    for (const layer of layers) {
      const shot = await page.call<LayerPixels>('shotOf', layer);
      images.get(layer)?.push({ width: shot.widthPx, height: shot.heightPx, data: straightAlpha(shot) });
    }
  }
  expect(page.errors).toEqual([]);
  await page.close();
  return images;
}
