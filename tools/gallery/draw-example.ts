import { execFile } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';

export interface DrawnExample {
  /** Null where it cannot be drawn. */
  readonly png: Uint8Array | null;
  /** What `scrim render` had to say, but for where it wrote. */
  readonly said: string;
}

/** What a sheet shows of each. */
export const CELL = { widthPx: 320, heightPx: 240 } as const;

/** The first frame of a project by `scrim render`, over the studio or the session in a folder. */
export async function drawExample(root: string, path: string, session: string | null): Promise<DrawnExample> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-gallery-'));
  try {
    const out = join(folder, 'picture.png');
    const args = ['render', path, '--out', out, '--size', `${CELL.widthPx}x${CELL.heightPx}`, ...(session ? ['--session', session] : [])];
    const said = await new Promise<string>((resolve) => {
      execFile(process.execPath, [join(root, 'bin', 'scrim.mjs'), ...args], (_, stdout, stderr) => resolve(`${stdout}${stderr}`));
    });
    const lines = said.split('\n').filter((line) => line.trim() !== '' && !/^(Wrote|Building|npm warn)/.test(line));
    return { png: await readFile(out).catch(() => null), said: lines.join('\n') };
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}
