import type { ImageAsset } from '../../kit/assets.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { RoomDepth, ViewFrame } from '../../kit/session.ts';
import type { definition } from './definition.ts';
import { createDepthDrawing, type DepthDrawing } from './drawing.ts';
import { createImageDepth, type ImageDepth } from './image-depth.ts';
import { createDepthRefiner, type DepthRefiner } from './refine-depth.ts';
import { createRegistrationCheck, type RegistrationCheck } from './registration-check.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { views } = ctx.outputs.depth;
  const rated = ctx.outputs.confidence?.views ?? null;
  const { params, config } = ctx;
  const id = config.source === 'picture' ? ctx.assetIds.picture : null;
  const picture = id === null ? null : ctx.assets.image(id);
  /** The GPU resources of the node, created with the first depth, because most devices have none. */
  let gpu: Gpu | null = null;
  let check: RegistrationCheck | null = null;
  let jumps = 0;
  let version = 0;
  let lastVersion: number | undefined;
  let hadDepth = false;
  const forget = (): void => {
    for (const refiner of gpu?.refiners ?? []) refiner.forget();
  };
  const wishes = { smoothingS: 0, deltaS: 0, fillHoles: true, confidence: rated !== null, isSensor: config.source === 'device' };

  const reportMismatch = (): void => {
    const message = 'The camera image has its edges elsewhere than the room depth, so the edge-aware filter ignores it.';
    const fix = 'Choose “Linear” to do without the camera, or record color and depth from the same viewpoint.';
    ctx.report({ code: 'SCR055', severity: 'warning', message, fix });
  };
  const measured = (view: ViewFrame, index: number): RoomDepth | null => {
    if (config.source === 'device') return view.depth;
    const image = picture?.value ?? null;
    return image && depthOfImage(image, view, index);
  };
  const depthOfImage = (image: ImageAsset, view: ViewFrame, index: number): RoomDepth | null => {
    gpu ??= createGpu(ctx);
    if (!gpu.drawing) return null;
    gpu.imageDepth ??= createImageDepth(ctx.gl, gpu.drawing, views.length, config.shades);
    return gpu.imageDepth.read(image, view, index, params.nearM.value, params.farM.value);
  };
  return {
    get version() {
      return version;
    },
    update: (frame) => {
      const hasDepth = config.source === 'device' ? !!frame.views[0]?.depth : !!picture?.value;
      // A smoothed depth goes on approaching what is measured.
      const isSteady = config.source === 'device' && frame.version !== undefined && params.smoothingS.value <= 0;
      const isSame = isSteady && frame.version === lastVersion;
      if (hasDepth !== hadDepth || (hasDepth && !isSame)) version++;
      hadDepth = hasDepth;
      lastVersion = frame.version;
      // What was seen before stands elsewhere now.
      if (frame.jumps !== jumps) forget();
      jumps = frame.jumps;
      wishes.smoothingS = params.smoothingS.value;
      wishes.deltaS = frame.deltaS;
      // Transparent areas of an image are unknown on purpose, so they are not filled.
      wishes.fillHoles = config.source === 'device' && params.fillHoles.value;
      const isPlain = config.filter === 'nearest' && !wishes.fillHoles && wishes.smoothingS <= 0 && !rated;
      for (let i = 0; i < views.length; i++) {
        const view = i < frame.viewCount ? frame.views[i] : null;
        const depth = view ? measured(view, i) : null;
        if (!view || !depth || isPlain) {
          views[i] = depth;
          if (!depth) gpu?.refiners[i]?.forget();
          show(rated?.[i], null, null, version);
          continue;
        }
        gpu ??= createGpu(ctx);
        const refiner = gpu.refiners[i];
        views[i] = refiner?.refine(depth, view, wishes) ?? depth;
        show(rated?.[i], depth, refiner?.confidence ?? null, version);
        if (i === 0 && refiner?.registration) {
          check ??= createRegistrationCheck(ctx.gl, reportMismatch);
          check.look(refiner.registration);
        }
      }
    },
    reset: forget,
    dispose: () => {
      for (const refiner of gpu?.refiners ?? []) refiner.dispose();
      gpu?.imageDepth?.dispose();
      check?.dispose();
      gpu?.drawing?.dispose();
      picture?.release();
    },
  };
}

/** Outputs the confidence of one view; `depth` is the depth that it rates. */
function show(layer: ConfidenceLayer | undefined, depth: RoomDepth | null, confidence: WebGLTexture | null, version: number): void {
  if (!layer) return;
  layer.texture = confidence;
  layer.version = version;
  layer.widthPx = depth?.widthPx ?? 1;
  layer.heightPx = depth?.heightPx ?? 1;
  if (depth) layer.uvFromViewUv.set(depth.uvFromViewUv);
}

type ConfidenceLayer = NonNullable<NodeContext<typeof definition>['outputs']['confidence']>['views'][number];

interface Gpu {
  readonly drawing: DepthDrawing | null;
  readonly refiners: readonly DepthRefiner[];
  imageDepth: ImageDepth | null;
}

function createGpu(ctx: NodeContext<typeof definition>): Gpu {
  const drawing = createDepthDrawing(ctx.gl);
  const refiners = ctx.outputs.depth.views.map(() => createDepthRefiner(ctx.gl, drawing, ctx.config.filter));
  return { drawing, refiners, imageDepth: null };
}
