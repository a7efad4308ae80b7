import { join } from 'node:path';
import { type FuseConfig, FuseV1Options, FuseVersion, flipFuses, getCurrentFuseWire } from '@electron/fuses';
import type { Target } from './target.ts';

/**
 * Electron fuses of a packaged app, which cannot be changed at run time. They prevent the app from running as Node, accepting Node options
 * or a debugger, and loading code from outside its archive. Cookie encryption, which needs a keyring, the V8 snapshot and privileges of
 * `file:` pages are off because Scrim uses none of them.
 */
export const FUSES = {
  [FuseV1Options.RunAsNode]: false,
  [FuseV1Options.EnableCookieEncryption]: false,
  [FuseV1Options.EnableNodeOptionsEnvironmentVariable]: false,
  [FuseV1Options.EnableNodeCliInspectArguments]: false,
  [FuseV1Options.EnableEmbeddedAsarIntegrityValidation]: true,
  [FuseV1Options.OnlyLoadAppFromAsar]: true,
  [FuseV1Options.LoadBrowserProcessSpecificV8Snapshot]: false,
  [FuseV1Options.GrantFileProtocolExtraPrivileges]: false,
} as const;

/** Sets the fuses of a packaged app. Integrity checks exist on macOS and Windows only. */
export async function setFuses(app: string, { platform, arch }: Pick<Target, 'platform' | 'arch'>): Promise<void> {
  const program = programOf(app, platform);
  const wire = await getCurrentFuseWire(program);
  // Older versions of Electron have fewer fuses.
  const there = Object.fromEntries(Object.entries(FUSES).filter(([index]) => Object.hasOwn(wire, index)));
  const config: FuseConfig = {
    version: FuseVersion.V1,
    // Processors of Apple run only signed programs, and the change has invalidated the signature.
    resetAdHocDarwinSignature: platform === 'darwin' && arch === 'arm64',
    ...there,
  };
  await flipFuses(program, config);
}

/** Reads the fuses of a program: `on`, `off`, or `none` if this Electron does not have it. */
export async function readFuses(app: string, platform: Target['platform']): Promise<Readonly<Record<string, 'on' | 'off' | 'none'>>> {
  const wire = (await getCurrentFuseWire(programOf(app, platform))) as unknown as Readonly<Record<string, number>>;
  // The fuse wire is ASCII: '1' on, '0' off, 'r' removed.
  const word = (state: number | undefined) => (state === 0x31 ? 'on' : state === 0x30 ? 'off' : 'none');
  return Object.fromEntries(Object.keys(FUSES).map((index) => [FuseV1Options[Number(index)] ?? index, word(wire[index])]));
}

function programOf(app: string, platform: Target['platform']): string {
  if (platform === 'darwin') return join(app, 'Scrim.app');
  return join(app, platform === 'win32' ? 'scrim.exe' : 'scrim');
}
