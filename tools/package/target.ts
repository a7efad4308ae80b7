import process from 'node:process';
import { parseArgs } from 'node:util';

export const PLATFORMS = ['linux', 'win32', 'darwin'] as const;
export const ARCHITECTURES = ['x64', 'arm64'] as const;

/** Target system and version of Electron. */
export interface Target {
  readonly platform: (typeof PLATFORMS)[number];
  readonly arch: (typeof ARCHITECTURES)[number];
  /** Folder of an unpacked Electron; null to download the version in package.json. */
  readonly electron: string | null;
  readonly out: string;
}

export const USAGE = `Usage: npm run package -- [--platform ${PLATFORMS.join('|')}] [--arch ${ARCHITECTURES.join('|')}] [--electron DIR] [--out DIR]

Makes the app's folder, of this system unless told otherwise, in dist/app. --electron names a folder with an unpacked Electron
of that system, for machines that cannot fetch it.`;

/**
 * Reads the target from the command line.
 *
 * @throws Error with a message for the user
 */
export function readTarget(args: readonly string[]): Target {
  const text = { type: 'string' } as const;
  const { values } = parseArgs({ args: [...args], options: { platform: text, arch: text, electron: text, out: text } });
  return {
    platform: oneOf(PLATFORMS, values.platform ?? process.platform, 'platform'),
    arch: oneOf(ARCHITECTURES, values.arch ?? process.arch, 'arch'),
    electron: values.electron ?? null,
    out: values.out ?? 'dist/app',
  };
}

function oneOf<T extends string>(known: readonly T[], given: string, option: string): T {
  const found = known.find((value) => value === given);
  if (found === undefined) throw new Error(`--${option} ${given}: there are ${known.join(', ')}.`);
  return found;
}
