import { installEmulator } from '../../../export/emulator/install-emulator.ts';

/** A part of WebXR that a page requests in each frame. */
export type Asked = 'nothing' | 'hit test' | 'depth, CPU' | 'depth, GPU' | 'light' | 'planes' | 'camera picture' | 'all';

const FEATURES: Readonly<Record<Exclude<Asked, 'nothing' | 'all'>, string>> = {
  'hit test': 'hit-test',
  'depth, CPU': 'depth-sensing',
  'depth, GPU': 'depth-sensing',
  light: 'light-estimation',
  planes: 'plane-detection',
  'camera picture': 'camera-access',
};

/** Parts of the WebXR modules that @types/webxr lacks. */
type FullSession = XRSession & { requestLightProbe(): Promise<object> };
type FullFrame = XRFrame & { getLightEstimate(probe: object): object | null };
type FullView = XRView & { readonly camera: object | null };
type FullBinding = XRWebGLBinding & { getCameraImage(camera: object): WebGLTexture };

/**
 * Starts an AR session on the emulated phone in the room `studio`. The page draws nothing and requests one part of WebXR, or all, in each
 * frame.
 */
export async function open(asked: Asked, widthPx: number, heightPx: number): Promise<void> {
  const emulator = installEmulator({ device: 'phone', room: 'studio', clock: 'manual', sizePx: [widthPx, heightPx], display: false });
  emulator.setPose({ position: [0, 1.5, 1] });
  const gl = document.createElement('canvas').getContext('webgl2', { xrCompatible: true });
  if (!gl || !navigator.xr) throw new Error('The browser has no WebGL 2.');
  const wanted = (kind: keyof typeof FEATURES): boolean => asked === kind || (asked === 'all' && kind !== 'depth, GPU');
  const kinds = (Object.keys(FEATURES) as (keyof typeof FEATURES)[]).filter(wanted);
  const session = (await navigator.xr.requestSession('immersive-ar', {
    requiredFeatures: ['local-floor', ...new Set(kinds.map((kind) => FEATURES[kind]))],
    depthSensing: {
      usagePreference: [asked === 'depth, GPU' ? 'gpu-optimized' : 'cpu-optimized'],
      dataFormatPreference: ['luminance-alpha'],
    },
  })) as FullSession;
  await session.updateRenderState({ baseLayer: new XRWebGLLayer(session, gl) });
  const binding = new XRWebGLBinding(session, gl) as FullBinding;
  const space = await session.requestReferenceSpace('local-floor');
  const viewer = await session.requestReferenceSpace('viewer');
  const source = wanted('hit test') ? await session.requestHitTestSource?.({ space: viewer }) : undefined;
  const probe = wanted('light') ? await session.requestLightProbe() : null;
  const tick = (_time: number, frame: XRFrame): void => {
    session.requestAnimationFrame(tick);
    const view = frame.getViewerPose(space)?.views[0];
    if (!view) return;
    if (source) heard += frame.getHitTestResults(source).length;
    if (wanted('depth, CPU')) heard += frame.getDepthInformation?.(view)?.data.byteLength ?? 0;
    if (wanted('depth, GPU')) heard += binding.getDepthInformation(view) ? 1 : 0;
    if (probe) heard += (frame as FullFrame).getLightEstimate(probe) ? 1 : 0;
    if (wanted('planes')) heard += frame.detectedPlanes?.size ?? 0;
    const { camera } = view as FullView;
    if (wanted('camera picture') && camera) heard += binding.getCameraImage(camera) ? 1 : 0;
  };
  session.requestAnimationFrame(tick);
  const pixel = new Uint8Array(4);
  step = async () => {
    await emulator.stepFrame();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  };
}

/** Milliseconds per frame over `count` frames. */
export async function frameMs(count: number): Promise<number> {
  if (!step) throw new Error('Nothing is open.');
  const before = heard;
  const startMs = performance.now();
  for (let i = 0; i < count; i++) await step();
  const ms = (performance.now() - startMs) / count;
  answers = (heard - before) / count;
  return ms;
}

/** Mean number of answers of the device per frame, in the last call of `frameMs`. */
export function answered(): number {
  return answers;
}

let step: (() => Promise<void>) | null = null;
let heard = 0;
let answers = 0;
