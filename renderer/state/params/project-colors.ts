import { boundValue, sameValue } from '../../../export/graph/library/param-value.ts';
import type { Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { hexFromColor, type Rgba } from '../../ui/color-text.ts';

/**
 * The colors that params of the project have been set to, without alpha: those used most first, then in the order of the graphs. Defaults,
 * and colors that come from wires, keyframes or expressions, are left out.
 *
 * @returns Display-referred sRGB, each as `#rrggbb`, at most `most`.
 */
export function projectColors({ graphs }: Pick<Project, 'graphs'>, library: NodeLibrary, most: number): string[] {
  const counts = new Map<string, number>();
  for (const { nodes, wires } of Object.values(graphs)) {
    const wired = new Set(wires.map(({ to }) => `${to.node} ${to.port}`));
    for (const [id, { type, params }] of Object.entries(nodes)) {
      for (const [name, param] of Object.entries(library.definition(type)?.params ?? {})) {
        const binding = param.type === 'color' && !wired.has(`${id} ${name}`) ? getOwn(params, name) : undefined;
        const value = binding && boundValue(binding);
        if (value === undefined || sameValue(value, param.default)) continue;
        const hex = hexFromColor(value as Rgba);
        counts.set(hex, (counts.get(hex) ?? 0) + 1);
      }
    }
  }
  return [...counts]
    .sort(([, a], [, b]) => b - a)
    .slice(0, most)
    .map(([hex]) => hex);
}
