import type { DrawOperation, PassUniform } from '../../program/program.ts';
import type { PlayState } from '../play-state.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { MaterialEffects } from '../scene-backend.ts';
import type { Slots } from '../values/slots.ts';

/** The effects in the materials of one drawing operation, with uniforms that all its materials share. */
export interface LiveEffects extends MaterialEffects {
  /** Applies the values of the frame; called before every draw. */
  set(state: PlayState): void;
}

type SetValue = (state: PlayState) => void;

const SIZES: Readonly<Partial<Record<PassUniform['type'], number>>> = { vec2: 2, vec3: 3, vec4: 4 };

/** Creates the effects of a drawing operation; null if it has none. */
export function createMaterialEffects(
  { effects }: Pick<DrawOperation, 'effects'>,
  resources: LiveResources,
  slots: Slots,
): LiveEffects | null {
  if (!effects) return null;
  const uniforms: Record<string, { value: unknown }> = {};
  const setters: SetValue[] = [];
  for (const uniform of effects.uniforms) {
    const size = SIZES[uniform.type];
    const held = { value: (size === undefined ? 0 : new Float32Array(size)) as unknown };
    uniforms[uniform.name] = held;
    setters.push(setterOf(uniform, held, resources, slots));
  }
  const textures: Record<string, WebGLTexture> = {};
  for (const { name, source } of effects.samplers ?? []) {
    if (source.kind !== 'table') throw new Error(`Materials have no image for ${name}.`);
    const { table } = liveResource(resources, source.resource, 'table');
    textures[name] = table.texture;
    setters.push(table.update);
  }
  return {
    text: effects.text,
    uniforms,
    textures,
    set: (state) => {
      for (let i = 0; i < setters.length; i++) setters[i]?.(state);
    },
  };
}

function setterOf({ name, type, source }: PassUniform, held: { value: unknown }, resources: LiveResources, slots: Slots): SetValue {
  if ('slot' in source) {
    const { numbers } = slots;
    const at = slots.offset(source.slot);
    const { value } = held;
    if (!(value instanceof Float32Array)) {
      return () => {
        const number = numbers[at] ?? 0;
        held.value = type === 'int' ? number | 0 : type === 'bool' ? Number(number !== 0) : number;
      };
    }
    return () => {
      for (let i = 0; i < value.length; i++) value[i] = numbers[at + i] ?? 0;
    };
  }
  if ('pulses' in source) {
    const queues = source.pulses.map((id) => liveResource(resources, id, 'pulses').queue);
    return () => {
      held.value = Number(queues.some(hasPulse));
    };
  }
  switch (source.builtin) {
    case 'TIME':
      return ({ frame }) => {
        held.value = frame.timeS;
      };
    case 'TIMEDELTA':
      return ({ frame }) => {
        held.value = frame.deltaS;
      };
    case 'FRAMEINDEX':
      return ({ frame }) => {
        held.value = frame.index;
      };
    default:
      throw new Error(`Materials have no value for ${name}.`);
  }
}

function hasPulse({ count }: { readonly count: number }): boolean {
  return count > 0;
}
