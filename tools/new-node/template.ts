import type { NodeDefinition } from '../../nodes/kit/definition.ts';

/** What a new folder starts as; green at once, and meant to be changed. */
export interface Template {
  definition(type: string, title: string): NodeDefinition;
  readonly runtime: string;
  test(type: string): string;
}
