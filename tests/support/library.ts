import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import type { NodeDefinition, NodeLibrary } from '../../nodes/kit/definition.ts';

const byType = new Map<string, NodeDefinition>(DEFINITIONS.map((definition) => [definition.type, definition]));

/** The library that ships, without any project's own shaders. */
export const LIBRARY: NodeLibrary = {
  definition: (type) => byType.get(type),
  shader: (name) => (Object.hasOwn(SHADERS, name) ? SHADERS[name] : undefined),
  types: () => byType.keys(),
};
