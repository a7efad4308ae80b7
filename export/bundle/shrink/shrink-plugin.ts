import { readFile } from 'node:fs/promises';
import { relative, resolve, sep } from 'node:path';
import type { Plugin } from 'esbuild';
import type { PageUse } from '../page-entry.ts';
import { dropMethods } from './drop-methods.ts';
import { dropBranches } from './glsl-conditionals.ts';
import { changeTemplates, stripGlsl } from './glsl-templates.ts';
import { THREE_PARTS, UNUSED_METHODS, undefinedMacros } from './three-parts.ts';

/** The license of three.js, which its bundled file has at its top, but not its source files. */
const THREE_LICENSE = `/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */
`;

/**
 * Bundles three.js from its source files and leaves out what the page does not need: files, methods, and branches of shaders. Removes
 * comments and indentation from all shaders.
 */
export function shrink(root: string, use: PageUse): Plugin {
  const three = resolve(root, 'node_modules/three/src');
  const replaced = new Map(
    THREE_PARTS.filter(({ isNeeded }) => isNeeded?.(use) !== true).map(({ file, otherwise }) => [resolve(three, file), otherwise]),
  );
  const never = undefinedMacros(use);
  return {
    name: 'shrink',
    setup: ({ onResolve, onLoad, resolve: resolvePath }) => {
      onResolve({ filter: /^three$/ }, ({ kind }) => resolvePath('three/src/Three.js', { kind, resolveDir: root }));
      onLoad({ filter: /[\\/]three[\\/]src[\\/].*\.js$/ }, async ({ path }) => {
        const otherwise = replaced.get(path);
        if (otherwise !== undefined) return { contents: otherwise };
        const text = dropMethods(await readFile(path, 'utf8'), UNUSED_METHODS);
        const file = relative(three, path).split(sep).join('/');
        if (file === 'constants.js') return { contents: THREE_LICENSE + text };
        if (!file.endsWith('.glsl.js')) return { contents: changeTemplates(text, stripGlsl) };
        return { contents: changeTemplates(text, (glsl) => dropBranches(stripGlsl(glsl), never)) };
      });
      onLoad({ filter: /[\\/](export|nodes)[\\/].*\.ts$/ }, async ({ path }) => {
        const text = await readFile(path, 'utf8');
        return { contents: changeTemplates(text, stripGlsl), loader: 'ts' };
      });
    },
  };
}
