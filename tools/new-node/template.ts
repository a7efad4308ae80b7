import type { NodeDefinition } from '../../nodes/kit/definition.ts';

/** Template of a new node folder. Its files pass all checks before the author edits them. */
export interface Template {
  definition(type: string, title: string): NodeDefinition;
  /** The files beside `definition.ts`: name in the folder → text, unformatted. */
  files(type: string, name: string): Readonly<Record<string, string>>;
}
