import { createHash } from 'node:crypto';
import { join } from 'node:path';
import { isfDefinition, shaderName } from '../../export/glsl/isf/isf-definition.ts';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { readDefinition } from '../../export/glsl/read-definition.ts';
import { isTechnique } from '../../export/glsl/technique/technique-shader.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { type Diagnostic, formatDiagnostic } from '../../nodes/kit/diagnostics.ts';
import { readIfThere, writeIfChanged } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { ShaderFile } from './find-nodes.ts';

/** Cached result of reading a file. Finding the access kind parses the whole shader. */
interface Entry {
  readonly key: string;
  readonly definition: NodeDefinition | null;
  readonly diagnostics: readonly Diagnostic[];
}

export interface IsfDefinitions {
  readonly definitions: readonly NodeDefinition[];
  /** Problems of the files as text, each with file and line. */
  readonly problems: readonly string[];
}

/**
 * Definitions of the library's ISF files and techniques, in the order of the files. Reports ISF files in the wrong folder: the inputs of a
 * file decide whether it is a filter, an operator or a generator.
 */
export async function isfDefinitions(files: readonly ShaderFile[], { root, version }: ToolContext): Promise<IsfDefinitions> {
  const path = join(root, 'node_modules', '.cache', 'scrim', 'isf-definitions.json');
  const known = await readCache(path);
  const entries = files
    .filter((file) => file.name.endsWith('.fs') || file.name.startsWith('techniques/'))
    .map((file) => {
      const key = createHash('sha256').update(`${version}\0${file.name}\0${file.text}`).digest('hex');
      return known.get(key) ?? { key, ...read(file) };
    });
  await writeIfChanged(path, JSON.stringify(entries));
  return {
    definitions: entries.flatMap((entry) => entry.definition ?? []),
    problems: entries.flatMap((entry) => entry.diagnostics.map(formatDiagnostic)),
  };
}

function read({ name, text }: ShaderFile): Omit<Entry, 'key'> {
  if (isTechnique(text, name)) {
    const { output, diagnostics } = readDefinition(text, name);
    return { definition: output, diagnostics };
  }
  const { output, diagnostics } = readIsf(text, name);
  if (output === null) return { definition: null, diagnostics };
  const definition = isfDefinition(output, shaderName(name));
  const folder = name.slice(0, name.indexOf('/'));
  if (folder === `${output.kind}s`) return { definition, diagnostics };
  const message = `This is a ${output.kind} by its inputs, so it belongs into ${output.kind}s/.`;
  return { definition, diagnostics: [...diagnostics, { code: 'SCR040', severity: 'error', file: name, message }] };
}

async function readCache(path: string): Promise<ReadonlyMap<string, Entry>> {
  const text = await readIfThere(path);
  const entries = text === null ? [] : (JSON.parse(text) as Entry[]);
  return new Map(entries.map((entry) => [entry.key, entry]));
}
