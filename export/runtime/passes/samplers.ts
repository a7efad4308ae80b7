import { IDENTITY } from '../../../nodes/kit/matrices.ts';
import type { LayerOutput } from '../../../nodes/kit/runtime.ts';
import type { RoomDepthOutput } from '../../../nodes/kit/scene-lists.ts';
import type { LayerDepthRef, PassOperation, PassSampler } from '../../program/program.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { PlayState } from '../play-state.ts';
import type { LiveTable } from '../resources/live-table.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { SoundTexture } from '../sound/sound-texture.ts';
import type { Target } from '../targets/target.ts';
import { setDecode } from './depth-decode.ts';
import { fitted } from './fit.ts';
import type { ImportedImage, Imports } from './imports.ts';

/** The size of an image as a uniform value, valid within one call; uniforms are copied when they are set. */
const scratchSize = new Float32Array(2);

/** One texture that a pass reads. */
export interface Sampler {
  /** Resolves multisampled images, before the framebuffer of the pass is bound. */
  prepare(state: PlayState): void;
  /** Sets texture, UV matrix, size and depth decoding of the current program. */
  bind(state: PlayState): void;
}

/**
 * Locations of the uniforms of a sampler; null for those that the linked shader does not use. A shader may, for example, read only the size
 * of an image.
 */
interface Locations {
  readonly texture: WebGLUniformLocation | null;
  readonly uv: WebGLUniformLocation | null;
  readonly size: WebGLUniformLocation | null;
  readonly decode: WebGLUniformLocation | null;
  /** Location of the uniform that says whether room depth is interpolated. */
  readonly interpolate: WebGLUniformLocation | null;
}

export function createSamplers(
  gl: WebGL2RenderingContext,
  drawer: PassDrawer,
  program: GlProgram,
  operation: PassOperation,
  resources: LiveResources,
  imports: Imports,
): Sampler[] {
  const samplers: Sampler[] = [];
  for (const spec of operation.samplers) {
    const locations: Locations = {
      texture: program.uniform(spec.name),
      uv: program.uniform(`${spec.name}_uvFromViewUv`),
      size: program.uniform(`${spec.name}_size`),
      decode: program.uniform(`${spec.name}_decode`),
      interpolate: program.uniform(`${spec.name}_interpolate`),
    };
    if (Object.values(locations).every((location) => location === null)) continue;
    samplers.push(createSampler(gl, drawer, samplers.length, locations, spec, resources, imports));
  }
  return samplers;
}

function createSampler(
  gl: WebGL2RenderingContext,
  drawer: PassDrawer,
  unit: number,
  locations: Locations,
  spec: PassSampler,
  resources: LiveResources,
  imports: Imports,
): Sampler {
  const { source, fit } = spec;
  switch (source.kind) {
    case 'import':
      return imported(gl, drawer, unit, locations, imports.find(source.assets, source.cube));
    case 'sound': {
      const { live } = liveResource(resources, source.resource, 'sound');
      return heard(gl, drawer, unit, locations, live.texture(source.analysis, source.count));
    }
    case 'table':
      return tabled(drawer, unit, locations, liveResource(resources, source.resource, 'table').table);
    case 'room-depth':
      return roomDepth(gl, drawer, unit, locations, liveResource(resources, source.resource, 'room-depth').depth);
    case 'depth': {
      const room = resources.get(source.depth.resource);
      if (room?.kind === 'room-depth') return roomDepth(gl, drawer, unit, locations, room.depth);
      const { target, domain } = liveResource(resources, source.depth.resource, 'target');
      return layerDepth(gl, drawer, unit, locations, target, domain, source.depth.encoding);
    }
    case 'color': {
      const resource = resources.get(source.resource);
      if (resource?.kind === 'external') return external(gl, drawer, unit, locations, resource.layer, resource.domain, fit);
      const { target, domain } = liveResource(resources, source.resource, 'target');
      return color(gl, drawer, unit, locations, target, domain, spec);
    }
  }
}

function color(
  gl: WebGL2RenderingContext,
  drawer: PassDrawer,
  unit: number,
  locations: Locations,
  target: Target,
  domain: 'view' | 'image',
  { fit, unfiltered }: PassSampler,
): Sampler {
  const filter = unfiltered || target.resource.format === 'r32f' ? 'nearest' : 'linear';
  return {
    prepare: (state) => target.front(domain === 'view' ? state.viewIndex : 0),
    bind: (state) => {
      const { color: texture, widthPx, heightPx } = target.front(domain === 'view' ? state.viewIndex : 0);
      if (locations.texture) drawer.texture(unit, locations.texture, texture, filter);
      setPlacement(gl, locations, IDENTITY, widthPx, heightPx, fit, state);
    },
  };
}

function external(
  gl: WebGL2RenderingContext,
  drawer: PassDrawer,
  unit: number,
  locations: Locations,
  layer: LayerOutput,
  domain: 'view' | 'image',
  fit: PassSampler['fit'],
): Sampler {
  return {
    prepare: () => {},
    bind: (state) => {
      const view = layer.views[domain === 'view' ? state.viewIndex : 0];
      if (locations.texture) drawer.texture(unit, locations.texture, view?.texture ?? null, 'linear');
      // A layer of the view domain is aligned with the view, whatever the size of the camera image.
      const widthPx = domain === 'view' ? state.widthPx : (view?.widthPx ?? 0);
      const heightPx = domain === 'view' ? state.heightPx : (view?.heightPx ?? 0);
      setPlacement(gl, locations, view?.uvFromViewUv ?? IDENTITY, widthPx, heightPx, fit, state);
    },
  };
}

function layerDepth(
  gl: WebGL2RenderingContext,
  drawer: PassDrawer,
  unit: number,
  locations: Locations,
  target: Target,
  domain: 'view' | 'image',
  encoding: LayerDepthRef['encoding'],
): Sampler {
  return {
    prepare: (state) => {
      const buffer = target.front(domain === 'view' ? state.viewIndex : 0);
      if (encoding === 'window') buffer.readDepth();
    },
    bind: (state) => {
      const buffer = target.front(domain === 'view' ? state.viewIndex : 0);
      if (locations.texture) drawer.texture(unit, locations.texture, encoding === 'window' ? buffer.readDepth() : buffer.color, 'nearest');
      setPlacement(gl, locations, IDENTITY, buffer.widthPx, buffer.heightPx, 'none', state);
      if (locations.decode) setDecode(gl, locations.decode, encoding, state.view?.clipFromView);
    },
  };
}

function roomDepth(gl: WebGL2RenderingContext, drawer: PassDrawer, unit: number, locations: Locations, output: RoomDepthOutput): Sampler {
  return {
    prepare: () => {},
    bind: (state) => {
      const depth = output.views[state.viewIndex] ?? null;
      if (locations.texture) drawer.texture(unit, locations.texture, depth?.texture ?? null, 'nearest');
      setPlacement(gl, locations, depth?.uvFromViewUv ?? IDENTITY, depth?.widthPx ?? 1, depth?.heightPx ?? 1, 'none', state);
      if (locations.decode) setDecode(gl, locations.decode, 'meters', undefined);
      if (locations.interpolate) gl.uniform1i(locations.interpolate, depth?.interpolate ? 1 : 0);
    },
  };
}

function heard(gl: WebGL2RenderingContext, drawer: PassDrawer, unit: number, locations: Locations, image: SoundTexture): Sampler {
  return {
    prepare: image.update,
    bind: () => {
      if (locations.texture) drawer.texture(unit, locations.texture, image.texture, 'linear');
      setSize(gl, locations, image.widthPx, image.heightPx);
    },
  };
}

function tabled(drawer: PassDrawer, unit: number, locations: Locations, table: LiveTable): Sampler {
  return {
    prepare: table.update,
    bind: () => {
      if (locations.texture) drawer.texture(unit, locations.texture, table.texture, 'linear');
    },
  };
}

function imported(gl: WebGL2RenderingContext, drawer: PassDrawer, unit: number, locations: Locations, image: ImportedImage): Sampler {
  return {
    // Creates a cube map at its first use.
    prepare: () => image.texture,
    bind: () => {
      if (locations.texture && image.cube) drawer.cube(unit, locations.texture, image.texture);
      else if (locations.texture) drawer.texture(unit, locations.texture, image.texture, 'linear');
      setSize(gl, locations, image.widthPx, image.heightPx);
    },
  };
}

/** Sets the UV matrix and size of an image. An image that is fitted to the view counts as having the size of the view. */
function setPlacement(
  gl: WebGL2RenderingContext,
  locations: Locations,
  uv: Float32Array,
  widthPx: number,
  heightPx: number,
  fit: PassSampler['fit'],
  state: PlayState,
): void {
  if (locations.uv) gl.uniformMatrix3fv(locations.uv, false, fitted(uv, fit, widthPx, heightPx, state.widthPx, state.heightPx));
  if (fit === 'none') setSize(gl, locations, widthPx, heightPx);
  else setSize(gl, locations, state.widthPx, state.heightPx);
}

function setSize(gl: WebGL2RenderingContext, { size }: Locations, widthPx: number, heightPx: number): void {
  if (!size) return;
  scratchSize[0] = widthPx;
  scratchSize[1] = heightPx;
  gl.uniform2fv(size, scratchSize);
}
