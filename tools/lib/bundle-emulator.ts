import { build } from 'esbuild';

/** The emulated device as a script for pages, with the global `scrimEmulator`. */
export async function bundleEmulator(root: string): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [`${root}/export/emulator/inject.ts`],
    bundle: true,
    write: false,
    format: 'iife',
    target: 'chrome108',
    minify: true,
    loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text' },
    logLevel: 'silent',
  });
  return outputFiles[0]?.text ?? '';
}
