import type { PageUse } from '../page-entry.ts';

/** A source file of the runtime that only some pages need. */
export interface OptionalPart {
  /** Path relative to the root. */
  readonly file: string;
  /** Whether the page needs it. */
  readonly isNeeded: (use: PageUse) => boolean;
  /** Code that stands for the file in other pages. `absent` throws when it is called: nothing of such a page calls it. */
  readonly otherwise: string;
}

/** Name by which code that stands for a file imports `export/page/absent.ts`. */
export const ABSENT_MODULE = 'scrim:absent';

export const ABSENT = `import { absent } from '${ABSENT_MODULE}';`;

/** Code that exports names of functions which throw. */
export function absent(...names: readonly string[]): string {
  return `export { ${names.map((name) => `absent as ${name}`).join(', ')} } from '${ABSENT_MODULE}';`;
}

export const needs = (capability: string) => (use: PageUse) => use.capabilities.has(capability as never);

/** Whether a program plays a node of a type with these structure params. */
export const plays =
  (type: string, config: Readonly<Record<string, string>> = {}) =>
  ({ nodes }: PageUse): boolean =>
    nodes.some((node) => node.type === type && Object.entries(config).every(([param, value]) => node.config[param] === value));

/** Node types that create panoramas from pixels. A test compares them with the runtimes. */
export const PANORAMA_MAKERS: readonly string[] = ['source/panorama-capture', 'source/panorama-exposures'];

export const hasPanoramas = ({ panoramas, nodeTypes }: PageUse): boolean =>
  panoramas || PANORAMA_MAKERS.some((type) => nodeTypes.includes(type));
