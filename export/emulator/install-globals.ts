import { P_DEVICE, XRAnchor, XRAnchorSet, type XRDevice, XRMesh, XRMeshSet, XRPlane, XRPlaneSet } from 'iwer';
import { EmulatedCpuDepthInformation, EmulatedDepthInformation, EmulatedWebGlDepthInformation } from './depth/depth-information.ts';
import { EmulatedRay } from './hit-test/emulated-ray.ts';
import {
  EmulatedHitTestResult,
  EmulatedHitTestSource,
  EmulatedTransientHitTestResult,
  EmulatedTransientHitTestSource,
} from './hit-test/hit-test-source.ts';
import { EmulatedCompositionLayer, EmulatedCylinderLayer, EmulatedProjectionLayer, EmulatedQuadLayer } from './layers/composition-layer.ts';
import { EmulatedSubImage } from './layers/sub-image.ts';
import { EmulatedLightEstimate, EmulatedLightProbe } from './light/light-probe.ts';
import { EmulatedBoundedReferenceSpace } from './session/bounded-space.ts';
import { EmulatedBinding } from './session/emulated-binding.ts';
import { EmulatedFrame } from './session/emulated-frame.ts';
import { EmulatedLayer } from './session/emulated-layer.ts';
import { EmulatedReferenceSpace } from './session/emulated-reference-space.ts';
import { EmulatedSession } from './session/emulated-session.ts';
import { EmulatedCamera, EmulatedView } from './session/emulated-view.ts';
import { EmulatedRenderState } from './session/render-state.ts';
import { EmulatedRigidTransform } from './session/rigid-transform.ts';
import { makeXrCompatible, watchContexts } from './xr-compatible.ts';

/** Interfaces that iwer does not implement, or that are implemented here instead. */
const GLOBALS: Readonly<Record<string, unknown>> = {
  XRSession: EmulatedSession,
  XRFrame: EmulatedFrame,
  XRView: EmulatedView,
  XRReferenceSpace: EmulatedReferenceSpace,
  XRBoundedReferenceSpace: EmulatedBoundedReferenceSpace,
  XRRigidTransform: EmulatedRigidTransform,
  XRRenderState: EmulatedRenderState,
  XRWebGLLayer: EmulatedLayer,
  XRWebGLBinding: EmulatedBinding,
  XRCompositionLayer: EmulatedCompositionLayer,
  XRProjectionLayer: EmulatedProjectionLayer,
  XRQuadLayer: EmulatedQuadLayer,
  XRCylinderLayer: EmulatedCylinderLayer,
  XRSubImage: EmulatedSubImage,
  XRWebGLSubImage: EmulatedSubImage,
  XRDepthInformation: EmulatedDepthInformation,
  XRCPUDepthInformation: EmulatedCpuDepthInformation,
  XRWebGLDepthInformation: EmulatedWebGlDepthInformation,
  XRLightProbe: EmulatedLightProbe,
  XRLightEstimate: EmulatedLightEstimate,
  XRCamera: EmulatedCamera,
  XRRay: EmulatedRay,
  XRHitTestSource: EmulatedHitTestSource,
  XRHitTestResult: EmulatedHitTestResult,
  XRTransientInputHitTestSource: EmulatedTransientHitTestSource,
  XRTransientInputHitTestResult: EmulatedTransientHitTestResult,
  XRAnchor,
  XRAnchorSet,
  XRPlane,
  XRPlaneSet,
  XRMesh,
  XRMeshSet,
};

/** Installs the device's globals in the page. Returns a function that restores the previous ones. */
export function installGlobals(device: XRDevice): () => void {
  // Chromium has a `navigator.xr` even without a device.
  device.installRuntime({ forceInstall: true });
  const state = device[P_DEVICE];
  const globals = globalThis as unknown as Record<string, unknown>;
  for (const [name, value] of Object.entries(GLOBALS)) {
    if (!state.previousGlobals?.has(name)) state.previousGlobals?.set(name, { existed: name in globals, value: globals[name] });
    globals[name] = value;
  }
  for (const prototype of state.previousMakeXRCompatible?.keys() ?? []) {
    Object.defineProperty(prototype, 'makeXRCompatible', { configurable: true, value: makeXrCompatible });
  }
  // iwer overrides the user agent with that of a headset, which would make pages behave differently from a phone.
  if (state.previousUserAgentDescriptor === null) Reflect.deleteProperty(navigator, 'userAgent');
  const unwatch = watchContexts();
  return () => {
    unwatch();
    device.uninstallRuntime();
  };
}
