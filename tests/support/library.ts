import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import { libraryOf, type NodeLibrary } from '../../nodes/kit/definition.ts';

/** The library that ships, without any project's own shaders. */
export const LIBRARY: NodeLibrary = libraryOf(DEFINITIONS, SHADERS);
