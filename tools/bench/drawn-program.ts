import { encode } from 'fast-png';
import type { Browser, Page } from 'playwright-core';
import type { Program } from '../../export/program/program.ts';
import { childrenCpuMs } from './cpu-time.ts';
import { call, openPage } from './open-page.ts';

export const SIZE_PX = [1280, 720] as const;

/** Frames per sample. */
const FRAMES = 4;

/** Milliseconds per frame of a page with `frameMs`, by CPU time where the system has `/proc`, as drawing without a GPU costs (ADR 25). */
export async function frameCpuMs(page: Page, frames = FRAMES): Promise<number> {
  const before = childrenCpuMs();
  const wallMs = await call<number>(page, 'frameMs', frames);
  const after = childrenCpuMs();
  return before === null || after === null ? wallMs : (after - before) / frames;
}

/** Opens a page that plays a program at `SIZE_PX`, with the files of a folder. */
export async function openProgram(browser: Browser, root: string, folder: string, program: Program): Promise<Page> {
  const page = await openPage(browser, root, 'tools/bench/pages/scrim.page.ts', folder);
  await call(page, 'open', program, '', ...SIZE_PX);
  return page;
}

/** An opaque image with many colors. */
export function testImage(): Uint8Array {
  const [width, height] = SIZE_PX;
  const data = new Uint8Array(width * height * 3);
  for (let i = 0; i < width * height; i++) {
    const x = i % width;
    const y = Math.floor(i / width);
    data.set([(x * 255) / width, (y * 255) / height, ((x ^ y) * 7) % 256], i * 3);
  }
  return encode({ width, height, data, channels: 3 });
}
