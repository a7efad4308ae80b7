import { join } from 'node:path';
import { type BuildOptions, build } from 'esbuild';

/**
 * Bundles the script of a worker thread for Node from Scrim's sources.
 *
 * @param root Absolute folder with Scrim's sources and `node_modules`.
 * @param entry Path below `root`.
 * @returns CommonJS, for `new Worker(script, { eval: true })`. It runs in Electron's older Node too.
 */
export async function bundleWorker(
  root: string,
  entry: string,
  options: Pick<BuildOptions, 'define' | 'mainFields' | 'plugins'> = {},
): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [join(root, entry)],
    absWorkingDir: root,
    bundle: true,
    write: false,
    format: 'cjs',
    platform: 'node',
    target: 'node16',
    // The CommonJS entries of some packages load parts in ways that bundlers cannot follow.
    mainFields: ['module', 'main'],
    loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text' },
    logLevel: 'silent',
    ...options,
  });
  const [file] = outputFiles;
  if (!file) throw new Error(`esbuild made nothing of ${entry}.`);
  return file.text;
}
