import { expect } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { holder } from './clause-tests.ts';

// The emulated device against WebXR Device API and Anchors, and against what the official samples do. Sections are those of
// the editor's drafts at immersive-web.github.io.

const holds = holder(useModule('tests/browser/webxr-device.page.ts'));

holds('Anchors §4, of hit test results', 'anchors', [
  ['a result of a frame that is over can be anchored, as samples do on select', 'at', [0, 0, 1]],
  ['the anchor is among the tracked ones', 'tracked', true],
  ['without the feature there is none, NotSupportedError', 'without', 'NotSupportedError'],
  ['of an ended session there is none, InvalidStateError', 'ended', 'InvalidStateError'],
]);

holds('Device API §11.6, contexts', 'contexts', [
  [
    'attributes say whether a context is XR compatible: WebGL 2, WebGL 1, before and after makeXRCompatible',
    'attributes',
    [true, true, false, true],
  ],
  ['makeXRCompatible of a lost context rejects with InvalidStateError', 'lost', 'InvalidStateError'],
  ['a lost context has no attributes', 'lostAttributes', null],
]);

const FLOOR = [
  [-4, 0, -4, 1],
  [4, 0, -4, 1],
  [4, 0, 4, 1],
  [-4, 0, 4, 1],
];

holds('Device API §9 and §10, spaces and transforms', 'spaces', [
  ['a bounded-floor space is an XRBoundedReferenceSpace', 'isBounded', true],
  ['§9.3: its bounds are the room’s floor, clockwise from above, on it, w = 1', 'corners', FLOOR],
  ['§9.3: those of an offset space are in that space', 'shifted', FLOOR.map(([x = 0, y, z = 0, w]) => [x - 1, y, z - 2, w])],
  ['§9.3: it begins on the floor', 'floor', 0],
  ['a device without bounds does not grant it', 'phone', 'NotSupportedError'],
  ['types that there are not reject with TypeError', 'unknown', 'TypeError'],
  ['a type that was not granted rejects with NotSupportedError', 'notGranted', 'NotSupportedError'],
  ['modes that there are not reject with TypeError', 'unknownMode', 'TypeError'],
  ['asking for support of such a mode does, too', 'unknownSupport', 'TypeError'],
  [
    '§10.1: w of a position is 1, all is finite, a quaternion is not 0',
    'transforms',
    ['TypeError', 'TypeError', 'InvalidStateError', null],
  ],
]);

holds('Device API §7.2 and §11.4, viewports', 'viewports', [
  ['a view’s viewport is the same object each time', 'same', true],
  ['after the frame, getViewport throws InvalidStateError', 'late', 'InvalidStateError'],
  [
    'a smaller viewport holds for the view that asked, from the first question of the frame on',
    'scaled',
    [
      [0, 0, 16, 32],
      [32, 0, 32, 64],
      [0, 0, 16, 32],
    ],
  ],
  ['what is drawn there is shown over the whole of its view', 'shown', [32 * 64, 0]],
  ['it holds until another is asked for; null, 0 and less ask for none', 'after', [0, 0, 8, 16]],
  ['§11.3: a layer has no context', 'context', false],
]);

holds('Device API §4.2, frame rates', 'frameRates', [
  ['a headset has several, ascending', 'rates', [72, 80, 90, 120]],
  ['frameratechange comes once, when the rate is another one', 'told', ['XRSessionEvent 72']],
  ['a rate that it has not rejects with TypeError', 'unknown', 'TypeError'],
  ['of an ended session it rejects with InvalidStateError', 'ended', 'InvalidStateError'],
]);

const LENS_1 = 1 / Math.tan(0.5);

holds('Device API §4, a session on the page', 'inline', [
  ['it is visible, opaque, on a screen, without input', 'ways', ['visible', 'opaque', 'screen-space', 0]],
  ['it draws into the canvas', 'framebuffer', null],
  [
    'it has one view over the canvas, from where the viewer is, with the field of view that the page sets',
    'frames',
    [
      { frame: 0, eyes: ['none'], height: 1.6, viewport: [0, 0, 40, 20], lens: [0.5, 1], pixel: [0, 255, 0, 255] },
      {
        frame: 1,
        eyes: ['none'],
        height: 1.6,
        viewport: [0, 0, 40, 20],
        lens: [expect.closeTo(LENS_1 / 2, 3), expect.closeTo(LENS_1, 3)],
        pixel: [0, 255, 0, 255],
      },
    ],
  ],
  ['its field of view is what the page set', 'fov', 1],
  ['setting it is allowed', 'lens', null],
  ['of reference spaces it has viewer alone', 'local', 'NotSupportedError'],
  ['requiring another is refused', 'required', 'NotSupportedError'],
  ['ended, it has no frames', 'ended', 'Error'],
]);

holds('Device API §4, a session on the page beside an immersive one', 'inlineBesideImmersive', [
  ['both have frames', 'both', ['device', 'page']],
  ['it goes on when the immersive one ends', 'alone', ['page']],
]);

holds('Device API §11, WebGL 1', 'webGl1', [
  ['the framebuffer is complete', 'status', true],
  ['it is as large as the screen', 'size', [50, 30]],
  ['what the page draws is what is shown', 'pixel', [0, 0, 128, 128]],
  ['clearing it leaves the page’s own values and masks', 'kept', [0, 0, 0.5, 0.5, true, true, true, false]],
  ['there is no multisampling', 'antialias', false],
  ['the camera’s picture is a texture', 'camera', true],
  ['nothing went wrong in the context', 'error', 0],
]);
