import { readFile } from 'node:fs/promises';
import { expect, test } from '@jest/globals';
import { PAGE } from '../browser/glsl-kit.ts';
import { applyShader, expectedImage, type Params, photograph, samplesOf } from '../browser/shader-library-kit.ts';
import { useModule } from '../support/browser.ts';
import type { RgbaImage } from '../support/image.ts';
import { expectSamePixels } from '../support/pixels.ts';
import { describeWithData } from '../support/shared-data.ts';
import { BORDER_PX, SKIN_OUTLINES, type SkinOutlines, WITHOUT_SKIN } from '../support/skin-outlines.ts';
import { SKIN_OUTLINES_OF_VIDEO } from '../support/skin-outlines-of-video.ts';

const page = useModule(PAGE);

function apply(filter: string, inputImage: RgbaImage, params?: Params): Promise<RgbaImage> {
  return applyShader(page, `filters/${filter}.fs`, { inputImage }, params);
}

describeWithData('anisotropic Kuwahara over a photograph', 'images/astronaut.png', (path) => {
  test('is what OpenCV and numpy compute', async () => {
    const drawn = await apply('anisotropic-kuwahara', await photograph(path));
    const file = 'astronaut-anisotropic-kuwahara-6';
    await expectSamePixels(file, samplesOf(drawn), await expectedImage(file), { tolerance: 2 });
  });
});

/** An image, or a frame of a video. */
function nameOf({ path, timeS }: SkinOutlines): string {
  return timeS === undefined ? path : `${path} at ${timeS} s`;
}

/** Values of the parameter “Find by” of Skin mask. */
const RULES = { range: 0, likelihood: 1, picked: 2 } as const;

/** Share of the skin that a mask finds, and share of the rest that it takes for skin. */
interface SkinScore {
  readonly recall: number;
  readonly wrong: number;
}

/** Whether a pixel is skin, by the outlines; null near an outline and in what counts as neither. */
function skinOf(
  { skin, neither }: Pick<SkinOutlines, 'skin' | 'neither'>,
  { width, height }: RgbaImage,
  scale: number,
): (boolean | null)[] {
  const inside = (outlines: SkinOutlines['skin'], x: number, y: number) =>
    outlines.some((outline) => {
      let odd = false;
      outline.forEach(([x1, y1], i) => {
        const [x2, y2] = outline.at(i - 1) ?? [x1, y1];
        if (y1 > y !== y2 > y && x < x1 + ((y - y1) / (y2 - y1)) * (x2 - x1)) odd = !odd;
      });
      return odd;
    });
  const filled = (outlines: SkinOutlines['skin']) =>
    Array.from({ length: width * height }, (_, i) => inside(outlines, ((i % width) + 0.5) / scale, (Math.floor(i / width) + 0.5) / scale));
  const [isSkin, isNeither] = [filled(skin), filled(neither)];
  const around = [-BORDER_PX, 0, BORDER_PX].flatMap((x) => [-BORDER_PX, 0, BORDER_PX].map((y) => [x, y] as const));
  return isSkin.map((value, i) => {
    const [left, top] = [i % width, Math.floor(i / width)];
    const isBorder = around.some(([x, y]) => {
      const [across, down] = [Math.min(Math.max(left + x, 0), width - 1), Math.min(Math.max(top + y, 0), height - 1)];
      return isSkin[down * width + across] !== value;
    });
    return isBorder || isNeither[i] ? null : value;
  });
}

function scoreOf(mask: RgbaImage, truth: readonly (boolean | null)[]): SkinScore {
  const counts = { skin: 0, found: 0, rest: 0, wrong: 0 };
  truth.forEach((isSkin, i) => {
    const white = (mask.data[4 * i] ?? 0) > 127;
    if (isSkin === true) {
      counts.skin += 1;
      if (white) counts.found += 1;
    } else if (isSkin === false) {
      counts.rest += 1;
      if (white) counts.wrong += 1;
    }
  });
  return { recall: counts.skin === 0 ? 1 : counts.found / counts.skin, wrong: counts.wrong / counts.rest };
}

/** The median of the outlined skin: what somebody picks who picks well. */
function medianSkin({ data }: RgbaImage, truth: readonly (boolean | null)[]): readonly number[] {
  return [0, 1, 2].map((channel) => {
    const values = truth.flatMap((isSkin, i) => (isSkin === true ? [data[4 * i + channel] ?? 0] : [])).sort((a, b) => a - b);
    return (values[values.length >> 1] ?? 0) / 255;
  });
}

/** The mask of hard edges by one rule, cleaned as the documentation advises. */
async function skinMask(picture: RgbaImage, params: Params): Promise<RgbaImage> {
  return apply('clean-mask', await apply('skin-mask', picture, { softness: 0, ...params }), { holesPx: 2, specksPx: 1 });
}

/**
 * What the rules reach, [least recall, most of the rest taken for skin]; `shader-library/README.md` has the figures. Curtains, cloth,
 * fur and wood have the colors of skin: no rule by color alone leaves them out.
 */
const REACHED = {
  'images/portrait.jpg': { range: [0.97, 0.34], likelihood: [0.97, 0.32], picked: [0.9, 0.05] },
  'images/astronaut.png': { range: [0.97, 0.32], likelihood: [0.97, 0.34], picked: [0.97, 0.05] },
  'images/hands.jpg': { range: [0.74, 0.01], likelihood: [0.26, 0.01], picked: [0.9, 0.05] },
  'images/asl_hand.25fps.mp4 at 0.02 s': { range: [0.97, 0.01], likelihood: [0.85, 0.01], picked: [0.89, 0.01] },
  'images/asl_hand.25fps.mp4 at 2.42 s': { range: [0.97, 0.01], likelihood: [0.88, 0.01], picked: [0.87, 0.01] },
  'images/asl_hand.25fps.mp4 at 9.62 s': { range: [0.97, 0.01], likelihood: [0.91, 0.01], picked: [0.88, 0.01] },
} as const;

for (const outlines of [...SKIN_OUTLINES, ...SKIN_OUTLINES_OF_VIDEO]) {
  describeWithData(`skin in ${nameOf(outlines)}`, outlines.path, (path) => {
    test('is found as the documentation says, best by a picked color', async () => {
      const { picture, scale } = await reducedInPage(path, outlines.timeS);
      const truth = skinOf(outlines, picture, scale);
      const skinColor = [...medianSkin(picture, truth), 1];
      for (const [rule, [recall, wrong]] of Object.entries(REACHED[nameOf(outlines) as keyof typeof REACHED])) {
        const score = scoreOf(await skinMask(picture, { rule: RULES[rule as keyof typeof RULES], skinColor }), truth);
        expect([rule, score.recall >= recall, score.wrong <= wrong]).toEqual([rule, true, true]);
      }
    });
  });
}

/** Most of a photograph without skin that is taken for skin: by the range, and by likelihood. */
const MISTAKEN: Readonly<Record<(typeof WITHOUT_SKIN)[number], readonly [number, number]>> = {
  'images/chelsea.png': [1, 0.91],
  'images/coffee.png': [0.8, 0.76],
  'images/brick.png': [0.01, 0.01],
  'panoramas/interior_ldr.jpg': [0.12, 0.03],
  'panoramas/royal_esplanade_ldr.jpg': [0.23, 0.04],
  'panoramas/eilenriede-park-2k.png': [0.09, 0.02],
  'sessions/icl-livingroom/color/00000.jpg': [0.43, 0.39],
  'sessions/icl-livingroom/color/00030.jpg': [0.41, 0.33],
};

for (const photo of WITHOUT_SKIN) {
  describeWithData(`no skin in ${photo}`, photo, (path) => {
    test('is mistaken for skin in no more of the image than the documentation says', async () => {
      const { picture } = await reducedInPage(path);
      const truth = skinOf({ skin: [], neither: [] }, picture, 1);
      const wrong = [];
      for (const rule of [RULES.range, RULES.likelihood]) wrong.push(scoreOf(await skinMask(picture, { rule }), truth).wrong);
      expect(wrong.map((share, i) => share <= (MISTAKEN[photo][i] ?? 0))).toEqual([true, true]);
    });
  });
}

/** Longest side of the photographs that skin is found in. */
const LONGEST_PX = 400;

/** Reduces a photograph, of any format that browsers read, or the frame of a video at a time. `scale` is the ratio of its sizes, reduced to whole. */
async function reducedInPage(path: string, timeS: number | null = null): Promise<{ readonly picture: RgbaImage; readonly scale: number }> {
  const { width, height, scale, data } = await page.page.evaluate(
    async ([base64, longestPx, time]) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      const FRAME_S = 0.05;
      const frameAt = async (seconds: number): Promise<ImageBitmap> => {
        const video = document.createElement('video');
        const event = (name: string) =>
          new Promise((resolve, reject) => {
            video.addEventListener(name, resolve, { once: true });
            video.addEventListener('error', () => reject(new Error(`The browser cannot play the video: ${video.error?.message}`)));
          });
        const loaded = event('loadeddata');
        video.src = URL.createObjectURL(new Blob([bytes], { type: 'video/mp4' }));
        await loaded;
        // The event `seeked` may come before the frame does.
        const shown = new Promise<void>((resolve) => {
          const look: VideoFrameRequestCallback = (_, { mediaTime }) => {
            if (Math.abs(mediaTime - seconds) < FRAME_S) resolve();
            else video.requestVideoFrameCallback(look);
          };
          video.requestVideoFrameCallback(look);
        });
        video.currentTime = seconds;
        await shown;
        return createImageBitmap(video);
      };
      const whole = await (time === null ? createImageBitmap(new Blob([bytes])) : frameAt(time));
      const scale = Math.min(1, longestPx / Math.max(whole.width, whole.height));
      const [width, height] = [Math.round(whole.width * scale), Math.round(whole.height * scale)];
      const context = new OffscreenCanvas(width, height).getContext('2d');
      if (!context) throw new Error('The browser draws no pictures.');
      context.imageSmoothingQuality = 'high';
      context.drawImage(whole, 0, 0, width, height);
      const { data } = context.getImageData(0, 0, width, height);
      let text = '';
      for (const byte of data) text += String.fromCharCode(byte);
      return { width, height, scale, data: btoa(text) };
    },
    [(await readFile(path)).toString('base64'), LONGEST_PX, timeS] as const,
  );
  return { picture: { width, height, data: new Uint8Array(Buffer.from(data, 'base64')) }, scale };
}
