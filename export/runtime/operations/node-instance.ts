import type { PlayedModule } from '../../../nodes/kit/cpu-filter.ts';
import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { Clock, NodeContext, NodeRuntime, SceneService, SessionService, WorkerService } from '../../../nodes/kit/runtime.ts';
import type { ResetCause } from '../../../nodes/kit/session.ts';
import type { NodeOperation, ProgramAsset } from '../../program/program.ts';
import type { AssetStore } from '../assets/asset-store.ts';
import { type CpuMeans, createCpuFilter } from '../cpu/run-cpu-filter.ts';
import type { StartWorker } from '../cpu/worker-source.ts';
import type { DiagnosticsBoard } from '../diagnostics-board.ts';
import type { OwnedObjects } from '../gl/owned-objects.ts';
import { createRandom } from '../random.ts';
import type { LiveResources } from '../resources/resources.ts';
import type { SceneBackend, ShadowMaps } from '../scene-backend.ts';
import type { Slots } from '../values/slots.ts';
import { createMaterialEffects, type LiveEffects } from './material-effects.ts';
import { isDraw } from './node-key.ts';
import { createNodePorts } from './node-ports.ts';
import { createOcclusion } from './occlusion.ts';
import { reportOverflows } from './pulse-overflow.ts';

/** A node of the running program. */
export interface NodeInstance {
  readonly key: string;
  readonly runtime: NodeRuntime;
  /** Shadow maps that a drawing node was created with; null for none. */
  readonly shadowMaps: ShadowMaps | null;
  /** Effects in the materials of a drawing node; null for none. */
  readonly effects: LiveEffects | null;
  /** Whether the node has used its context's `gl`, `assets` or `scenes`, whose objects are lost with the GL context. */
  readonly usesGpu: boolean;
  /** Connects the node to a recompiled program, whose operation has the same key. */
  point(operation: NodeOperation, resources: LiveResources, slots: Slots): void;
  /** Resets the node to the first frame. A repeat of the recording does not reset a node that declares `staysOnRepeat`. */
  reset(cause: ResetCause): void;
  dispose(): void;
}

/** What all nodes of a player share. */
export interface NodeHost {
  readonly gl: WebGL2RenderingContext;
  readonly modules: Readonly<Record<string, PlayedModule>>;
  readonly seed: number;
  readonly clock: Clock;
  readonly session: SessionService;
  readonly assets: AssetStore;
  readonly board: DiagnosticsBoard;
  /** Follows the GPU objects of nodes that draw themselves, in the preview. */
  readonly owned: OwnedObjects | null;
  readonly cpu: CpuMeans;
  readonly startWorker: StartWorker;
  /** Creates the backend at the first call. */
  scenes(): SceneBackend;
}

export function createNodeInstance(
  host: NodeHost,
  key: string,
  operation: NodeOperation,
  resources: LiveResources,
  slots: Slots,
  assets: readonly ProgramAsset[],
  shadowMaps: ShadowMaps | null,
): NodeInstance {
  const module = Object.hasOwn(host.modules, operation.type) ? host.modules[operation.type] : undefined;
  if (!module) throw new Error(`The page has no runtime for the node type ${operation.type}.`);
  const { node } = operation;
  const ports = createNodePorts(operation, resources, slots);
  const random = createRandom(host.seed, node);
  const occlusion = createOcclusion(operation, resources, slots);
  const effects = isDraw(operation) ? createMaterialEffects(operation, resources, slots) : null;
  const report: NodeContext<NodeDefinition>['report'] = (diagnostic) => host.board.report(node, diagnostic);
  let scenes: SceneService | null = null;
  let usesGpu = false;
  const onGpu = <T>(value: T): T => {
    usesGpu = true;
    return value;
  };
  const context = {
    node,
    inputs: ports.inputs,
    outputs: ports.outputs,
    params: ports.params,
    config: operation.config,
    assetIds: operation.assets,
    get gl() {
      return onGpu(host.gl);
    },
    clock: host.clock,
    random: random.next,
    get assets() {
      return onGpu(host.assets.serviceFor(assets, report));
    },
    // A getter, so that pages without objects need no three.js.
    get scenes() {
      scenes ??= host.scenes().serviceFor({ shadowMaps, occlusion: occlusion?.binding ?? null, effects, report });
      return onGpu(scenes);
    },
    session: host.session,
    occlusion: occlusion?.binding ?? null,
    workers: createWorkerService('worker' in module ? module.worker : undefined, operation.type, host.startWorker),
    report,
  } satisfies Record<keyof NodeContext<NodeDefinition>, unknown>;
  reportOverflows(ports.pulseOutputs, report);
  const drawsItself = isDraw(operation) && operation.ownDrawing;
  const runtime = drawsItself && host.owned ? host.owned.followNode(node, () => create(module)) : create(module);

  function create(played: PlayedModule): NodeRuntime {
    if ('create' in played) return played.create(context as unknown as NodeContext<NodeDefinition>);
    const params = ports.params as Readonly<Record<string, { readonly value: unknown }>>;
    return createCpuFilter(played, { id: node, params, config: operation.config, held: host.clock.held, report }, host.cpu);
  }

  return {
    key,
    runtime,
    shadowMaps,
    effects,
    get usesGpu() {
      return usesGpu;
    },
    point: (next, nextResources, nextSlots) => {
      ports.point(next, nextResources, nextSlots);
      occlusion?.point(next, nextSlots);
    },
    reset: (cause) => {
      if (cause === 'repeat' && runtime.staysOnRepeat) return;
      random.reset();
      runtime.reset?.();
    },
    dispose: () => {
      runtime.dispose();
      host.board.clear(node);
    },
  };
}

function createWorkerService(text: string | undefined, type: string, startWorker: StartWorker): WorkerService {
  return {
    start: (listener) => {
      if (text === undefined) throw new Error(`The node type ${type} has no worker.`);
      return startWorker(text, listener);
    },
  };
}
