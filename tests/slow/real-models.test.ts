import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { type Compressor, createCompressor } from '../../export/bundle/compress/compressor.ts';
import { compile } from '../../export/compiler/compile.ts';
import { DECODER_FILES_FOLDER } from '../../export/gltf/decoders.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Program } from '../../export/program/program.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { encodeImage, fromGl } from '../support/image.ts';
import { LIBRARY } from '../support/library.ts';
import { MATERIAL_EXTENSIONS, materialSpheres } from '../support/material-spheres.ts';
import { projectText } from '../support/project-kit.ts';
import { describeWithData } from '../support/shared-data.ts';

const shared = resolve('../shared/data/models');
const chromium = useBrowser();
let page: PageModule;
let folder = '';
let compressor: Compressor;

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'scrim-real-'));
  compressor = createCompressor(process.cwd());
  page = await openModule(chromium.browser, 'tests/slow/real-models.page.ts', {
    mounts: { '/models/': shared, '/packed/': folder, '/libs/': resolve(DECODER_FILES_FOLDER) },
  });
});
afterAll(async () => {
  await compressor.dispose();
  await page.close();
  expect(page.errors).toEqual([]);
  await rm(folder, { recursive: true, force: true });
});

const SUN = { azimuthRad: 0.6, elevationRad: 0.8, intensity: 0.9 };

/** A model in one light, and nothing else. */
function programOf(path: string): Program {
  const text = projectText({
    nodes: {
      'model-a1': ['source/model', { model: 'thing' }],
      'sun-b2': ['light/directional', { ...SUN, castShadow: false }],
      'scene-c3': ['layer/scene', { ambient: 0, shadows: false }],
      'screen-d4': 'output/screen',
    },
    wires: ['model-a1.objects -> scene-c3.objects', 'sun-b2.lights -> scene-c3.lights', 'scene-c3.layer -> screen-d4.layer'],
    assets: { thing: { path, kind: 'model' } },
  });
  const { output: project, diagnostics } = loadProject({ project: text, layout: null, sources: {} });
  expect(diagnostics).toEqual([]);
  const compiled = project ? compile({ project, library: LIBRARY }) : null;
  if (!compiled?.output) throw new Error(JSON.stringify(compiled?.diagnostics));
  return compiled.output;
}

interface Drawn {
  readonly covered: number;
  readonly diagnostics: readonly unknown[];
  readonly error: number;
  readonly ours: number[];
}

interface Compared extends Drawn {
  readonly onlyOne: number;
  readonly mean: number;
  readonly far: number;
  readonly sizeM: number;
  readonly reference: number[];
  readonly widthPx: number;
  readonly heightPx: number;
}

/** Looks through glass at what three drew before into a texture of its own, which Scrim, whose layers have none, does not. */
const GLASS = /^(AttenuationTest|GlassTable|TransmissionRoughnessTest)/;

/** Diameter of the bounding sphere, as the files say: meters, but for the fox, which is in centimeters. */
const SIZES: Readonly<Record<string, readonly [number, number]>> = {
  'Fox.glb': [150, 250],
  'BoomBox.glb': [0.02, 0.06],
  'RobotExpressive.glb': [4, 10],
};

const TIME_S = 0.3;

async function compareAt(baseUrl: string, name: string): Promise<Compared> {
  return page.call<Compared>('compare', programOf(name), baseUrl, `${baseUrl}${name}`, TIME_S, SUN);
}

function keepImages(name: string, { ours, reference, widthPx: width, heightPx: height }: Compared): void {
  const out = resolve('tests/output/models');
  mkdirSync(out, { recursive: true });
  const write = (what: string, data: number[]) => writeFileSync(join(out, `${name}-${what}.png`), encodeImage(fromGl(width, height, data)));
  write('scrim', ours);
  write('three', reference);
}

test('materials of every extension but those of glass are drawn as by three.js itself', async () => {
  const name = 'material-extensions.gltf';
  await writeFile(join(folder, name), materialSpheres());
  const result = await compareAt('/packed/', name);
  keepImages(name, result);
  expect([result.diagnostics, result.error]).toEqual([[], 0]);
  expect([result.mean < 2, result.far < 0.01, result.onlyOne < 0.01]).toEqual([true, true, true]);
  expect(result.covered).toBeGreaterThan(500);
  expect(Object.keys(MATERIAL_EXTENSIONS)).toHaveLength(9);
});

describeWithData('real models', 'models', () => {
  const names = readdirSync(shared).filter((name) => name.endsWith('.glb'));
  test('are there', () => expect(names).toContain('Fox.glb'));

  describe.each(names)('%s', (name) => {
    let result: Compared;
    beforeAll(async () => {
      result = await compareAt('/models/', name);
    });

    test('is drawn by the player as by three.js itself', () => {
      keepImages(name, result);
      expect(result.diagnostics).toEqual([]);
      expect(result.error).toBe(0);
      const [least, most] = SIZES[name] ?? [0.01, 1000];
      expect(result.sizeM).toBeGreaterThan(least);
      expect(result.sizeM).toBeLessThan(most);
      expect(result.covered).toBeGreaterThan(2000);
      expect(result.onlyOne).toBeLessThan(GLASS.test(name) ? 0.2 : 0.01);
      if (!GLASS.test(name))
        expect([result.mean < 2, result.far < 0.01, result.mean, result.far]).toEqual([true, true, result.mean, result.far]);
    });

    test('looks the same in every form that the export gives it', async () => {
      const forms = await compressor.compress(new Uint8Array(await readFile(join(shared, name))));
      for (const form of ['meshopt', 'ktx2'] as const) {
        const bytes = forms[form];
        if (!bytes) continue;
        await writeFile(join(folder, `${form}-${name}`), bytes);
        const packed = await page.call<Drawn>('drawAgain', programOf(`${form}-${name}`), '/packed/', `/models/${name}`, TIME_S);
        expect([packed.diagnostics, packed.error]).toEqual([[], 0]);
        expect(packed.covered / result.covered).toBeCloseTo(1, 2);
        let sum = 0;
        packed.ours.forEach((value, i) => {
          sum += Math.abs(value - (result.ours[i] ?? 0));
        });
        // Gray levels, over all channels of what the model covers; fine patterns are made small by another filter.
        const mean = sum / (4 * result.covered);
        expect([form, mean, mean < 3]).toEqual([form, mean, true]);
      }
    });
  });
});
