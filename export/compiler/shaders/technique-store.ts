import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { Result } from '../../../nodes/kit/diagnostics.ts';
import { shaderName } from '../../glsl/isf/isf-definition.ts';
import { linkTechnique, type TechniqueOptions } from '../../glsl/technique/link-technique.ts';
import { readTechnique } from '../../glsl/technique/read-technique.ts';
import { techniqueDefinition } from '../../glsl/technique/technique-definition.ts';
import type { TechniqueShader } from '../../glsl/technique/technique-shader.ts';
import type { TechniqueText } from './shader-store.ts';

/** The part of the shader store that reads techniques. */
export interface TechniqueStore {
  readDefinition(file: string, source: string): Result<NodeDefinition>;
  link(file: string, source: string, options: TechniqueOptions): Result<TechniqueText>;
}

interface Entry {
  readonly source: string;
  readonly technique: Result<TechniqueShader>;
  definition: Result<NodeDefinition> | null;
  /** By whether loops are bounded, and what has no wire. */
  readonly texts: Map<string, Result<TechniqueText>>;
}

export function createTechniqueStore(): TechniqueStore {
  const entries = new Map<string, Entry>();

  function entryOf(file: string, source: string): Entry {
    const known = entries.get(file);
    if (known?.source === source) return known;
    const made: Entry = { source, technique: readTechnique(source, file), definition: null, texts: new Map() };
    entries.set(file, made);
    return made;
  }

  return {
    readDefinition: (file, source) => {
      const entry = entryOf(file, source);
      const { output, diagnostics } = entry.technique;
      entry.definition ??= { output: output && techniqueDefinition(output, shaderName(file)), diagnostics };
      return entry.definition;
    },
    link: (file, source, options) => {
      const { technique, texts } = entryOf(file, source);
      const key = `${options.loopBudget};${options.absent?.join() ?? ''}`;
      const text = texts.get(key) ?? linkText(technique, options);
      texts.set(key, text);
      return text;
    },
  };
}

function linkText({ output: technique, diagnostics }: Result<TechniqueShader>, options: TechniqueOptions): Result<TechniqueText> {
  if (technique === null) return { output: null, diagnostics };
  const linked = linkTechnique(technique, options);
  return { output: linked.output && { technique, linked: linked.output }, diagnostics: linked.diagnostics };
}
