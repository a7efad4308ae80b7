import type { DrawEffects, LinkedShader, Operation, Resource, SourceMap } from '../../program/program.ts';
import type { Schedule } from '../schedule/schedule.ts';
import { isDrawOperation, type ScheduledEffects } from '../schedule/scheduled.ts';

export interface LinkedOperations {
  readonly operations: readonly Operation[];
  readonly resources: readonly Resource[];
  readonly shaders: readonly LinkedShader[];
}

type Linkable = Pick<Schedule, 'operations' | 'resources' | 'trials'>;

/**
 * Fourth phase: moves shaders to a table without duplicates. Scheduling has linked them, because only then a shader's passes and buffers
 * are known. The source map of a shared shader names the first of its nodes; operations name their own. Test shaders of techniques are
 * included only with source maps.
 */
export function link({ operations, resources, trials }: Linkable, options: { readonly sourceMaps: boolean }): LinkedOperations {
  const shaders: LinkedShader[] = [];
  const places = new Map<string, number>();
  const placeOf = (shader: LinkedShader, node: string): number => {
    const known = places.get(shader.id);
    if (known !== undefined) return known;
    places.set(shader.id, shaders.length);
    return shaders.push(options.sourceMaps ? named(shader, node) : withoutSourceMap(shader)) - 1;
  };
  const linkedEffects = (effects: ScheduledEffects): DrawEffects => {
    const [node = ''] = effects.nodes;
    return { ...effects, trial: options.sourceMaps ? placeOf(effects.trial, node) : null };
  };
  const linked = operations.map((operation): Operation => {
    if (isDrawOperation(operation)) return { ...operation, ...(operation.effects && { effects: linkedEffects(operation.effects) }) };
    if (operation.kind !== 'pass') return operation;
    const { shader, parts: _, ...rest } = operation;
    return { ...rest, shader: placeOf(shader, operation.node) };
  });
  const placed = resources.map((resource) => {
    const trial = resource.kind === 'technique' && resource.trial !== null ? trials[resource.trial] : undefined;
    return trial ? { ...resource, trial: options.sourceMaps ? placeOf(trial.shader, trial.node) : null } : resource;
  });
  return { operations: linked, resources: placed, shaders };
}

/** Returns a shader with the node's id in its source map. A fused shader names the nodes of its files itself. */
export function named(shader: LinkedShader, node: string): LinkedShader {
  const { sourceMap, vertexMap } = shader;
  const naming = (map: SourceMap): SourceMap => ({ ...map, nodes: map.nodes.map((own) => own || node) });
  return { ...shader, ...(sourceMap && { sourceMap: naming(sourceMap) }), ...(vertexMap && { vertexMap: naming(vertexMap) }) };
}

function withoutSourceMap({ sourceMap: _, vertexMap: __, ...shader }: LinkedShader): LinkedShader {
  return shader;
}
