import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import { libraryOf, type NodeLibrary } from '../../nodes/kit/definition.ts';

/** The library of Scrim without the shaders of a project. */
export const LIBRARY: NodeLibrary = libraryOf(DEFINITIONS, SHADERS);
