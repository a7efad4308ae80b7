import type { CameraImage, RoomDepth } from '../../../../nodes/kit/session.ts';
import { MAX_VIEWS } from '../../targets/target.ts';
import type { MutableCameraImage, MutableRoomDepth } from '../session-frame.ts';
import { type CpuDepth, createCpuDepth } from './cpu-depth.ts';
import { createGpuDepth, type GpuDepth } from './gpu-depth.ts';
import { createDepthReprojector, type DepthReprojector, isSameLens, isSameMatrix, type TargetView } from './reproject-depth.ts';
import type { XrBinding, XrViewWithCamera } from './webxr-types.ts';

/** Depth and camera image of each view, for the features that were granted. */
export interface ViewSources {
  /** Returns the room depth of a view, or null. `seen` is the view with its current matrices. */
  depth(frame: XRFrame, view: XRView, index: number, seen: TargetView): RoomDepth | null;
  cameraImage(view: XrViewWithCamera, index: number): CameraImage | null;
  dispose(): void;
}

export function createViewSources(
  gl: WebGL2RenderingContext,
  session: XRSession,
  binding: XrBinding | null,
  wantsDepth: boolean,
): ViewSources {
  const usage = wantsDepth ? depthUsage(session) : null;
  const format: XRDepthDataFormat = usage ? (session.depthDataFormat ?? 'luminance-alpha') : 'luminance-alpha';
  const cpu: readonly CpuDepth[] = usage === 'cpu-optimized' ? perView(() => createCpuDepth(gl)) : [];
  const gpu: readonly (GpuDepth | null)[] = usage === 'gpu-optimized' ? perView((index) => createGpuDepth(gl, index)) : [];
  const images: (MutableCameraImage | null)[] = perView(() => null);
  const reprojectors: (DepthReprojector | null)[] = perView(() => null);

  const aligned = (
    depth: MutableRoomDepth,
    info: Pick<XRDepthInformation, 'projectionMatrix'>,
    index: number,
    seen: TargetView,
  ): RoomDepth => {
    // Browsers before 2025 do not report it; their depth is aligned with the view.
    const clipFromDepth = info.projectionMatrix ?? seen.clipFromView;
    const { worldFromDepth } = depth;
    if (isSameMatrix(worldFromDepth, seen.worldFromView) && isSameLens(clipFromDepth, seen.clipFromView)) return depth;
    const reprojector = reprojectors[index] ?? createDepthReprojector(gl);
    reprojectors[index] = reprojector;
    return reprojector?.reproject(depth, { worldFromDepth, clipFromDepth }, seen) ?? depth;
  };
  return {
    depth: (frame, view, index, seen) => {
      const onCpu = cpu[index];
      if (onCpu) {
        const info = frame.getDepthInformation(view);
        return info ? aligned(onCpu.update(info, format, seen.worldFromView), info, index, seen) : null;
      }
      const onGpu = gpu[index];
      const info = onGpu ? binding?.getDepthInformation?.(view) : null;
      const decoded = onGpu && info ? onGpu.update(info, format, seen.worldFromView) : null;
      return decoded && info ? aligned(decoded, info, index, seen) : null;
    },
    cameraImage: (view, index) => {
      const { camera } = view;
      const texture = camera ? binding?.getCameraImage?.(camera) : null;
      if (!camera || !texture) return null;
      const image = images[index] ?? { texture, widthPx: 0, heightPx: 0, uvFromViewUv: UPRIGHT };
      images[index] = image;
      image.texture = texture;
      image.widthPx = camera.width;
      image.heightPx = camera.height;
      return image;
    },
    dispose: () => {
      for (const depth of [...cpu, ...gpu, ...reprojectors]) depth?.dispose();
    },
  };
}

/** UV matrix of camera images: by Raw Camera Access §5.1, an image is aligned with its view. */
const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/** Returns how depth is delivered; null if depth was not granted. Reading `depthUsage` then throws. */
function depthUsage(session: XRSession): XRDepthUsage | null {
  try {
    return session.depthUsage ?? null;
  } catch {
    return null;
  }
}

function perView<T>(create: (index: number) => T): T[] {
  return Array.from({ length: MAX_VIEWS }, (_, index) => create(index));
}
