import { join } from 'node:path';
import { build } from 'esbuild';

/** Bundles a page script from Scrim’s sources. Its exports become properties of `globalName`. */
export async function bundleScript(root: string, entry: string, globalName: string): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [join(root, entry)],
    absWorkingDir: root,
    bundle: true,
    write: false,
    format: 'iife',
    globalName,
    target: 'es2022',
    // The decoders of three.js refer to files beside their module. These URLs are unused, and `import.meta` is invalid in classic
    // scripts.
    define: { 'import.meta.url': 'document.baseURI' },
    loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text' },
    logLevel: 'silent',
  });
  const [file] = outputFiles;
  if (!file) throw new Error(`esbuild made nothing of ${entry}.`);
  return file.text;
}
