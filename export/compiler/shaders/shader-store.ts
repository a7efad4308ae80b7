import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { Result } from '../../../nodes/kit/diagnostics.ts';
import { isfDefinition, shaderName } from '../../glsl/isf/isf-definition.ts';
import { type IsfShader, sceneVariant } from '../../glsl/isf/isf-shader.ts';
import { linkAbove } from '../../glsl/link/link-above.ts';
import { linkIsfDepth } from '../../glsl/link/link-depth.ts';
import { linkIsf } from '../../glsl/link/link-isf.ts';
import type { PartedPass } from '../../glsl/link/link-parts.ts';
import { readImageShader } from '../../glsl/read-definition.ts';
import type { TechniqueOptions } from '../../glsl/technique/link-technique.ts';
import { isTechnique } from '../../glsl/technique/technique-shader.ts';
import type { ShaderLink } from './shader-link.ts';
import { createTechniqueStore, type TechniqueText } from './technique-store.ts';

/** The inputs that a shader must do without. */
export interface LinkVariant {
  readonly loopBudget: boolean;
  /** Optional inputs that are not connected. */
  readonly absent: readonly string[];
  /** Image inputs whose layer has no depth. */
  readonly withoutDepth: readonly string[];
  /** Whether a shader for either encoding reads and outputs scene layers. */
  readonly scene: boolean;
}

/**
 * Caches everything that the compiler requests from `export/glsl`: a text is read, analyzed and linked once while its file has that text,
 * however many nodes use it. An edit recompiles in the time that the edited shader takes. Diagnostics name no nodes, because several nodes
 * may use the shader.
 */
export interface ShaderStore {
  /** Reads the node type of an ISF shader or a technique. */
  readDefinition(file: string, source: string): Result<NodeDefinition>;
  read(file: string, source: string): Result<IsfShader>;
  /** Links the passes of a shader. `vertex` is the text of its vertex shader, or null. */
  link(file: string, source: string, vertex: string | null, variant: LinkVariant): ShaderLink<readonly PartedPass[]>;
  /** Links a technique. A technique is linked again if its text or an included chunk has changed. */
  linkTechnique(file: string, source: string, options: TechniqueOptions): ShaderLink<TechniqueText>;
  /** Links the pass that computes the depth of a shader with `"SCRIM_DEPTH": "over"`. Other shaders are not allowed. */
  linkDepth(file: string, source: string, variant: LinkVariant): PartedPass;
}

interface Entry {
  readonly source: string;
  readonly vertex: string | null;
  readonly shader: Result<IsfShader>;
  readonly links: Map<string, ShaderLink<readonly PartedPass[]>>;
  readonly depths: Map<string, PartedPass>;
}

interface Definition {
  readonly source: string;
  readonly definition: Result<NodeDefinition>;
}

export function createShaderStore(): ShaderStore {
  const entries = new Map<string, Entry>();
  const definitions = new Map<string, Definition>();
  const techniques = createTechniqueStore();

  function entryOf(file: string, source: string, vertex: string | null): Entry {
    const known = entries.get(file);
    if (known?.source === source && known.vertex === vertex) return known;
    const shader = readImageShader(source, file, vertex);
    const made: Entry = { source, vertex, shader, links: new Map(), depths: new Map() };
    entries.set(file, made);
    return made;
  }

  /** The cached entry of a file with any vertex shader, because the header does not depend on that; a new entry if there is none. */
  function headerOf(file: string, source: string): Entry {
    const known = entries.get(file);
    return known?.source === source ? known : entryOf(file, source, null);
  }

  return {
    read: (file, source) => headerOf(file, source).shader,
    readDefinition: (file, source) => {
      if (isTechnique(source, file)) return techniques.readDefinition(file, source);
      const known = definitions.get(file);
      if (known?.source === source) return known.definition;
      // Without its vertex shader, so that the node type depends on the text alone.
      const { vertex, shader } = headerOf(file, source);
      const { output, diagnostics } = vertex === null ? shader : readImageShader(source, file, null);
      const definition = { output: output && isfDefinition(output, shaderName(file)), diagnostics };
      definitions.set(file, { source, definition });
      return definition;
    },
    link: (file, source, vertex, variant) => {
      const { shader, links } = entryOf(file, source, vertex);
      if (shader.output === null) return { output: null, diagnostics: shader.diagnostics, above: null };
      const key = keyOf(variant);
      const known = links.get(key) ?? linkImage(variantOf(shader.output, variant), variant);
      links.set(key, known);
      return known;
    },
    linkTechnique: techniques.link,
    linkDepth: (file, source, variant) => {
      const { shader, depths } = headerOf(file, source);
      if (shader.output === null) throw new Error(`${file} has been linked and cannot be read.`);
      const key = keyOf(variant);
      const known = depths.get(key) ?? linkIsfDepth(variantOf(shader.output, variant), { node: '', ...variant });
      depths.set(key, known);
      return known;
    },
  };
}

function variantOf(shader: IsfShader, { scene }: LinkVariant): IsfShader {
  return scene && shader.encoding === 'either' ? sceneVariant(shader) : shader;
}

function linkImage(shader: IsfShader, variant: LinkVariant): ShaderLink<readonly PartedPass[]> {
  const options = { node: '', ...variant };
  const { output, diagnostics } = linkIsf(shader, options);
  const [refused] = diagnostics;
  const above = output === null && refused !== undefined ? linkAbove(shader, options, refused) : null;
  if (above === null) return { output, diagnostics, above: null };
  const shaders = (above.output ?? []).map((pass) => pass.shader);
  return { output, diagnostics: [...above.diagnostics, ...diagnostics], above: { shaders, before: above.before } };
}

function keyOf({ loopBudget, absent, withoutDepth, scene }: LinkVariant): string {
  return [String(loopBudget), String(scene), absent.join(), withoutDepth.join()].join(';');
}
