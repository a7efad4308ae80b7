import type { Capability } from '../../../nodes/kit/definition.ts';
import type { Tier } from '../needs.ts';

/** Kinds of devices on which visitors open a page. */
export type DeviceKind = 'android-phone' | 'quest' | 'android-xr' | 'vision-pro' | 'see-through' | 'iphone' | 'laptop';

/** Whether a kind of device has a feature, and who says so. */
export interface DeviceFact {
  /** `unknown`: no public source tells. */
  readonly has: 'yes' | 'no' | 'unknown';
  readonly source: string;
  /** When the source was read or, of a data set, published: YYYY-MM or YYYY-MM-DD. */
  readonly date: string;
}

/** What Scrim knows of one kind of device, with its browser. */
export interface DeviceFacts {
  readonly kind: DeviceKind;
  readonly title: string;
  /** Kinds of sessions that the browser can open, best first. */
  readonly sessions: readonly Tier['id'][];
  readonly sessionFact: DeviceFact;
  /** Kind of display. On an additive display, black is transparent. */
  readonly display: 'screen' | 'video see-through' | 'additive';
  readonly features: Readonly<Record<Capability | 'dom-overlay', DeviceFact>>;
}

const fact = (has: DeviceFact['has'], source: string, date: string): DeviceFact => ({ has, source, date });
/** Creates a fact from MDN’s table, which says only that an interface exists, not that a session grants the feature. */
const mdn = (has: DeviceFact['has'], detail: string) => fact(has, `MDN browser-compat-data 8.1.9: ${detail}`, '2026-11-12');
const untold = (date: string) => fact('unknown', 'No public source found', date);

const CHROME_CAMERA = mdn('yes', 'XRCamera, Chrome Android 107');
const NO_SESSION = fact('no', 'The browser opens no AR session', '2026-11-12');
const ORDINARY_PAGE = fact('yes', 'The page itself: no immersive session', '2026-11-12');
const GET_USER_MEDIA = mdn('yes', 'MediaDevices.getUserMedia');
const VISION_PRO_AR = fact('no', 'google/xrblocks#462: immersive-vr only', '2026-11');

/** One row per kind of device. Corrections belong here, with their source. */
export const DEVICE_FACTS: readonly DeviceFacts[] = [
  {
    kind: 'android-phone',
    title: 'Android phone (Chrome)',
    sessions: ['ar-camera', 'ar', 'camera', 'orbit'],
    sessionFact: mdn('yes', 'immersive-ar, Chrome Android 81'),
    display: 'screen',
    features: {
      'camera-image': CHROME_CAMERA,
      depth: mdn('yes', 'XRDepthInformation, Chrome Android 90'),
      'light-estimation': mdn('yes', 'XRLightEstimate, Chrome Android 90'),
      'hit-test': mdn('yes', 'XRHitTestSource, Chrome Android 81'),
      anchors: mdn('yes', 'XRAnchor, Chrome Android 85'),
      planes: mdn('yes', 'XRPlane, Chrome Android 147'),
      meshes: mdn('no', 'XRMesh'),
      hands: fact('no', 'ARCore on phones tracks no hands; XRHand exists since Chrome Android 131', '2026-11-12'),
      microphone: GET_USER_MEDIA,
      motion: mdn('yes', 'DeviceMotionEvent, Chrome Android 31'),
      location: mdn('yes', 'Geolocation, Chrome Android 18'),
      'dom-overlay': mdn('yes', 'XRSession.domOverlayState, Chrome Android 83'),
    },
  },
  {
    kind: 'quest',
    title: 'Meta Quest (Browser)',
    sessions: ['ar', 'authored-vr', 'orbit'],
    sessionFact: mdn('yes', 'immersive-ar, Quest Browser'),
    display: 'video see-through',
    features: {
      'camera-image': fact('no', 'immersive-web/raw-camera-access#21: not in XR frames', '2026-11'),
      depth: mdn('yes', 'XRDepthInformation on the GPU, Quest Browser'),
      'light-estimation': fact('no', 'immersive-web/lighting-estimation#59', '2026-11-23'),
      'hit-test': mdn('yes', 'XRHitTestSource, Quest Browser'),
      anchors: mdn('yes', 'XRAnchor, Quest Browser'),
      planes: mdn('yes', 'XRPlane, Quest Browser 31.2'),
      meshes: mdn('yes', 'XRMesh, Quest Browser 31.2'),
      hands: mdn('yes', 'XRHand, Quest Browser 15.1'),
      microphone: GET_USER_MEDIA,
      motion: untold('2026-11-23'),
      location: untold('2026-11-23'),
      'dom-overlay': fact('no', 'meta-quest/ProjectFlowerbed#10', '2026-11-23'),
    },
  },
  {
    kind: 'android-xr',
    title: 'Android XR headset (Chrome)',
    sessions: ['ar', 'authored-vr', 'orbit'],
    sessionFact: fact('yes', 'developer.android.com/develop/xr/develop-with-webxr', '2026-11'),
    display: 'video see-through',
    features: {
      'camera-image': fact('no', 'google/xrblocks#419: getUserMedia, not in XR frames', '2026-11'),
      depth: fact('yes', 'developer.android.com/develop/xr/develop-with-webxr', '2026-11'),
      'light-estimation': fact('yes', 'developer.android.com/develop/xr/develop-with-webxr', '2026-11'),
      'hit-test': fact('yes', 'developer.android.com/develop/xr/develop-with-webxr', '2026-11'),
      anchors: fact('yes', 'google/xrblocks#523', '2026-11'),
      planes: mdn('yes', 'XRPlane, Chrome Android 147'),
      meshes: fact('no', 'google/xrblocks#307: behind a flag', '2026-11-23'),
      hands: mdn('yes', 'XRHand, Chrome Android 131'),
      microphone: GET_USER_MEDIA,
      motion: untold('2026-11-23'),
      location: untold('2026-11-23'),
      'dom-overlay': untold('2026-11-23'),
    },
  },
  {
    kind: 'vision-pro',
    title: 'Apple Vision Pro (Safari)',
    sessions: ['authored-vr', 'orbit'],
    sessionFact: VISION_PRO_AR,
    display: 'video see-through',
    features: {
      'camera-image': VISION_PRO_AR,
      depth: VISION_PRO_AR,
      'light-estimation': VISION_PRO_AR,
      'hit-test': VISION_PRO_AR,
      anchors: VISION_PRO_AR,
      planes: VISION_PRO_AR,
      meshes: VISION_PRO_AR,
      hands: fact('yes', 'webkit.org/blog/15162, if the page asks', '2026-11'),
      microphone: GET_USER_MEDIA,
      motion: untold('2026-11-23'),
      location: untold('2026-11-23'),
      'dom-overlay': VISION_PRO_AR,
    },
  },
  {
    kind: 'see-through',
    title: 'HoloLens 2, Magic Leap 2',
    sessions: ['ar', 'authored-vr', 'orbit'],
    sessionFact: fact('yes', 'doc.babylonjs.com, WebXR augmented reality features', '2026-11-23'),
    display: 'additive',
    features: {
      'camera-image': untold('2026-11-23'),
      depth: untold('2026-11-23'),
      'light-estimation': untold('2026-11-23'),
      'hit-test': untold('2026-11-23'),
      anchors: untold('2026-11-23'),
      planes: untold('2026-11-23'),
      meshes: untold('2026-11-23'),
      hands: mdn('unknown', 'XRHand, Edge 93 to 110 on HoloLens 2'),
      microphone: GET_USER_MEDIA,
      motion: untold('2026-11-23'),
      location: untold('2026-11-23'),
      'dom-overlay': untold('2026-11-23'),
    },
  },
  {
    kind: 'iphone',
    title: 'iPhone (Safari)',
    sessions: ['camera', 'orbit'],
    sessionFact: mdn('no', 'XRSystem is missing in Safari on iOS up to 27.1'),
    display: 'screen',
    features: {
      'camera-image': GET_USER_MEDIA,
      depth: NO_SESSION,
      'light-estimation': NO_SESSION,
      'hit-test': NO_SESSION,
      anchors: NO_SESSION,
      planes: NO_SESSION,
      meshes: NO_SESSION,
      hands: NO_SESSION,
      microphone: GET_USER_MEDIA,
      motion: mdn('yes', 'DeviceMotionEvent.requestPermission, Safari on iOS 14.5'),
      location: mdn('yes', 'Geolocation, Safari on iOS'),
      'dom-overlay': ORDINARY_PAGE,
    },
  },
  {
    kind: 'laptop',
    title: 'Laptop',
    sessions: ['camera', 'orbit'],
    sessionFact: fact('no', 'The browser opens no AR session without a headset', '2026-11-12'),
    display: 'screen',
    features: {
      'camera-image': GET_USER_MEDIA,
      depth: NO_SESSION,
      'light-estimation': NO_SESSION,
      'hit-test': NO_SESSION,
      anchors: NO_SESSION,
      planes: NO_SESSION,
      meshes: NO_SESSION,
      hands: NO_SESSION,
      microphone: GET_USER_MEDIA,
      motion: fact('no', 'Laptops have no motion sensor that browsers give to pages', '2026-11-23'),
      location: mdn('yes', 'Geolocation, by wireless networks'),
      'dom-overlay': ORDINARY_PAGE,
    },
  },
];
