import { choiceOptions } from '../../../nodes/kit/choice-options.ts';
import type { Control } from '../../program/program.ts';
import type { FlatNode } from '../flat-graph.ts';
import type { Schedule } from '../schedule/schedule.ts';
import { startValue } from '../schedule/slot-allocator.ts';

/** The controls that affect the output and are not connected, sorted by `place` and then by id. */
export function collectControls({ nodes, working, slots }: Pick<Schedule, 'nodes' | 'working' | 'slots'>): Control[] {
  const shown = nodes.filter(
    (node) => node.definition.control !== undefined && working.has(node.id) && Object.hasOwn(slots.params, paramKey(node)),
  );
  const places = new Map(shown.map((node) => [node, numberOf(node, 'place')]));
  return shown
    .sort((a, b) => (places.get(a) ?? 0) - (places.get(b) ?? 0) || (a.id < b.id ? -1 : 1))
    .map((node) => controlOf(node, slots.numbers[slots.slots[slots.params[paramKey(node)] ?? -1]?.offset ?? -1] ?? 0));
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
