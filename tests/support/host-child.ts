import { symlink } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { build } from 'esbuild';

const ROOT = resolve(import.meta.dirname, '../..');

/** Prelude of the script: its arguments, and a host of its own. */
const PRELUDE = `
  import { createHost } from './app/services/host.ts';
  import { installationAt } from './app/services/installation.ts';
  const args = process.argv.slice(2);
  const origins = { editor: 'http://127.0.0.1:1', preview: 'http://127.0.0.1:2' };
  const shell = { kind: 'server', origins, pickFolder: null, closeWindow: () => {}, revealFile: null, openInBrowser: null, showMenus: null };
  const host = createHost({ shell, installation: installationAt('/nowhere', '0'), startPath: null, log: console.error });
  /** The output, or the code of the refusal, which is thrown unless it is \`expected\`. */
  const call = async (method, input, expected) => {
    const { output, diagnostic } = await host.dispatch(method, input);
    if (diagnostic && diagnostic.code !== expected) throw new Error(JSON.stringify(diagnostic));
    return diagnostic ? diagnostic.code : output;
  };`;

/** Bundles a script that uses a host in a separate process. Returns its path for Node. */
export async function bundleHostChild(folder: string, script: string): Promise<string> {
  const path = join(folder, 'child.mjs');
  await build({
    stdin: { contents: `${PRELUDE}\n${script}`, resolveDir: ROOT, loader: 'ts' },
    outfile: path,
    bundle: true,
    platform: 'node',
    format: 'esm',
    mainFields: ['module', 'main'],
    external: ['esbuild', 'playwright-core'],
    loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text' },
    banner: { js: "import { createRequire as childRequire } from 'node:module'; const require = childRequire(import.meta.url);" },
    logLevel: 'error',
  });
  // Folder of the packages that are not bundled.
  await symlink(join(ROOT, 'node_modules'), join(folder, 'node_modules'));
  return path;
}
