import { readFile } from 'node:fs/promises';
import { relative, resolve, sep } from 'node:path';
import type { Plugin } from 'esbuild';
import type { PageUse } from '../page-entry.ts';
import { dropCases, dropMembers } from './drop-cases.ts';
import { dropMethods } from './drop-methods.ts';
import { dropBranches } from './glsl-conditionals.ts';
import { changeTemplates, stripGlsl } from './glsl-templates.ts';
import { THREE_PARTS, UNUSED_METHODS, undefinedMacros } from './three-parts.ts';
import { TRIMS, type Trim } from './trims.ts';

/** The license of three.js, which its bundled file has at its top, but not its source files. */
const THREE_LICENSE = `/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */
`;

/**
 * Bundles three.js from its source files and leaves out what the page does not need: files, methods, and branches of shaders. Removes
 * comments and indentation from all shaders, and from Scrim's own files what `TRIMS` lists.
 */
export function shrink(root: string, use: PageUse): Plugin {
  const three = resolve(root, 'node_modules/three/src');
  const replaced = new Map(
    THREE_PARTS.filter(({ isNeeded }) => isNeeded?.(use) !== true).map(({ file, otherwise }) => [resolve(three, file), otherwise]),
  );
  const never = undefinedMacros(use);
  const trims = new Map(TRIMS.map((trim) => [resolve(root, trim.file), trim]));
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
        const trim = trims.get(path);
        return { contents: changeTemplates(trim ? trimmed(text, trim, use) : text, stripGlsl), loader: 'ts' };
      });
    },
  };
}

/** Cuts out of a source file of Scrim what the page does not need. */
export function trimmed(text: string, { cases, members = {} }: Trim, use: PageUse): string {
  const names = Object.keys(members).filter((name) => members[name]?.(use) !== true);
  const shorter = names.length > 0 ? dropMembers(text, names) : text;
  if (!cases) return shorter;
  const needed = cases.needed(use);
  return dropCases(shorter, (label) => cases.labels.includes(label) && !needed.has(label));
}
