import { execFile } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';

export interface DrawnExample {
  /** The rendered frame as PNG; null if it cannot be drawn. */
  readonly png: Uint8Array | null;
  /** Output of `scrim render`, without the path of the result. */
  readonly said: string;
}

/** Size of a render. Strokes and outlines have widths in pixels, so a smaller render would be another drawing, not a smaller one. */
const RENDER = { widthPx: 1280, heightPx: 960 } as const;

/** Size of a cell on a sheet. */
export const CELL = { widthPx: 320, heightPx: 240 } as const;

/** Renders the first frame of a project with `scrim render`, in the studio or a recorded session. */
export async function drawExample(root: string, path: string, session: string | null): Promise<DrawnExample> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-gallery-'));
  try {
    const out = join(folder, 'picture.png');
    const args = [
      'render',
      path,
      '--out',
      out,
      '--size',
      `${RENDER.widthPx}x${RENDER.heightPx}`,
      ...(session ? ['--session', session] : []),
    ];
    const said = await new Promise<string>((resolve) => {
      execFile(process.execPath, [join(root, 'bin', 'scrim.mjs'), ...args], (_, stdout, stderr) => resolve(`${stdout}${stderr}`));
    });
    const lines = said.split('\n').filter((line) => line.trim() !== '' && !/^(Wrote|Building|npm warn)/.test(line));
    return { png: await readFile(out).catch(() => null), said: lines.join('\n') };
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}
