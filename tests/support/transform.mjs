import { readFileSync } from 'node:fs';
import { transformSync } from 'esbuild';

const LOADERS = { ts: 'ts', tsx: 'tsx', fs: 'text', vs: 'text', glsl: 'text' };
const cacheKeyBase = readFileSync(new URL(import.meta.url), 'utf8');

export default {
  getCacheKey: (source, path) => `${cacheKeyBase}\0${path}\0${source}`,
  process: (source, path) => {
    const { code, map } = transformSync(source, {
      loader: LOADERS[path.slice(path.lastIndexOf('.') + 1)],
      format: 'esm',
      target: 'es2022',
      jsx: 'automatic',
      sourcefile: path,
      sourcemap: true,
    });
    return { code, map };
  },
};
