import { join } from 'node:path';
import { build } from 'esbuild';

/** Bundles a page's script from Scrim's sources; its exports stand under `globalName`. */
export async function bundleScript(root: string, entry: string, globalName: string): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [join(root, entry)],
    absWorkingDir: root,
    bundle: true,
    write: false,
    format: 'iife',
    globalName,
    target: 'es2022',
    // three's decoders name files beside their own module, which they are never asked for; a classic script has no such address.
    define: { 'import.meta.url': 'document.baseURI' },
    loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text' },
    logLevel: 'silent',
  });
  const [file] = outputFiles;
  if (!file) throw new Error(`esbuild made nothing of ${entry}.`);
  return file.text;
}

/** Bundles a thread's script for Node from Scrim's sources. */
export async function bundleWorker(root: string, entry: string): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [join(root, entry)],
    absWorkingDir: root,
    bundle: true,
    write: false,
    platform: 'node',
    format: 'cjs',
    target: 'node20',
    // CommonJS entries find their parts in ways that bundlers cannot follow.
    mainFields: ['module', 'main'],
    loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text' },
    logLevel: 'silent',
  });
  const [file] = outputFiles;
  if (!file) throw new Error(`esbuild made nothing of ${entry}.`);
  return file.text;
}
