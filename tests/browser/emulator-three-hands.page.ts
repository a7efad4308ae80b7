/// <reference types="webxr" />
import { type InstancedMesh, Matrix4, type Object3D, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { XRControllerModelFactory } from 'three/addons/webxr/XRControllerModelFactory.js';
import { XRHandModelFactory } from 'three/addons/webxr/XRHandModelFactory.js';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import { HAND_JOINTS } from '../../nodes/kit/hand-joints.ts';
import { requestSession } from './emulator-kit.ts';

/** A registry of profiles with one controller, in the form that the factory loads: a trigger that turns by half a radian. */
const FILES: Readonly<Record<string, unknown>> = {
  'profilesList.json': { 'meta-quest-touch-plus': { path: 'plus/profile.json' } },
  'plus/profile.json': {
    profileId: 'meta-quest-touch-plus',
    fallbackProfileIds: [],
    layouts: Object.fromEntries(
      ['left', 'right'].map((side) => [
        side,
        {
          selectComponentId: 'xr-standard-trigger',
          components: {
            'xr-standard-trigger': {
              type: 'trigger',
              gamepadIndices: { button: 0 },
              rootNodeName: 'xr_standard_trigger',
              visualResponses: {
                pressed: {
                  componentProperty: 'button',
                  states: ['default', 'touched', 'pressed'],
                  valueNodeProperty: 'transform',
                  valueNodeName: 'value',
                  minNodeName: 'min',
                  maxNodeName: 'max',
                },
              },
            },
          },
          gamepadMapping: 'xr-standard',
          rootNodeName: 'root',
          assetPath: 'model.gltf',
        },
      ]),
    ),
  },
  'plus/model.gltf': {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [
      { name: 'root', children: [1, 2, 3] },
      { name: 'value' },
      { name: 'min' },
      { name: 'max', rotation: [Math.sin(0.25), 0, 0, Math.cos(0.25)] },
    ],
  },
};

/** Serves the registry in place of the network. */
function serveProfiles(): () => void {
  const { fetch } = window;
  window.fetch = async (input, init) => {
    const url = typeof input === 'string' ? input : input instanceof URL ? input.href : input.url;
    const path = url.split('/profiles/')[1];
    return path !== undefined && path in FILES ? new Response(JSON.stringify(FILES[path])) : fetch(input, init);
  };
  return () => {
    window.fetch = fetch;
  };
}

/** A page whose hands and controllers are those of three.js: somebody else's reading of the specifications. */
export async function models() {
  const stop = serveProfiles();
  const emulator = installEmulator({ device: 'headset', clock: 'manual', display: false, sizePx: [64, 32] });
  const renderer = new WebGLRenderer();
  renderer.xr.enabled = true;
  renderer.xr.setReferenceSpaceType('local-floor');
  const scene = new Scene();
  const controllers = new XRControllerModelFactory();
  controllers.setPath(`${location.origin}/profiles`);
  const hands = new XRHandModelFactory();
  const grips = [0, 1].map((i) => {
    const grip = renderer.xr.getControllerGrip(i);
    scene.add(grip.add(controllers.createControllerModel(grip)));
    return grip;
  });
  const bare = [0, 1].map((i) => {
    const hand = renderer.xr.getHand(i);
    scene.add(hand.add(hands.createHandModel(hand, 'spheres')));
    return hand;
  });
  const session = await requestSession({ requiredFeatures: ['hand-tracking'] });
  const camera = new PerspectiveCamera();
  renderer.setAnimationLoop(() => renderer.render(scene, camera));
  await renderer.xr.setSession(session);
  await emulator.frameRequested();
  const { left, right } = emulator.device.controllers;
  left?.position.set(-0.3, 1.2, -0.5);
  right?.position.set(0.3, 1.2, -0.5);
  right?.updateButtonValue('trigger', 1);
  const step = async (count: number) => {
    await emulator.stepFrame(count);
    // Files of the registry arrive between frames.
    await new Promise((resolve) => setTimeout(resolve, 50));
  };
  await step(2);
  while (grips.some((grip) => !grip.getObjectByName('value'))) await step(1);
  await step(2);
  const turned = grips.map((grip) => grip.getObjectByName('value')?.rotation.x ?? -1);
  const gripsVisible = grips.map(({ visible }) => visible);

  emulator.device.primaryInputMode = 'hand';
  emulator.device.hands.left?.position.set(-0.3, 1.2, -0.5);
  await step(3);
  const jointsOf = (hand: Object3D) => {
    const found: InstancedMesh[] = [];
    hand.traverse((object) => {
      if ('isInstancedMesh' in object) found.push(object as InstancedMesh);
    });
    const [mesh] = found;
    if (!mesh) return null;
    const matrix = new Matrix4();
    return Array.from({ length: mesh.count }, (_, i) => {
      mesh.getMatrixAt(i, matrix);
      return new Vector3().setFromMatrixPosition(matrix).toArray();
    });
  };
  // What the device itself says, joint by joint.
  const told = await new Promise<number[][]>((resolve) => {
    const space = renderer.xr.getReferenceSpace();
    session.requestAnimationFrame((_time, frame) => {
      const { hand } = [...session.inputSources].find(({ handedness }) => handedness === 'left') ?? {};
      resolve(
        HAND_JOINTS.map((joint) => {
          const jointSpace = hand?.get(joint);
          const pose = jointSpace && space && frame.getJointPose?.(jointSpace, space);
          return pose ? [pose.transform.position.x, pose.transform.position.y, pose.transform.position.z] : [];
        }),
      );
    });
    void emulator.stepFrame(1);
  });
  const drawn = bare.map(jointsOf);
  const handsVisible = bare.map(({ visible }) => visible);
  const error = renderer.getContext().getError();
  renderer.setAnimationLoop(null);
  await session.end();
  renderer.dispose();
  await emulator.uninstall();
  stop();
  return { turned, gripsVisible, handsVisible, told, drawn, error };
}
