import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { Result } from '../../nodes/kit/diagnostics.ts';
import { isfDefinition } from './isf/isf-definition.ts';
import type { IsfShader } from './isf/isf-shader.ts';
import { readIsf } from './isf/read-isf.ts';
import { linkIsf } from './link/link-isf.ts';
import type { LinkedPass, LinkOptions } from './link/linked-pass.ts';

/** The pure functions of this folder, with a memory: the same text is read, analysed and linked once. */
export interface Linker {
  read(source: string, file: string): Result<IsfShader>;
  definition(shader: IsfShader, name: string): NodeDefinition;
  link(shader: IsfShader, options: LinkOptions): Result<readonly LinkedPass[]>;
}

/** Entries per kind; an editor's project has tens of shaders, and each keystroke makes a new text of one. */
const CAPACITY = 256;

export function createLinker(): Linker {
  const shaders = createMemo<Result<IsfShader>>();
  const definitions = createMemo<NodeDefinition>();
  const links = createMemo<Result<readonly LinkedPass[]>>();
  return {
    read: (source, file) => shaders(`${file}\0${source}`, () => readIsf(source, file)),
    definition: (shader, name) => definitions(`${name}\0${shader.file}\0${shader.source}`, () => isfDefinition(shader, name)),
    link: (shader, options) => links(`${optionsKey(options)}\0${shader.file}\0${shader.source}`, () => linkIsf(shader, options)),
  };
}

function optionsKey(options: LinkOptions): string {
  return JSON.stringify([
    options.node,
    options.loopBudget === true,
    [...(options.absent ?? [])].sort(),
    [...(options.withoutDepth ?? [])].sort(),
  ]);
}

/** Keeps the entries used last. */
function createMemo<T>(): (key: string, make: () => T) => T {
  const entries = new Map<string, T>();
  return (key, make) => {
    const known = entries.get(key);
    const value = known ?? make();
    entries.delete(key);
    entries.set(key, value);
    const [oldest] = entries.keys();
    if (entries.size > CAPACITY && oldest !== undefined) entries.delete(oldest);
    return value;
  };
}
