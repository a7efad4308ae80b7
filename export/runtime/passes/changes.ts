import { type LayerTexture, MAY_CHANGE } from '../../../nodes/kit/runtime.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import type { BuiltinUniform, PassOperation, PassSampler, PassUniform, ResourceId } from '../../program/program.ts';
import type { PlayState } from '../play-state.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { TargetBuffer } from '../targets/target-buffer.ts';
import type { Slots } from '../values/slots.ts';
import type { ImportedImage, Imports } from './imports.ts';

/** Returns whether something differs from what it was at the last call. Compares by value and allocates nothing. */
export type Change = (state: PlayState) => boolean;

/** What the inputs of passes are read from. */
export interface PassInputs {
  readonly resources: LiveResources;
  readonly slots: Slots;
  readonly imports: Imports;
  /** The slots of curves and gradients. */
  readonly tableSlots: ReadonlyMap<ResourceId, number>;
}

/**
 * Creates the comparisons of everything that a pass reads, except the targets that other passes draw.
 *
 * @returns Null if it reads something that may change in every frame without a sign: sound, depth of the room or an earlier frame.
 */
export function changesOf(pass: PassOperation, inputs: PassInputs): Change[] | null {
  const changes: Change[] = [sizeChange()];
  for (const { source, type } of pass.uniforms) {
    if ('pulses' in source) changes.push(pulseChange(source.pulses, inputs.resources));
    else if ('slot' in source) changes.push(numbersChange(inputs.slots, source.slot, COMPONENTS[type]));
    else changes.push(BUILTIN_CHANGES[source.builtin]());
  }
  for (const { source } of pass.samplers) {
    const change = samplerChange(source, inputs);
    if (change === 'unknown') return null;
    if (change !== null) changes.push(change);
  }
  if (pass.target === 'screen') return changes;
  const { target, domain } = liveResource(inputs.resources, pass.target, 'target');
  if (target.resource.lifetime === 'persistent') return null;
  if (domain === 'image') changes.push(bufferChange(() => target.back(0)));
  return changes;
}

const COMPONENTS: Readonly<Record<PassUniform['type'], number>> = { float: 1, int: 1, bool: 1, vec2: 2, vec3: 3, vec4: 4, mat4: 16 };

function samplerChange(source: PassSampler['source'], { resources, slots, imports, tableSlots }: PassInputs): Change | 'unknown' | null {
  switch (source.kind) {
    case 'color': {
      const resource = resources.get(source.resource);
      if (resource?.kind === 'external') return layerChange(resource.layer.views[0]);
      return liveResource(resources, source.resource, 'target').target.resource.lifetime === 'persistent' ? 'unknown' : null;
    }
    case 'depth':
      return resources.get(source.depth.resource)?.kind === 'target' ? null : 'unknown';
    case 'table': {
      const slot = tableSlots.get(source.resource) ?? -1;
      return numbersChange(slots, slot, slots.size(slot));
    }
    case 'import':
      return importChange(imports.find(source.assets, source.cube));
    case 'room-depth':
    case 'sound':
      return 'unknown';
  }
}

function sizeChange(): Change {
  let lastWidthPx = -1;
  let lastHeightPx = -1;
  return ({ widthPx, heightPx }) => {
    const changed = widthPx !== lastWidthPx || heightPx !== lastHeightPx;
    lastWidthPx = widthPx;
    lastHeightPx = heightPx;
    return changed;
  };
}

function numbersChange({ numbers, offset }: Slots, slot: number, count: number): Change {
  const first = offset(slot);
  const last = new Float64Array(count).fill(Number.NaN);
  return () => {
    let changed = false;
    for (let i = 0; i < count; i++) {
      const number = numbers[first + i] ?? 0;
      if (number !== last[i]) changed = true;
      last[i] = number;
    }
    return changed;
  };
}

function pulseChange(ids: readonly ResourceId[], resources: LiveResources): Change {
  const queues = ids.map((id) => liveResource(resources, id, 'pulses').queue);
  let had: boolean | null = null;
  return () => {
    let has = false;
    for (let i = 0; i < queues.length; i++) if ((queues[i]?.count ?? 0) > 0) has = true;
    const changed = has !== had;
    had = has;
    return changed;
  };
}

/** A number in an array: JavaScript engines allocate a heap object for each fraction that is assigned to a variable. */
const fraction = (): Float64Array => Float64Array.of(Number.NaN);

const never = (): Change => () => false;

const BUILTIN_CHANGES: Readonly<Record<BuiltinUniform, () => Change>> = {
  TIME: () => {
    const lastS = fraction();
    return ({ frame: { timeS } }) => {
      const changed = timeS !== lastS[0];
      lastS[0] = timeS;
      return changed;
    };
  },
  TIMEDELTA: () => {
    const lastS = fraction();
    return ({ frame: { deltaS } }) => {
      const changed = deltaS !== lastS[0];
      lastS[0] = deltaS;
      return changed;
    };
  },
  FRAMEINDEX: () => {
    let last = -1;
    return ({ frame: { index } }) => {
      const changed = index !== last;
      last = index;
      return changed;
    };
  },
  DATE: () => () => true,
  // The size is compared for every pass.
  RENDERSIZE: never,
  PASSINDEX: never,
  SCRIM_CLIP_FROM_VIEW: () => matrixChange((view) => view.clipFromView),
  SCRIM_WORLD_FROM_VIEW: () => matrixChange((view) => view.worldFromView),
};

function matrixChange(matrixOf: (view: ViewFrame) => Float32Array): Change {
  const last = new Float32Array(16).fill(Number.NaN);
  return ({ view }) => {
    if (view === null) return false;
    const matrix = matrixOf(view);
    let changed = false;
    for (let i = 0; i < last.length; i++) if (matrix[i] !== last[i]) changed = true;
    last.set(matrix);
    return changed;
  };
}

function layerChange(view: LayerTexture | undefined): Change {
  let lastTexture: WebGLTexture | null = null;
  let lastVersion: number = MAY_CHANGE;
  return () => {
    const texture = view?.texture ?? null;
    const version = view?.version ?? 0;
    const changed = version === MAY_CHANGE || version !== lastVersion || texture !== lastTexture;
    lastTexture = texture;
    lastVersion = version;
    return changed;
  };
}

function importChange(image: ImportedImage): Change {
  let lastTexture: WebGLTexture | null | undefined;
  return () => {
    const { texture } = image;
    const changed = texture !== lastTexture;
    lastTexture = texture;
    return changed;
  };
}

/** A buffer is replaced when its size changes, and is transparent then. */
function bufferChange(buffer: () => TargetBuffer): Change {
  let last: TargetBuffer | null = null;
  return () => {
    const now = buffer();
    const changed = now !== last;
    last = now;
    return changed;
  };
}
