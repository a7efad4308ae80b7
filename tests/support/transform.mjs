import { readFileSync } from 'node:fs';
import { transformSync } from 'esbuild';
import { keepGlobals } from './keep-globals.mjs';

const LOADERS = { ts: 'ts', tsx: 'tsx', fs: 'text', vs: 'text', glsl: 'text' };
const cacheKeyBase = ['transform.mjs', 'keep-globals.mjs'].map((name) => readFileSync(new URL(name, import.meta.url), 'utf8')).join('\0');

export default {
  getCacheKey: (source, path) => `${cacheKeyBase}\0${path}\0${source}`,
  process: (source, path) => {
    const loader = LOADERS[path.slice(path.lastIndexOf('.') + 1)];
    // Of packages, only those in the configuration come here. They are JavaScript already.
    if (loader === undefined) return { code: keepGlobals(source) };
    const { code, map } = transformSync(source, {
      loader,
      format: 'esm',
      target: 'es2022',
      jsx: 'automatic',
      sourcefile: path,
      sourcemap: true,
    });
    return { code: loader === 'text' ? code : keepGlobals(code), map };
  },
};
