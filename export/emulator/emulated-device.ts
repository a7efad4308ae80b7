import { metaQuest3, P_DEVICE, P_GAMEPAD, XRDevice, type XRDeviceConfig, type XRInputSource } from 'iwer';
import { createScreenInput, type ScreenInput } from './input/screen-input.ts';
import { DEVICE_PROFILES, type DeviceName } from './profiles.ts';

/** A device of iwer (an `XRDevice`) with the profile of a kind of device, and with a touch screen. */
export class EmulatedDevice extends XRDevice {
  readonly screenInput: ScreenInput;

  constructor(name: DeviceName, fovYRad: number, ipdM: number, modes: readonly string[]) {
    const profile = DEVICE_PROFILES[name];
    super(
      {
        ...metaQuest3,
        name: `Scrim's emulated ${name}`,
        controllerConfig: profile.controllers ? metaQuest3.controllerConfig : undefined,
        supportedSessionModes: [...modes] as XRDeviceConfig['supportedSessionModes'],
        supportedFeatures: [...profile.features] as XRDeviceConfig['supportedFeatures'],
        supportedFrameRates: [...profile.frameRates].sort((a, b) => a - b),
        internalNominalFrameRate: profile.frameRates[0] ?? 60,
        environmentBlendModes: {
          'immersive-ar': profile.blend,
          'immersive-vr': 'opaque',
        } as unknown as XRDeviceConfig['environmentBlendModes'],
        interactionMode: profile.interaction as string as XRDeviceConfig['interactionMode'],
        isSystemKeyboardSupported: false,
        userAgent: navigator.userAgent,
      },
      { fovy: fovYRad, ipd: ipdM, visibilityMask: null },
    );
    this.screenInput = createScreenInput(this[P_DEVICE].viewerSpace);
    for (const controller of Object.values(this.controllers)) if (controller) fillPlaceholderAxes(controller.inputSource);
  }

  override get inputSources(): XRInputSource[] {
    // Undefined while the constructor of the base class runs.
    return [...super.inputSources, ...(this.screenInput?.sources() ?? [])];
  }
}

/** Name of an axis that is always 0. */
const PLACEHOLDER = 'placeholder';

/** Axes that a controller does not have are 0 (WebXR Gamepads §3.3); iwer gives null. */
function fillPlaceholderAxes({ gamepad }: XRInputSource): void {
  const state = gamepad?.[P_GAMEPAD];
  if (!state) return;
  state.axesMap[PLACEHOLDER] = { x: 0, y: 0 };
  state.axesResolvers = state.axesResolvers.map((resolver) => resolver ?? { axisId: PLACEHOLDER, isY: false });
}
