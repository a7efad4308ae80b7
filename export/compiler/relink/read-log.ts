import type { NodeDefinition, NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { PartedPass } from '../../glsl/link/link-parts.ts';
import type { ShaderLink } from '../shaders/shader-link.ts';
import type { LinkVariant, ShaderStore } from '../shaders/shader-store.ts';

/** What a compilation read of the library and the shader store. */
export interface ReadLog {
  /** Node types; undefined for unknown ones. */
  readonly definitions: Map<string, NodeDefinition | undefined>;
  /** Texts of shaders, chunks and fonts by name; undefined for missing ones. */
  readonly texts: Map<string, string | undefined>;
  /** Linked image shaders, and how they were requested. */
  readonly links: Map<ImageLink, LinkRequest>;
  /** Files of which more than the linked passes was read: headers, computed depth, techniques. */
  readonly otherwise: Set<string>;
}

export type ImageLink = ShaderLink<readonly PartedPass[]>;

export interface LinkRequest {
  readonly file: string;
  readonly variant: LinkVariant;
}

/** A library and a store that log what is read of them. */
export interface LoggedReads {
  readonly library: NodeLibrary;
  readonly shaders: ShaderStore;
  readonly log: ReadLog;
}

export function logReads(library: NodeLibrary, shaders: ShaderStore): LoggedReads {
  const log: ReadLog = { definitions: new Map(), texts: new Map(), links: new Map(), otherwise: new Set() };
  const read = <K, V>(known: Map<K, V>, key: K, value: V): V => {
    known.set(key, value);
    return value;
  };
  return {
    log,
    library: {
      definition: (type) => read(log.definitions, type, library.definition(type)),
      shader: (name) => read(log.texts, name, library.shader(name)),
      types: library.types,
    },
    shaders: {
      readDefinition: shaders.readDefinition,
      read: (file, source) => {
        log.otherwise.add(file);
        return shaders.read(file, source);
      },
      link: (file, source, vertex, variant) => {
        const link = shaders.link(file, source, vertex, variant);
        log.links.set(link, { file, variant });
        return link;
      },
      linkTechnique: (file, source, options) => {
        log.otherwise.add(file);
        return shaders.linkTechnique(file, source, options);
      },
      linkDepth: (file, source, variant) => {
        log.otherwise.add(file);
        return shaders.linkDepth(file, source, variant);
      },
    },
  };
}
