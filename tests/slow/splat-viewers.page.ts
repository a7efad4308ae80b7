import { PlyLoader, SceneRevealMode, Viewer } from '@mkkellogg/gaussian-splats-3d';
import { WebGLRenderer } from 'three';
import { lookingAt, readPixels } from '../browser/scenes-kit.ts';

export interface ViewerOptions {
  /** A PLY file. */
  readonly bytes: Uint8Array;
  readonly eye: readonly [number, number, number];
  readonly target: readonly [number, number, number];
  readonly widthPx: number;
  readonly heightPx: number;
}

/** What GaussianSplats3D draws of a file: premultiplied RGBA, rows from the bottom. It reads harmonics up to degree 2. */
export async function drawByGaussianSplats3d({ bytes, eye, target, widthPx, heightPx }: ViewerOptions): Promise<Uint8Array> {
  const renderer = new WebGLRenderer({ alpha: true, antialias: false, preserveDrawingBuffer: true });
  renderer.setPixelRatio(1);
  renderer.setSize(widthPx, heightPx);
  renderer.setClearColor(0, 0);
  // The viewer takes the size of the view from this element.
  const rootElement = document.body.appendChild(document.createElement('div'));
  rootElement.style.cssText = `width: ${widthPx}px; height: ${heightPx}px`;
  const camera = lookingAt(eye, target, widthPx / heightPx);
  const viewer = new Viewer({
    renderer,
    camera,
    rootElement,
    selfDrivenMode: false,
    useBuiltInControls: false,
    ignoreDevicePixelRatio: true,
    // The page is not isolated from other origins, so it has no shared memory.
    sharedMemoryForWorkers: false,
    // By default depths are rounded to whole thousandths.
    integerBasedSort: false,
    splatSortDistanceMapPrecision: 20,
    sphericalHarmonicsDegree: 2,
    sceneRevealMode: SceneRevealMode.Instant,
  });
  await viewer.addSplatBuffers([await PlyLoader.loadFromFileData(Uint8Array.from(bytes).buffer, 1, 0, false, 2)], [{}], true, false);
  viewer.update();
  viewer.render();
  const gl = renderer.getContext() as WebGL2RenderingContext;
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const pixels = readPixels(gl, widthPx, heightPx);
  await viewer.dispose();
  rootElement.remove();
  renderer.forceContextLoss();
  return pixels;
}
