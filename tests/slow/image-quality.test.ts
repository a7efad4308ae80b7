import { cp, mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { describeWithSkimage, runPython } from '../support/python.ts';
import { succeed } from '../support/scrim.ts';
import { describeWithData } from '../support/shared-data.ts';

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-quality-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

interface Shot {
  readonly method: string;
  readonly psnrDb: number;
  readonly ssim: number;
  readonly chromaError: number;
  readonly picture: string;
}

/** PSNR, SSIM and mean |ΔCb| + |ΔCr| of a photograph and its rephotograph, over pixels (SSIM: windows) that are drawn. */
const SCRIPT = `
import json, sys
import numpy as np
from skimage import io, metrics
from skimage.color import rgb2ycbcr
from scipy.ndimage import maximum_filter
shown, truth = io.imread(sys.argv[1]), io.imread(sys.argv[2])[..., :3]
drawn = shown[..., 3] > 0 if shown.shape[2] == 4 else np.ones(shown.shape[:2], bool)
shown = shown[..., :3]
luma = lambda image: image.astype(float) @ [0.299, 0.587, 0.114]
_, values = metrics.structural_similarity(luma(shown), luma(truth), full=True, data_range=255,
    gaussian_weights=True, sigma=1.5, use_sample_covariance=False)
whole = maximum_filter((~drawn).astype(np.uint8), 11)[5:-5, 5:-5] == 0
# rgb2ycbcr has Cb and Cr of 112 steps to each side instead of 127.5.
chroma = np.abs(rgb2ycbcr(shown) - rgb2ycbcr(truth))[drawn][:, 1:].sum(axis=1).mean() * 127.5 / 112
print(json.dumps([metrics.peak_signal_noise_ratio(truth[drawn], shown[drawn], data_range=255), values[5:-5, 5:-5][whole].mean(), chroma]))
`;

describeWithSkimage('figures of rephotographs', () => {
  describeWithData('of a living room', 'captures/icl-livingroom', (folder) => {
    test('are those of scikit-image', async () => {
      const photos = (await readdir(join(folder, 'images'))).sort().slice(6, 9);
      for (const name of ['sparse', 'mesh.ply', ...photos.map((photo) => `images/${photo}`)]) {
        await cp(join(folder, name), join(base, 'room', name), { recursive: true });
      }
      const project = join(base, 'project');
      const capture = join(project, 'assets/room.capture');
      const out = join(base, 'report');
      await succeed('new', project);
      await succeed('import', 'capture', join(base, 'room'), '--project', project);
      await succeed('rephotograph', capture, '--out', out);
      const report = JSON.parse(await readFile(join(out, 'report.json'), 'utf8')) as { views: { photo: string; shots: Shot[] }[] };
      expect(report.views).toHaveLength(photos.length);
      for (const { photo, shots } of report.views) {
        for (const { picture, psnrDb, ssim, chromaError } of shots) {
          const theirs = JSON.parse(runPython(SCRIPT, join(out, picture), join(out, photo))) as [number, number, number];
          // Decoders of JPEG round differently.
          expect(Math.abs(psnrDb - theirs[0])).toBeLessThan(0.02);
          expect(Math.abs(ssim - theirs[1])).toBeLessThan(0.001);
          expect(Math.abs(chromaError - theirs[2])).toBeLessThan(0.02);
        }
      }
    });
  });
});
