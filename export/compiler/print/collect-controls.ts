import { choiceOptions } from '../../../nodes/kit/choice-options.ts';
import type { VisitorParam } from '../../../nodes/kit/definition.ts';
import type { Control } from '../../program/program.ts';
import type { FlatNode } from '../flat-graph.ts';
import type { Schedule } from '../schedule/schedule.ts';
import { startValue } from '../schedule/slot-allocator.ts';

/**
 * The controls that affect the output and are not connected: first nodes that are controls, sorted by `place` and then by id, then params
 * that their node shows to visitors.
 */
export function collectControls(schedule: Pick<Schedule, 'nodes' | 'working' | 'slots'>): Control[] {
  return [...controlNodes(schedule), ...visitorParams(schedule)];
}

function controlNodes({ nodes, working, slots }: Pick<Schedule, 'nodes' | 'working' | 'slots'>): Control[] {
  const shown = nodes.filter(
    (node) => node.definition.control !== undefined && working.has(node.id) && Object.hasOwn(slots.params, paramKey(node)),
  );
  const places = new Map(shown.map((node) => [node, numberOf(node, 'place')]));
  return shown
    .sort((a, b) => (places.get(a) ?? 0) - (places.get(b) ?? 0) || (a.id < b.id ? -1 : 1))
    .map((node) => controlOf(node, slots.numbers[slots.slots[slots.params[paramKey(node)] ?? -1]?.offset ?? -1] ?? 0));
}

/** Controls for the params that nodes show to visitors. A param without a slot is left out, because it is connected or has no effect. */
function visitorParams({ nodes, working, slots }: Pick<Schedule, 'nodes' | 'working' | 'slots'>): Control[] {
  const shown = nodes.filter((node) => {
    const by = node.definition.visitorParams?.by;
    return by !== undefined && working.has(node.id) && structureValue(node, by) === true;
  });
  return shown
    .sort((a, b) => (a.id < b.id ? -1 : 1))
    .flatMap((node) =>
      (node.definition.visitorParams?.params ?? []).flatMap((shownParam) => {
        const slot = slots.slots[slots.params[`${node.id}.${shownParam.param}`] ?? -1];
        return slot ? [visitorControl(node, shownParam, slots.numbers[slot.offset] ?? 0)] : [];
      }),
    );
}

function visitorControl(node: FlatNode, { param: name, around }: VisitorParam, value: number): Control {
  const param = node.definition.params[name];
  const base = { node: node.id, param: name, label: param?.label ?? name, value };
  if (param?.type === 'toggle') return { ...base, kind: 'toggle' };
  if (param?.type === 'choice') return { ...base, kind: 'choice', options: param.options.map(({ label }) => label) };
  if (param?.type !== 'number' || param.min === undefined || param.max === undefined) throw new Error(`${name} is no param for visitors.`);
  const [min, max] = around === undefined ? [param.min, param.max] : [value - around, value + around];
  return { ...base, kind: 'slider', min, max, step: param.step ?? 0, ...(param.unit === 'rad' ? { unit: param.unit } : {}) };
}

function controlOf(node: FlatNode, value: number): Control {
  const { control } = node.definition;
  if (control === undefined) throw new Error(`${node.id} is no control.`);
  const base = { node: node.id, param: paramOf(node), label: textOf(node, 'label') || node.definition.title, value };
  switch (control) {
    case 'slider': {
      const [a, b] = [numberOf(node, 'min'), numberOf(node, 'max')];
      return { ...base, kind: 'slider', min: Math.min(a, b), max: Math.max(a, b), step: numberOf(node, 'step') };
    }
    case 'toggle':
    case 'button':
      return { ...base, kind: control };
    case 'choice':
      return { ...base, kind: 'choice', options: choiceOptions(textOf(node, 'options')) };
  }
}

function paramOf({ definition }: FlatNode): string {
  return definition.control === 'button' ? 'presses' : 'value';
}

function paramKey(node: FlatNode): string {
  return `${node.id}.${paramOf(node)}`;
}

function numberOf(node: FlatNode, name: string): number {
  return Number(structureValue(node, name));
}

function textOf(node: FlatNode, name: string): string {
  return String(structureValue(node, name)).trim();
}

function structureValue(node: FlatNode, name: string) {
  const param = node.definition.params[name];
  if (!param) throw new Error(`${node.id} is a control without the param ${name}.`);
  return startValue(node, name, param);
}
