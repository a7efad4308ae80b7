import type { AssetHandle, DerivedEnvironment, EnvironmentAsset } from '../../kit/assets.ts';
import { lampsOfExposures } from '../../kit/panorama/lamp-options.ts';
import type { PanoramaPixels } from '../../kit/panorama/pixels.ts';
import type { NodeContext, NodeRuntime, NodeWorker } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';
import { type MergeAnswer, type Merged, type MergeTask, merge } from './worker.ts';

/** More than this part of the sphere that is white in all shots is worth a message: the sun covers less. */
const NOTICED_WHITE = 2e-5;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { rotationRad, exposure } = ctx.params;
  const { environment } = ctx.outputs;
  const { file, file2, file3 } = ctx.assetIds;
  const shots: AssetHandle<EnvironmentAsset>[] = [];
  const ids = [file, file2, ctx.config.shots === '3' ? file3 : null].filter((id) => id !== null);
  for (const id of ids) shots.push(ctx.assets.environment(id));
  let state: 'loading' | 'merging' | 'done' = shots.length === 0 ? 'done' : 'loading';
  let merged: DerivedEnvironment | null = null;
  let worker: NodeWorker | null = null;
  let isDisposed = false;

  function end(): void {
    state = 'done';
    worker?.dispose();
    worker = null;
  }

  function take({ pixels, whitePart }: Merged): void {
    if (isDisposed) return;
    merged = ctx.assets.createEnvironment(pixels, storedLamps());
    if (whitePart > NOTICED_WHITE) {
      ctx.report({
        code: 'SCR068',
        severity: 'info',
        message: `${(100 * whitePart).toPrecision(2)} % of the panorama is white in all shots, so its lamps are brighter than the result.`,
        fix: 'Add a darker shot, in which the lamps are not white.',
      });
    }
    end();
  }

  /** The lamps that the program stores for these shots. They are those of all shots together. */
  function storedLamps(): EnvironmentAsset['lamps'] {
    const areAll = shots.every(({ value }) => value !== null);
    return areAll ? lampsOfExposures(shots[0]?.value?.lamps, { shots: ids, stopsApart: ctx.config.stopsApart }) : {};
  }

  function failBy(error: unknown): void {
    fail(error instanceof Error ? error.message : String(error));
  }

  function fail(reason: string): void {
    if (isDisposed) return;
    ctx.report({
      code: 'SCR068',
      severity: 'warning',
      message: `The shots are not merged, and the first one is used: ${reason.replace(/\.$/, '')}.`,
      fix: 'Choose shots of the same panorama that differ in exposure only.',
    });
    end();
  }

  /** Merges the shots that have loaded: in renders, where every frame has to be complete, at once. */
  function start(): void {
    state = 'merging';
    try {
      const all: (PanoramaPixels | Promise<PanoramaPixels>)[] = [];
      for (const { value } of shots) if (value) all.push(value.readPixels());
      if (all.some((pixels) => pixels instanceof Promise)) Promise.all(all).then(mergeAll).catch(failBy);
      else mergeAll(all as PanoramaPixels[]);
    } catch (error) {
      failBy(error);
    }
  }

  function mergeAll(pixels: readonly PanoramaPixels[]): void {
    if (isDisposed) return;
    const task: MergeTask = { shots: pixels, stopsApart: ctx.config.stopsApart };
    if (ctx.clock.held) take(merge(task));
    else mergeApart(task);
  }

  function mergeApart(task: MergeTask): void {
    worker = ctx.workers.start({
      onMessage: (data) => {
        const answer = data as MergeAnswer;
        if ('failure' in answer) fail(answer.failure);
        else take(answer.merged);
      },
      onFailure: fail,
    });
    worker.post(
      task,
      task.shots.map(({ data }) => data.buffer as ArrayBuffer),
    );
  }

  /** The merged panorama once it can be drawn; the first shot if there is none. */
  function shown(): EnvironmentAsset | null {
    if (merged) return merged.ready ? merged : null;
    return state === 'done' ? (shots.find(({ value }) => value !== null)?.value ?? null) : null;
  }

  // A file that cannot be loaded is reported by the asset service; the others are merged.
  Promise.all(shots.map(({ settled }) => settled)).then(() => {
    if (!isDisposed && state === 'loading') start();
  });

  return {
    update: () => {
      // Renders wait for all files before their first frame.
      if (ctx.clock.held && state === 'loading') start();
      environment.asset = shown();
      environment.intensity = 2 ** exposure.value;
      environment.rotationRad = rotationRad.value;
    },
    dispose: () => {
      isDisposed = true;
      worker?.dispose();
      merged?.dispose();
      for (const one of shots) one.release();
    },
  };
}
