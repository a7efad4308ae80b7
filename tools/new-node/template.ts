import type { NodeDefinition } from '../../nodes/kit/definition.ts';

/** The start of a new node folder: it passes every check as it is, and is then edited. */
export interface Template {
  definition(type: string, title: string): NodeDefinition;
  /** The files beside `definition.ts`: name in the folder → text, unformatted. */
  files(type: string, name: string): Readonly<Record<string, string>>;
}
