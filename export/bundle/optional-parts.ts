import { resolve } from 'node:path';
import type { Plugin } from 'esbuild';
import { ASSET_PARTS } from './optional/asset-parts.ts';
import { PAGE_PARTS } from './optional/page-parts.ts';
import { ABSENT_MODULE, type OptionalPart } from './optional/part.ts';
import { RUNTIME_PARTS } from './optional/runtime-parts.ts';
import { SCENE_PARTS } from './optional/scene-parts.ts';
import { SESSION_PARTS } from './optional/session-parts.ts';
import type { PageUse } from './page-entry.ts';

/**
 * The parts of the runtime and the page that the compiler's output decides about (ADR 44). The player imports them like any other file; the
 * bundler replaces those that a page does not need.
 */
export const OPTIONAL_PARTS: readonly OptionalPart[] = [...RUNTIME_PARTS, ...ASSET_PARTS, ...PAGE_PARTS, ...SESSION_PARTS, ...SCENE_PARTS];

/** Replaces the optional parts that a page does not need. */
export function leaveOut(root: string, use: PageUse): Plugin {
  const replaced = new Map(
    OPTIONAL_PARTS.filter(({ isNeeded }) => !isNeeded(use)).map(({ file, otherwise }) => [resolve(root, file), otherwise]),
  );
  const absent = resolve(root, 'export/page/absent.ts');
  return {
    name: 'leave-out',
    setup: ({ onLoad, onResolve }) => {
      onResolve({ filter: new RegExp(`^${ABSENT_MODULE}$`) }, () => ({ path: absent, sideEffects: false }));
      onLoad({ filter: /\.ts$/ }, ({ path }) => {
        const contents = replaced.get(path);
        return contents === undefined ? null : { contents, loader: 'ts' };
      });
    },
  };
}
