import { readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import type { GraphText } from './open-editor.ts';

const BALL = resolve('nodes/source/capture-mesh/example/assets/glossy-ball.capture');

/** Photographs of the ball in `withBall`. */
export const BALL_VIEWS = 4;

/** The camera's video on the screen, and the first photographs of a ball. */
export async function withBall(): Promise<GraphText> {
  const capture = JSON.parse(await readFile(join(BALL, 'capture.json'), 'utf8')) as { views: { file: string }[] };
  capture.views.splice(BALL_VIEWS);
  const files = ['mesh.bin', ...capture.views.map(({ file }) => file)];
  const assetFiles = Object.fromEntries(
    await Promise.all(files.map(async (file) => [`ball.capture/${file}`, await readFile(join(BALL, file))] as const)),
  );
  return {
    nodes: { 'video-aaaa': { type: 'source/camera-video' }, 'screen-aaaa': { type: 'output/screen' } },
    wires: ['video-aaaa.layer -> screen-aaaa.layer'],
    places: { 'video-aaaa': [0, 0], 'screen-aaaa': [300, 0] },
    assets: { ball: { path: 'assets/ball.capture/capture.json', kind: 'capture' } },
    assetFiles: { ...assetFiles, 'ball.capture/capture.json': new TextEncoder().encode(JSON.stringify(capture)) },
  };
}
