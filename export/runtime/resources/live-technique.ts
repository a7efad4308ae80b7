import type { NumberView, ToggleView, VectorView, Writable } from '../../../nodes/kit/runtime.ts';
import type { TechniqueImage, TechniqueImageView, TechniqueUniformView, TechniqueView } from '../../../nodes/kit/technique-view.ts';
import type { PassSampler, TechniqueResource, TechniqueUniform } from '../../program/program.ts';
import type { Engine } from '../engine.ts';
import { fitted } from '../passes/fit.ts';
import { createSlotView, type Slots } from '../values/slots.ts';
import { IDENTITY } from './identity.ts';
import type { LiveResources } from './resources.ts';

/** A technique that lives on from program to program: those who drew with it see a new version when its text has changed. */
export interface LiveTechnique {
  readonly view: TechniqueView;
  /** Takes over the text and where values and layers are; before the first frame of a program. */
  point(resource: TechniqueResource, parts: TechniqueParts): void;
}

/** Where a technique's values and pictures are in a running program. */
export interface TechniqueParts extends Pick<Engine, 'pictures' | 'state'> {
  readonly live: LiveResources;
  readonly slots: Slots;
}

export function createLiveTechnique(id: string): LiveTechnique {
  const view: Writable<TechniqueView> = { version: 0, key: '', vertex: '', fragment: '', passes: [], uniforms: [], images: [] };
  let text = '';
  return {
    view,
    point: (resource, { live, slots, pictures, state }) => {
      const { vertex, fragment, passes, uniforms, samplers = [], pictures: carried = [] } = resource;
      const names = [...samplers, ...carried].map(({ name }) => name);
      const next = JSON.stringify([vertex, fragment, passes, uniforms.map(({ name, type }) => [name, type]), names]);
      if (next !== text) {
        text = next;
        view.version++;
        view.key = `${id}#${view.version}`;
        Object.assign(view, { vertex, fragment, passes });
      }
      const time: NumberView = {
        get value() {
          return state.frame.timeS;
        },
      };
      view.uniforms = [...uniforms.map((uniform) => uniformView(uniform, slots)), { name: 'a_TIME', kind: 'number', view: time }];
      view.images = [
        ...samplers.map((sampler) => layerView(sampler, live)),
        ...carried.map(({ name, data }) => ({ name, at: () => pictureImage(pictures.texture(data)) })),
      ];
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

// Read by the call that asked for it, before anything else can.
const scratchImage: Writable<TechniqueImage> = { texture: null, uvFromViewUv: IDENTITY, widthPx: 1, heightPx: 1 };

function pictureImage(texture: WebGLTexture | null): TechniqueImage {
  return Object.assign(scratchImage, { texture, uvFromViewUv: IDENTITY });
}

function layerView({ name, source, fit }: PassSampler, live: LiveResources): TechniqueImageView {
  const resource = source.kind === 'color' ? live.get(source.resource) : undefined;
  if (resource?.kind !== 'target' && resource?.kind !== 'external') throw new Error(`A technique reads ${name}, which is no layer.`);
  return {
    name,
    at: (viewIndex, viewWidthPx, viewHeightPx) => {
      const index = resource.domain === 'view' ? viewIndex : 0;
      if (resource.kind === 'external') {
        const layer = resource.layer.views[index];
        scratchImage.texture = layer?.texture ?? null;
        scratchImage.widthPx = resource.domain === 'view' ? viewWidthPx : (layer?.widthPx ?? 0);
        scratchImage.heightPx = resource.domain === 'view' ? viewHeightPx : (layer?.heightPx ?? 0);
        scratchImage.uvFromViewUv = layer?.uvFromViewUv ?? IDENTITY;
      } else {
        // Nothing has a size while programs are only compiled.
        const buffer = resource.target.peek(index) && resource.target.front(index);
        scratchImage.texture = buffer?.color ?? null;
        scratchImage.widthPx = buffer?.widthPx ?? 0;
        scratchImage.heightPx = buffer?.heightPx ?? 0;
        scratchImage.uvFromViewUv = IDENTITY;
      }
      const { uvFromViewUv, widthPx, heightPx } = scratchImage;
      scratchImage.uvFromViewUv = fitted(uvFromViewUv as Float32Array, fit, widthPx, heightPx, viewWidthPx, viewHeightPx);
      return scratchImage;
    },
  };
}
