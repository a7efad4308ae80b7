import type { NumberView, ToggleView, VectorView, Writable } from '../../../nodes/kit/runtime.ts';
import type { TechniqueUniformView, TechniqueView } from '../../../nodes/kit/technique-view.ts';
import type { TechniqueResource, TechniqueUniform } from '../../program/program.ts';
import { createSlotView, type Slots } from '../values/slots.ts';

/** A technique that lives on from program to program: those who drew with it see a new version when its text has changed. */
export interface LiveTechnique {
  readonly view: TechniqueView;
  /** Takes over the text and where the values are; before the first frame of a program. */
  point(resource: TechniqueResource, slots: Slots): void;
}

export function createLiveTechnique(id: string): LiveTechnique {
  const view: Writable<TechniqueView> = { version: 0, key: '', vertex: '', fragment: '', passes: [], uniforms: [] };
  let text = '';
  return {
    view,
    point: (resource, slots) => {
      const { vertex, fragment, passes, uniforms } = resource;
      const next = JSON.stringify([vertex, fragment, passes, uniforms.map(({ name, type }) => [name, type])]);
      if (next !== text) {
        text = next;
        view.version++;
        view.key = `${id}#${view.version}`;
        Object.assign(view, { vertex, fragment, passes });
      }
      view.uniforms = uniforms.map((uniform) => uniformView(uniform, slots));
    },
  };
}

function uniformView({ name, slot }: TechniqueUniform, slots: Slots): TechniqueUniformView {
  const view = createSlotView(slots, slot);
  switch (slots.slots[slot]?.type) {
    case 'toggle':
      return { name, kind: 'toggle', view: view as ToggleView };
    case 'number':
      return { name, kind: 'number', view: view as NumberView };
    case 'color':
      return { name, kind: 'color', view: view as VectorView };
    default:
      return { name, kind: 'vector', view: view as VectorView };
  }
}
