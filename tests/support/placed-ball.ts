import { type EditorDriver, FLAG_PX } from './editor-driver.ts';
import type { GraphText } from './open-editor.ts';

/** A magenta ball in the sun, which a tap places once, over the camera video. */
export const PLACED_BALL: GraphText = {
  nodes: {
    'ball-aaaa': { type: 'objects/primitive', params: { shape: 'sphere', color: [1, 0, 1, 1] } },
    'sun-aaaa': { type: 'light/directional' },
    'place-aaaa': { type: 'objects/place', params: { mode: 'once', reticle: false } },
    'video-aaaa': { type: 'source/camera-video' },
    'scene-aaaa': { type: 'layer/scene' },
    'over-aaaa': { type: 'operator/over' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'ball-aaaa.objects -> place-aaaa.objects',
    'place-aaaa.objects -> scene-aaaa.objects',
    'sun-aaaa.lights -> scene-aaaa.lights',
    'scene-aaaa.layer -> over-aaaa.top',
    'video-aaaa.layer -> over-aaaa.bottom',
    'over-aaaa.layer -> screen-aaaa.layer',
  ],
  places: {
    'ball-aaaa': [0, 160],
    'sun-aaaa': [240, 320],
    'place-aaaa': [240, 160],
    'video-aaaa': [0, 0],
    'scene-aaaa': [480, 160],
    'over-aaaa': [720, 0],
    'screen-aaaa': [960, 0],
  },
};

/** Counts the pixels of the ball in the preview. */
export async function ballPixels(editor: EditorDriver): Promise<number> {
  return (await findBall(editor)).count;
}

/** The middle of the ball, in CSS pixels from the top left of the preview. */
export async function ballMiddle(editor: EditorDriver): Promise<readonly [xPx: number, yPx: number]> {
  const { count, xPx, yPx } = await findBall(editor);
  return [xPx / count, yPx / count + FLAG_PX];
}

/** Sums over the pixels of the ball. */
async function findBall(editor: EditorDriver) {
  const { data, width } = await editor.picture();
  const sum = { count: 0, xPx: 0, yPx: 0 };
  for (let i = 0; i < data.length; i += 4) {
    const red = data[i] ?? 0;
    const green = data[i + 1] ?? 0;
    const blue = data[i + 2] ?? 0;
    if (red <= 120 || blue <= 120 || green >= Math.min(red, blue) / 3) continue;
    sum.count++;
    sum.xPx += (i / 4) % width;
    sum.yPx += Math.floor(i / 4 / width);
  }
  return sum;
}
