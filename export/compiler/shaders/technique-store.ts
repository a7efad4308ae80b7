import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { Result } from '../../../nodes/kit/diagnostics.ts';
import { shaderName } from '../../glsl/isf/isf-definition.ts';
import { type LinkedTechnique, linkTechnique, linkTechniqueAbove, type TechniqueOptions } from '../../glsl/technique/link-technique.ts';
import { readTechnique } from '../../glsl/technique/read-technique.ts';
import { techniqueDefinition } from '../../glsl/technique/technique-definition.ts';
import type { TechniqueShader } from '../../glsl/technique/technique-shader.ts';
import type { ShaderLink } from './shader-link.ts';

/** A technique's header and linked text. */
export interface TechniqueText {
  readonly technique: TechniqueShader;
  readonly linked: LinkedTechnique;
}

/** The part of the shader store that reads techniques. */
export interface TechniqueStore {
  readDefinition(file: string, source: string): Result<NodeDefinition>;
  link(file: string, source: string, options: TechniqueOptions): ShaderLink<TechniqueText>;
}

interface Entry {
  readonly source: string;
  readonly technique: Result<TechniqueShader>;
  definition: Result<NodeDefinition> | null;
  /** By loop budget and unconnected inputs. */
  readonly texts: Map<string, RememberedText>;
}

interface RememberedText {
  readonly text: ShaderLink<TechniqueText>;
  /** The included chunks with their texts. */
  readonly chunks: ReadonlyMap<string, string | undefined>;
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
      const known = texts.get(key);
      if (known && [...known.chunks].every(([name, chunk]) => options.chunkOf(name) === chunk)) return known.text;
      const made = linkText(technique, options);
      texts.set(key, made);
      return made.text;
    },
  };
}

function linkText({ output: technique, diagnostics }: Result<TechniqueShader>, options: TechniqueOptions): RememberedText {
  const chunks = new Map<string, string | undefined>();
  if (technique === null) return { text: { output: null, diagnostics, above: null }, chunks };
  const chunkOf = (name: string) => {
    const chunk = options.chunkOf(name);
    chunks.set(name, chunk);
    return chunk;
  };
  const asked = { ...options, chunkOf };
  const linked = linkTechnique(technique, asked);
  if (linked.output !== null) return { text: { output: { technique, linked: linked.output }, diagnostics: [], above: null }, chunks };
  const [refused] = linked.diagnostics;
  const above = refused === undefined ? null : linkTechniqueAbove(technique, asked, refused);
  const found = above && { shaders: above.output === null ? [] : [above.output.trial], before: above.before };
  return { text: { output: null, diagnostics: [...(above?.diagnostics ?? []), ...linked.diagnostics], above: found }, chunks };
}
