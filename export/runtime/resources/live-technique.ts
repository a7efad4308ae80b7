import { IDENTITY } from '../../../nodes/kit/matrices.ts';
import type { LayerOutput } from '../../../nodes/kit/runtime.ts';
import type { TechniqueImage, TechniqueImageView, TechniqueUniformView, TechniqueView } from '../../../nodes/kit/technique-view.ts';
import type { NumberView, ToggleView, VectorView, Writable } from '../../../nodes/kit/value-views.ts';
import type { PassSampler, ResourceId, TechniqueResource, TechniqueUniform } from '../../program/program.ts';
import type { ImageStore } from '../gl/image-store.ts';
import { fitted } from '../passes/fit.ts';
import type { PlayState } from '../play-state.ts';
import type { Target } from '../targets/target.ts';
import { createSlotView, type Slots } from '../values/slots.ts';

/** A technique that is kept over recompiles. Its readers see a new `version` when its shader text has changed. */
export interface LiveTechnique {
  readonly view: TechniqueView;
  /** Connects the technique to the shader text, slots and layers of a new program, before the program's first frame. */
  point(resource: TechniqueResource, parts: TechniqueParts): void;
}

/** A layer of a running program: drawn by the runtime (`target`), or provided by a node (`external`). */
export type LiveLayer =
  | { readonly kind: 'target'; readonly domain: 'view' | 'image'; readonly target: Target; readonly isViewed: boolean }
  | { readonly kind: 'external'; readonly domain: 'view' | 'image'; readonly layer: LayerOutput };

/** The parts of a running program that a technique reads. */
export interface TechniqueParts {
  readonly images: ImageStore;
  readonly state: PlayState;
  /** Returns the layer with this id; undefined if the resource is not a layer. */
  readonly layer: (id: ResourceId) => LiveLayer | undefined;
  readonly slots: Slots;
}

export function createLiveTechnique(id: string): LiveTechnique {
  const view: Writable<TechniqueView> = { version: 0, key: '', vertex: '', fragment: '', passes: [], uniforms: [], images: [] };
  let text = '';
  return {
    view,
    point: (resource, { layer, slots, images, state }) => {
      const { vertex, fragment, passes, uniforms, unread = [], samplers = [], pictures: carried = [] } = resource;
      const names = [...samplers, ...carried].map(({ name }) => name);
      const next = JSON.stringify([vertex, fragment, passes, unread, uniforms.map(({ name, type }) => [name, type]), names]);
      if (next !== text) {
        text = next;
        view.version++;
        view.key = `${id}#${view.version}`;
        Object.assign(view, { vertex, fragment, passes, unread });
      }
      const time: NumberView = {
        get value() {
          return state.frame.timeS;
        },
      };
      view.uniforms = [...uniforms.map((uniform) => uniformView(uniform, slots)), { name: 'a_TIME', kind: 'number', view: time }];
      view.images = [
        ...samplers.map((sampler) => ({ name: sampler.name, at: layerView(layerOf(sampler, layer), sampler.fit) })),
        ...carried.map(({ name, data }) => ({ name, at: () => techniqueImageOf(images.texture(data)) })),
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
    case 'vector2':
    case 'vector3':
    case 'vector4':
      return { name, kind: 'vector', view: view as VectorView };
    case 'text':
    case 'curve':
    case 'gradient':
    case undefined:
      throw new Error(`The technique reads ${name}, which has no slot of numbers.`);
  }
}

// Valid until the next call.
const scratchImage: Writable<TechniqueImage> = { texture: null, uvFromViewUv: IDENTITY, widthPx: 1, heightPx: 1 };

function techniqueImageOf(texture: WebGLTexture | null): TechniqueImage {
  return Object.assign(scratchImage, { texture, uvFromViewUv: IDENTITY });
}

function layerOf({ name, source }: PassSampler, layer: TechniqueParts['layer']): LiveLayer {
  const resource = source.kind === 'color' ? layer(source.resource) : undefined;
  if (resource === undefined) throw new Error(`A technique reads ${name}, which is not a layer.`);
  return resource;
}

/** Reads the image of a layer for a view, which is valid until the next call. */
export function layerView(resource: LiveLayer, fit: PassSampler['fit']): TechniqueImageView['at'] {
  return (viewIndex, viewWidthPx, viewHeightPx) => {
    const index = resource.domain === 'view' ? viewIndex : 0;
    if (resource.kind === 'external') {
      const layer = resource.layer.views[index];
      scratchImage.texture = layer?.texture ?? null;
      scratchImage.widthPx = resource.domain === 'view' ? viewWidthPx : (layer?.widthPx ?? 0);
      scratchImage.heightPx = resource.domain === 'view' ? viewHeightPx : (layer?.heightPx ?? 0);
      scratchImage.uvFromViewUv = layer?.uvFromViewUv ?? IDENTITY;
    } else {
      // Targets have no size while a program is only compiled.
      const buffer = resource.target.peek(index) && resource.target.front(index);
      scratchImage.texture = buffer?.color ?? null;
      scratchImage.widthPx = buffer?.widthPx ?? 0;
      scratchImage.heightPx = buffer?.heightPx ?? 0;
      scratchImage.uvFromViewUv = IDENTITY;
    }
    const { uvFromViewUv, widthPx, heightPx } = scratchImage;
    scratchImage.uvFromViewUv = fitted(uvFromViewUv as Float32Array, fit, widthPx, heightPx, viewWidthPx, viewHeightPx);
    return scratchImage;
  };
}
