import { join } from 'node:path';
import { build } from 'esbuild';

/** Scripts by what they are made of. */
const bundled = new Map<string, Promise<string>>();

/** Bundles a page script from Scrim’s sources, once in a process. Its exports become properties of `globalName`. */
export function bundleScript(root: string, entry: string, globalName: string): Promise<string> {
  const key = JSON.stringify([root, entry, globalName]);
  const script = bundled.get(key) ?? bundle(root, entry, globalName);
  bundled.set(key, script);
  script.catch(() => bundled.delete(key));
  return script;
}

async function bundle(root: string, entry: string, globalName: string): Promise<string> {
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
