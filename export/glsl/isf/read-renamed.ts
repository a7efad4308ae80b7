import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import { entries, type Header, items, numberOf, property, textOf } from './isf-header.ts';

type RenamedParams = NonNullable<NodeDefinition['renamed']>;

/**
 * Reads `SCRIM_RENAMED`: earlier names of inputs, one entry per change of the file, oldest first: `[{ "outlineM": { "TO": "outlinePx",
 * "TIMES": 750 } }]`. Each is a migration to the next version of the node type. `"WAS": 0` is a number that was the default in the earlier
 * version; projects of that version keep it.
 */
export function readRenamed(header: Header): RenamedParams {
  const list = property(header.root, 'SCRIM_RENAMED');
  if (list !== undefined && list.type !== 'array') header.error(list, 'SCRIM_RENAMED must be a list: [ { "old": { "TO": "new" } } ].');
  return items(list).map((step) =>
    Object.fromEntries(
      (step.type === 'object' ? entries(step) : []).flatMap(([key, value]) => {
        const from = textOf(key);
        const to = textOf(property(value, 'TO'));
        const written = property(value, 'TIMES');
        const times = written === undefined ? 1 : numberOf(written);
        const before = property(value, 'WAS');
        const was = before === undefined ? null : numberOf(before);
        const isRead = from !== null && to !== null && times !== null && times > 0 && (before === undefined || was !== null);
        if (isRead) return [[from, { to, times, ...(was === null ? {} : { was }) }]];
        header.error(
          key,
          'An entry of SCRIM_RENAMED is invalid. Give the new name as TO, a positive factor as TIMES, and an earlier default that is a number as WAS.',
        );
        return [];
      }),
    ),
  );
}
