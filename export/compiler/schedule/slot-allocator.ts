import { CURVE_NUMBERS, paddedPoints } from '../../../nodes/kit/curve.ts';
import { type ParamDefinition, type ParamValue, paramWireType } from '../../../nodes/kit/definition.ts';
import { GRADIENT_NUMBERS, STOP_NUMBERS } from '../../../nodes/kit/gradient.ts';
import { VALUE_SIZES, type ValueType } from '../../../nodes/kit/wire-types.ts';
import { boundValue, clampToRange } from '../../graph/library/param-value.ts';
import type { Binding } from '../../graph/project.ts';
import type { Slot, SlotTable, SlotType } from '../../program/program.ts';
import { type FlatGraph, type FlatNode, portKey, type Source, sourcesAt } from '../flat-graph.ts';

/** Assigns a slot to every value of the program. */
export interface SlotAllocator {
  /** The slot that an output writes; repeated calls return the same one. */
  ofOutput(source: Source, type: ValueType): number;
  /** The slot that a uniform param reads: its own, or that of the connected output. */
  ofParam(node: FlatNode, name: string): number;
  /** The slot of an output, read as another type that converts without loss. */
  ofInput(source: Source, type: ValueType): number;
  table(): SlotTable;
}

/** A uniform param with a track or an expression, and the slot to write. */
export interface MovedParam {
  readonly node: FlatNode;
  readonly name: string;
  readonly definition: ParamDefinition;
  readonly binding: MovingBinding;
  readonly slot: number;
}

export type MovingBinding = Extract<Binding, { track: unknown } | { expression: unknown }>;

/** The track or expression of a param whose port is not connected; null if the value is constant. */
export function movingBinding(node: FlatNode, name: string): MovingBinding | null {
  const binding = node.inputs.has(name) ? undefined : node.bindings.get(name);
  return binding && ('track' in binding || 'expression' in binding) ? binding : null;
}

/**
 * Params of `compiledIn` nodes get slots without a name, because setting them would not update all of the program. Params with a track or
 * expression have no name either; `onMoved` is called once for each, when its slot is first requested.
 */
export function createSlotAllocator(
  graph: FlatGraph,
  compiledIn: ReadonlySet<string>,
  onMoved: (moved: MovedParam) => void,
): SlotAllocator {
  const numbers: number[] = [];
  const texts: string[] = [];
  const slots: Slot[] = [];
  const params: [string, number][] = [];
  const outputs = new Map<string, number>();
  const own = new Map<string, number>();
  const converted = new Map<string, number>();
  const outerNames = namesFromOutside(graph);

  function add(type: SlotType, value: ParamValue): number {
    const isText = type === 'text';
    slots.push({ type, offset: isText ? texts.length : numbers.length });
    if (isText) texts.push(String(value));
    else if (typeof value === 'object') numbers.push(...padded(type, value));
    else numbers.push(Number(value));
    return slots.length - 1;
  }

  function ofOutput(source: Source, type: ValueType): number {
    const key = portKey(source);
    const slot = outputs.get(key) ?? add(type, type === 'text' ? '' : new Array<number>(VALUE_SIZES[type]).fill(0));
    outputs.set(key, slot);
    return slot;
  }

  /** A toggle is 0 or 1 and a color has four numbers, so the same slot can be read as either type. */
  function ofInput(source: Source, type: ValueType): number {
    const output = graph.nodes.get(source.node)?.definition.outputs[source.port];
    const slot = ofOutput(source, output?.type as ValueType);
    const offset = slots[slot]?.offset ?? 0;
    if (slots[slot]?.type === type) return slot;
    const key = `${slot} ${type}`;
    const known = converted.get(key) ?? slots.push({ type, offset }) - 1;
    converted.set(key, known);
    return known;
  }

  return {
    ofOutput,
    ofInput,
    ofParam: (node, name) => {
      const definition = node.definition.params[name];
      const wireType = definition && paramWireType(definition);
      const type = definition?.type === 'curve' || definition?.type === 'gradient' ? definition.type : wireType;
      if (!definition || !type) throw new Error(`${node.id} has no uniform param ${name}.`);
      const [source] = sourcesAt(node, name);
      if (source && wireType) return ofInput(source, wireType);
      const key = `${node.id}.${name}`;
      const known = own.get(key);
      if (known !== undefined) return known;
      const slot = add(type, startValue(node, name, definition));
      own.set(key, slot);
      const binding = movingBinding(node, name);
      if (binding) onMoved({ node, name, definition, binding, slot });
      else if (!compiledIn.has(node.id)) for (const address of [key, ...(outerNames.get(key) ?? [])]) params.push([address, slot]);
      return slot;
    },
    table: () => ({ numbers, texts, slots, params: Object.fromEntries(params) }),
  };
}

function padded(type: SlotType, value: readonly number[]): readonly number[] {
  if (type === 'curve') return paddedPoints(value, 2, CURVE_NUMBERS);
  return type === 'gradient' ? paddedPoints(value, STOP_NUMBERS, GRADIENT_NUMBERS) : value;
}

/** Initial value of an unconnected param; for a structure param, its value. */
export function startValue(node: FlatNode, name: string, definition: ParamDefinition): ParamValue {
  const binding = node.bindings.get(name);
  const value = (binding && boundValue(binding)) ?? definition.default;
  return clampToRange(definition, value);
}

function namesFromOutside({ aliases }: FlatGraph): ReadonlyMap<string, readonly string[]> {
  const names = new Map<string, string[]>();
  for (const [outside, inside] of aliases) {
    const list = names.get(inside);
    if (list) list.push(outside);
    else names.set(inside, [outside]);
  }
  return names;
}
