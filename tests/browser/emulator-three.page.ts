/// <reference types="webxr" />
import { BoxGeometry, Mesh, MeshBasicMaterial, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { XREstimatedLight } from 'three/addons/webxr/XREstimatedLight.js';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { lookAt, requestSession } from './emulator-kit.ts';

/** A page that leaves WebXR to three.js' own manager: somebody else's reading of the specifications. */
export async function withThree(options: EmulatorOptions) {
  const emulator = installEmulator({
    clock: 'manual',
    room: 'studio',
    sizePx: [320, 160],
    extra: ['camera-access', 'light-estimation'],
    ...options,
  });
  emulator.setPose(lookAt([0, 1.5, 1], [0, 1.5, 0]));
  const renderer = new WebGLRenderer({ antialias: true, alpha: true });
  renderer.xr.enabled = true;
  renderer.xr.setReferenceSpaceType('local-floor');
  const scene = new Scene();
  const box = new Mesh(new BoxGeometry(0.3, 0.3, 0.3), new MeshBasicMaterial({ color: 0xff0000 }));
  box.position.set(0, 1.5, -1);
  scene.add(box);
  const light = new XREstimatedLight(renderer);
  scene.add(light);
  const camera = new PerspectiveCamera();
  const session = await requestSession({ requiredFeatures: ['light-estimation', 'camera-access'] });
  let hasCameraTexture = false;
  renderer.setAnimationLoop((_, frame) => {
    renderer.render(scene, camera);
    const space = renderer.xr.getReferenceSpace();
    const view = space ? (frame?.getViewerPose(space)?.views[0] as (XRView & { camera: never }) | undefined) : undefined;
    hasCameraTexture = view !== undefined && Boolean(renderer.xr.getCameraTexture(view.camera));
  });
  await renderer.xr.setSession(session);
  await emulator.frameRequested();
  await emulator.stepFrame(4);
  const { rgba, widthPx, heightPx } = emulator.readLayer();
  const at = (x: number, y: number) => [...rgba.subarray((y * widthPx + x) * 4, (y * widthPx + x) * 4 + 4)];
  const views = renderer.xr.getCamera().cameras.length;
  const eyeWidth = widthPx / views;
  const result = {
    views,
    hasCameraTexture,
    // The box's middle, where each view's own projection puts it.
    middles: renderer.xr.getCamera().cameras.map(({ projectionMatrix: { elements: p }, matrixWorldInverse: { elements: v } }, i) => {
      const inViewX = v[12] ?? 0;
      const ndc = ((p[0] ?? 0) * inViewX + (p[8] ?? 0) * -2) / 2;
      return at(Math.round(i * eyeWidth + ((ndc + 1) / 2) * eyeWidth), heightPx / 2);
    }),
    corner: at(2, 2),
    harmonics: light.lightProbe.sh.coefficients.flatMap((c) => c.toArray()),
    direction: light.directionalLight.position.toArray(),
  };
  renderer.setAnimationLoop(null);
  await session.end();
  renderer.dispose();
  await emulator.uninstall();
  return result;
}
