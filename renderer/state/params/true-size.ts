import type { ParamValue } from '../../../nodes/kit/definition.ts';
import { endGesture } from '../document/apply.ts';
import type { Editor } from '../editor/editor.ts';
import { findParam } from './bound-param.ts';
import { editParams } from './edit-params.ts';
import { clampTo, rangeOf } from './units.ts';
import { boundValue } from './value-text.ts';

/**
 * Changes the `scale` of a node so that a length that is measured in the scene becomes the true one.
 *
 * @returns False if the node does not exist any more.
 */
export function scaleToLength(editor: Editor, node: string, measuredM: number, trueM: number): boolean {
  const found = findParam(editor, node, 'scale');
  if (found?.definition.type !== 'number') return false;
  const scale = (Number(boundValue(found.definition, found.binding)) * trueM) / measuredM;
  const value = clampTo(Number(scale.toPrecision(6)), rangeOf({ ...found.definition, unit: 'none' }));
  return edit(editor, 'Set true size', node, 'scale', value);
}

/**
 * Moves a node up or down so that what is at `floorM` above the floor now is at height 0.
 *
 * @returns False if the node does not exist any more.
 */
export function standOnFloor(editor: Editor, node: string, floorM: number): boolean {
  const found = findParam(editor, node, 'positionM');
  if (!found) return false;
  const [x = 0, y = 0, z = 0] = boundValue(found.definition, found.binding) as readonly number[];
  const value = [x, Number((y - floorM).toFixed(4)), z];
  return edit(editor, 'Put floor at height 0', node, 'positionM', value);
}

function edit(editor: Editor, label: string, node: string, param: string, value: ParamValue): boolean {
  const done = editParams(editor, label, node, [{ param, value }], label);
  endGesture(editor);
  return done;
}
