import { expect } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { holder } from './clause-tests.ts';

// The emulated device against the text of the specifications: each test names the clause that it holds the device to. Sections are
// those of the editor's drafts: immersive-web.github.io/{depth-sensing, lighting-estimation, raw-camera-access, hit-test, webxr-ar-module}
// and real-world-geometry/plane-detection.

const page = useModule('tests/browser/webxr-clauses.page.ts');

const holds = holder(page);

holds('Depth Sensing §2.3, session configuration', 'depthConfiguration', [
  ['a required feature without depthSensing is refused with NotSupportedError', 'requiredWithoutWishes', 'NotSupportedError'],
  ['an optional one without depthSensing is left out', 'optionalWithoutWishes', 'without depth'],
  ['a required one without a supported combination is refused with NotSupportedError', 'requiredImpossible', 'NotSupportedError'],
  ['an optional one without a supported combination is left out', 'optionalImpossible', 'without depth'],
  ['single preferences are taken as they are', 'single', ['cpu-optimized', 'float32']],
  ['of several preferences the first that is supported is taken', 'several', ['cpu-optimized', 'float32']],
  ['without preferences the device’s own are taken', 'none', ['gpu-optimized', 'unsigned-short']],
  ['luminance-alpha is always supported', 'always', ['gpu-optimized', 'luminance-alpha']],
  ['depthTypeRequest may be ignored', 'typeIgnored', ['gpu-optimized', 'unsigned-short']],
  [
    'depthUsage, depthDataFormat, depthType, depthActive and pausing throw InvalidStateError without depth sensing',
    'absent',
    Array.from({ length: 5 }, () => 'InvalidStateError'),
  ],
]);

holds('Depth Sensing §2.3 to §3.2, depth for the CPU', 'cpuDepth', [
  [
    'depthUsage and depthDataFormat are as granted, depthType is null where the wish was ignored',
    'attributes',
    ['cpu-optimized', 'luminance-alpha', null],
  ],
  ['data has no padding, two bytes for each luminance-alpha entry', 'size', [30, 20, 30 * 20 * 2]],
  ['data and normDepthBufferFromNormView are the same object each time', 'sameObjects', true],
  ['normalized view coordinates begin at the top left, y downwards', 'looksUpwards', true],
  [
    'a depth is the raw value at the truncated column and row, times rawValueToMeters',
    'indexed',
    [expect.closeTo(0, 9), expect.closeTo(0, 9)],
  ],
  ['column and row are clamped to the buffer', 'clamped', expect.closeTo(0, 9)],
  ['coordinates outside [0, 1] throw RangeError', 'outside', ['RangeError', 'RangeError', 'RangeError']],
  ['a view of another frame throws InvalidStateError', 'foreignView', 'InvalidStateError'],
  ['the binding of a session for the CPU throws InvalidStateError', 'onGpu', 'InvalidStateError'],
  ['with matchDepthView, the geometry is that of the view: its pose', 'matched', true],
  ['with matchDepthView, the geometry is that of the view: its projection', 'matchedLens', true],
  [
    'after the frame, asking, data and values throw InvalidStateError',
    'late',
    ['InvalidStateError', 'InvalidStateError', 'InvalidStateError'],
  ],
  ['while the page has paused it, depthActive is false and there is no depth', 'paused', [false, null]],
  ['resumed, depthActive is true and there is depth', 'resumed', [true, true]],
  ['where the device has no depth for the frame, there is null', 'stopped', null],
]);

holds('Depth Sensing §3.3, depth for the GPU', 'gpuDepth', [
  ['one view has a TEXTURE_2D and no image index', 'one', ['texture', null, true]],
  [
    'two views have an array: the right eye index 1, the left index 0',
    'two',
    [
      ['texture-array', 0],
      ['texture-array', 1],
    ],
  ],
  ['the eyes share the array', 'shared', true],
  ['a frame of a session for the GPU throws InvalidStateError', 'onCpu', 'InvalidStateError'],
  ['after the frame, asking and texture throw InvalidStateError', 'late', ['InvalidStateError', 'InvalidStateError']],
  ['depthUsage is as granted', 'usage', 'gpu-optimized'],
]);

holds('Depth Sensing §2.3 and §3.1, matchDepthView: false', 'ownDepthCamera', [
  [
    'the geometry is that of the depth camera when it took the picture, and so are the depths',
    'told',
    // The table's front is at z = -1.5. The camera stands 5 cm to the right; the picture is two frames old.
    [0, 0, 0, 0.5].map((z) => ({ from: [0.05, 0.4, z], lens: expect.closeTo(1 / Math.tan(0.7), 5), middle: 1.5 + z })),
  ],
]);

holds('Lighting Estimation', 'light', [
  ['§4.2: a probe needs the feature, else NotSupportedError', 'without', 'NotSupportedError'],
  ['§4.2: of an ended session there is no probe, InvalidStateError', 'ended', 'InvalidStateError'],
  ['§4.2: formats but srgba8 and the preferred one are refused with NotSupportedError', 'otherFormat', 'NotSupportedError'],
  ['§2.1: a probe has a space', 'space', true],
  ['§2.1: a probe has an event handler', 'handler', true],
  [
    '§2.3: 27 coefficients; a unit direction with w 0; an intensity that is not negative with w 1',
    'estimate',
    {
      coefficients: 27,
      ambient: expect.any(Number),
      direction: [expect.closeTo(0.36, 2), expect.closeTo(0.8, 2), expect.closeTo(0.48, 2), 0],
      intensity: [expect.closeTo(1.9, 5), expect.closeTo(1.8, 5), expect.closeTo(1.65, 5), 1],
    },
  ],
  [
    '§2.3: without an estimate of them the direction is straight up and the intensity none',
    'undirected',
    expect.objectContaining({ direction: [0, 1, 0, 0], intensity: [0, 0, 0, 1] }),
  ],
  ['§4.3: after the frame there is no estimate, InvalidStateError', 'late', 'InvalidStateError'],
  ['§4.3: for a probe of another session there is none, InvalidStateError', 'foreign', 'InvalidStateError'],
  ['§4.3: null where the device cannot estimate the light of the frame', 'none', null],
  ['§2.2: srgba8 is SRGB8_ALPHA8, rgba16f is RGBA16F', 'formats', ['srgb 8', 'linear 16']],
  ['§5.1: each cube map is a new texture', 'anew', true],
  ['§5.1: null where there is no cube map', 'noCube', null],
  ['§5.1: a probe of another session throws InvalidStateError', 'cubeOfForeign', 'InvalidStateError'],
  ['§5.1: an ended session throws InvalidStateError', 'cubeOfEnded', 'InvalidStateError'],
  ['§5.1: a lost context throws InvalidStateError', 'cubeOfLost', 'InvalidStateError'],
  ['§6.1: reflectionchange, an Event, each time that the cube map is another one', 'heard', [1, 2, 'Event']],
]);

holds('Raw Camera Access', 'camera', [
  ['§3.1: without the feature a view has no camera', 'without', null],
  ['§3.1: the camera of a view is the same object each time', 'same', true],
  ['§3.1 and §5.1: the picture is aligned with the view, as large as its viewport', 'size', [80, 60]],
  ['§3.3: the picture is a texture of the binding’s context', 'texture', true],
  ['§3.3: within a frame it may be the same texture', 'cached', true],
  ['§3.3: its colors are premultiplied, here opaque', 'alpha', 255],
  ['§3.1 and §3.3: after the frame, camera and picture throw InvalidStateError', 'late', ['InvalidStateError', 'InvalidStateError']],
]);

holds('Plane Detection', 'planes', [
  ['§3: without the feature no plane is found', 'without', 0],
  ['§4, update planes: a plane is the same object with the same space in each frame', 'same', true],
  ['§3.2: lastChangedTime stays while nothing changes', 'unchanged', 0],
  ['§3.1: a table lies', 'orientation', 'horizontal'],
  ['§3.2: y of its space is the normal', 'up', [0, 1, 0]],
  ['§3.2: its space begins at its middle', 'center', [0, 0.8, -2]],
  [
    '§3.2: y of each corner is 0',
    'polygon',
    [
      [-0.5, 0, -0.5],
      [0.5, 0, -0.5],
      [0.5, 0, 0.5],
      [-0.5, 0, 0.5],
    ],
  ],
  ['§4.1: after the frame, detectedPlanes throws InvalidStateError', 'late', 'InvalidStateError'],
]);

holds('Hit Test', 'hitTest', [
  ['§4: a source needs the feature, else NotSupportedError', 'without', 'NotSupportedError'],
  ['§4: a source needs a space, else TypeError', 'noSpace', 'TypeError'],
  ['§4: of an ended session there is no source, InvalidStateError', 'ended', 'InvalidStateError'],
  [
    '§5: results are of this frame, planes by default, sorted along the ray, y along the normal',
    'places',
    // From 2.1 m down to the table's top at 0.8 m in 1.8 m: the floor follows at 2.1 / 1.3 of the way.
    [
      { at: [0, 0.8, -1.8], up: [0, 1, 0] },
      { at: [0, 0, expect.closeTo((-1.8 * 2.1) / 1.3, 3)], up: [0, 1, 0] },
    ],
  ],
  ['§6: after the frame there are no results, InvalidStateError', 'late', 'InvalidStateError'],
  ['§3.2: a source can be cancelled once, then InvalidStateError', 'cancelled', 'InvalidStateError'],
  ['§6: a cancelled source has no results, InvalidStateError', 'afterCancel', 'InvalidStateError'],
  [
    '§7.1: a ray without direction, a direction with w and an origin without throw TypeError',
    'rays',
    ['TypeError', 'TypeError', 'TypeError'],
  ],
  [
    '§7.1: a plain ray runs from the origin along −z',
    'plainRay',
    [
      [0, 0, 0, 1],
      [0, 0, -1, 0],
    ],
  ],
]);

holds('Augmented Reality §3.2 and Device API §7: displays', 'displays', [
  ['a phone lays pixels over its camera’s picture, is touched, and has one view', 'phone', ['alpha-blend', 'screen-space', ['none']]],
  [
    'a passthrough headset lays pixels over its cameras’ pictures, and has two views',
    'headset',
    ['alpha-blend', 'world-space', ['left', 'right']],
  ],
  ['additive glasses add light', 'glasses', ['additive', 'world-space', ['left', 'right']]],
]);
