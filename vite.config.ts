import { resolve } from 'node:path';
import process from 'node:process';
import react from '@vitejs/plugin-react';
import { defineConfig } from 'vite';

/**
 * Two pages on two origins, so two builds that share no file: `vite build` makes the editor in `dist/editor`, and
 * `vite build --mode preview` its preview page in `dist/preview`. All addresses are relative: the shells choose the origins.
 */
export default defineConfig(({ mode }) => {
  // A build is for production, also when a test starts it: React's development runtime is in no production bundle.
  process.env.NODE_ENV = 'production';
  const preview = mode === 'preview';
  return {
    root: resolve(import.meta.dirname, preview ? 'renderer/preview' : 'renderer'),
    base: './',
    publicDir: false,
    plugins: preview ? [shaderText()] : [react(), shaderText()],
    // One file a worker, so that it starts at every address and under every `worker-src`.
    worker: { format: 'iife', plugins: () => [shaderText()] },
    build: {
      outDir: resolve(import.meta.dirname, preview ? 'dist/preview' : 'dist/editor'),
      emptyOutDir: true,
      // Electron 22, the oldest that the project tests on, is Chrome 108.
      target: 'chrome108',
      cssTarget: 'chrome108',
      assetsInlineLimit: 0,
      modulePreload: { polyfill: false },
      reportCompressedSize: false,
      chunkSizeWarningLimit: 4096,
      // On a slow machine its advice would hide the address that `npm start` prints.
      rolldownOptions: { checks: { bundlerTimings: false } },
    },
  };
});

/** `.fs`, `.vs` and `.glsl` files are imported as text, as by esbuild and in the tests. */
function shaderText() {
  return {
    name: 'scrim-shader-text',
    transform(code: string, id: string) {
      return /\.(fs|vs|glsl)$/.test(id) ? { code: `export default ${JSON.stringify(code)};`, map: null } : null;
    },
  };
}
