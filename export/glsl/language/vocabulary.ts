import { type BuiltinFunction, readSignature } from './builtin-docs.ts';

/** Variables of the host of an ISF file (docs.isf.video, “Automatically Created Uniforms”) and of GLSL. */
export const ISF_VARIABLES: ReadonlyMap<string, { readonly type: string; readonly doc: string }> = new Map([
  ['TIME', { type: 'float', doc: 'Seconds since the first frame.' }],
  ['TIMEDELTA', { type: 'float', doc: 'Seconds since the last frame.' }],
  ['FRAMEINDEX', { type: 'int', doc: 'Number of this frame, from 0.' }],
  ['DATE', { type: 'vec4', doc: 'Year, month, day, and seconds of the day.' }],
  ['RENDERSIZE', { type: 'vec2', doc: 'Width and height of what this pass draws, pixels.' }],
  ['PASSINDEX', { type: 'int', doc: 'Number of this pass, from 0.' }],
  ['SCRIM_CLIP_FROM_VIEW', { type: 'mat4', doc: 'Projection of the view: clip space from view space. Scrim only.' }],
  ['SCRIM_WORLD_FROM_VIEW', { type: 'mat4', doc: 'Pose of the view: world space from view space, meters. Scrim only.' }],
  ['isf_FragNormCoord', { type: 'vec2', doc: 'This pixel, from (0, 0) at the bottom left to (1, 1) at the top right.' }],
  ['isf_FragCoord', { type: 'vec2', doc: 'Middle of this pixel, pixels from the bottom left.' }],
  ['vv_FragNormCoord', { type: 'vec2', doc: 'What version 1 of ISF calls isf_FragNormCoord.' }],
  ['vv_FragCoord', { type: 'vec2', doc: 'What version 1 of ISF calls isf_FragCoord.' }],
  ['gl_FragCoord', { type: 'vec4', doc: 'Middle of this pixel, pixels from the bottom left; z is the depth.' }],
  ['gl_FragColor', { type: 'vec4', doc: 'Color of this pixel: red, green, blue and alpha from 0 to 1, alpha not multiplied in.' }],
  ['isf_FragColor', { type: 'vec4', doc: 'What hosts with newer GLSL call gl_FragColor.' }],
  ['gl_FragData', { type: 'vec4[]', doc: 'gl_FragData[0] is gl_FragColor.' }],
]);

/** Variables of the host and of GLSL in a vertex shader of an ISF file. */
export const VERTEX_VARIABLES: typeof ISF_VARIABLES = new Map([
  ...[...ISF_VARIABLES].filter(([name]) => !/^gl_|FragCoord$/.test(name)),
  ['isf_FragNormCoord', { type: 'vec2', doc: 'This corner, from (0, 0) at the bottom left to (1, 1) at the top right.' }],
  ['gl_Position', { type: 'vec4', doc: 'Where this corner is drawn, from -1 to 1.' }],
]);

/** Functions of ISF and Scrim that read images; `image` is the name of an image in the header. */
export const ISF_FUNCTIONS: ReadonlyMap<string, BuiltinFunction> = new Map(
  [
    ['vec4 IMG_PIXEL(image, vec2 pixel)', 'Color of an image at a place in pixels from its bottom left.'],
    ['vec4 IMG_NORM_PIXEL(image, vec2 place)', 'Color of an image at a place from (0, 0), bottom left, to (1, 1).'],
    ['vec4 IMG_THIS_PIXEL(image)', 'Color of an image at this pixel.'],
    ['vec4 IMG_THIS_NORM_PIXEL(image)', 'Color of an image at this pixel.'],
    ['vec4 IMG_NORM_THIS_PIXEL(image)', 'Color of an image at this pixel.'],
    ['vec2 IMG_SIZE(image)', 'Width and height of an image, pixels.'],
    [
      'vec2 IMG_SAMPLES(image)',
      'Width and height of the texture of an image, such as the samples of a depth sensor in its confidence. Scrim only.',
    ],
    [
      'float LAYER_DEPTH(image, vec2 place)',
      'Distance of what the layer shows at a place from 0 to 1, meters; 0 where there is nothing. Scrim only.',
    ],
    ['float ROOM_DEPTH(depth, vec2 place)', 'Distance of the real room at a place from 0 to 1, meters; 0 where it is unknown. Scrim only.'],
    ['float CURVE(curve, float x)', 'Height of a curve at a place from 0 to 1. Scrim only.'],
    ['vec4 GRADIENT(gradient, float x)', 'Color of a gradient at a place from 0 to 1, straight alpha. Scrim only.'],
  ].map(([label = '', doc = '']) => {
    const name = /(\w+)\(/.exec(label)?.[1] ?? '';
    return [name, { name, signatures: [readSignature(label)], doc }] as const;
  }),
);

/** Names that techniques use (`technique/interface.ts`). */
export const TECHNIQUE_DOCS: ReadonlyMap<string, string> = new Map([
  ['Vertex', 'A corner of an object, in world space. “vertex” may move it.'],
  ['Surface', 'The point of an object that is drawn, in world space.'],
  ['Light', 'A light as it reaches the surface.'],
  ['EYE', 'Position of the camera, meters, world space.'],
  ['AMBIENT', 'What a white matte surface with this normal reflects of the environment, linear-sRGB; in “surface” only.'],
  ['LIGHT_COUNT', 'How many lights there are.'],
  ['LIGHT', 'One of the lights, from 0; in “surface” only.'],
  ['IRRADIANCE', 'Irradiance from the environment on a surface with a normal, linear-sRGB; in “surface” only.'],
  [
    'REFLECTION',
    'Radiance of the environment in a direction, blurred as a surface of a roughness from 0 to 1 mirrors it; in “surface” only.',
  ],
  ['ENVIRONMENT', 'The environment as one light, from its brightest side; in “surface” only.'],
  ['PASSINDEX', 'Number of this pass, from 0.'],
  ['TIME', 'Seconds since the first frame.'],
  ['RENDERSIZE', 'Width and height of the render target, pixels.'],
  ['VIEW_UV', 'Where a world position is on the screen, (0, 0) at the bottom left.'],
  ['VIEW_DEPTH', 'Distance of a world position along the view, meters.'],
  ['PIXEL_M', 'Size of a pixel at a world position, meters.'],
  ['rest', 'Rest position: local space, meters, before skinning and morphing.'],
  ['restNormal', 'Normal at the rest position, local space.'],
  ['along', 'Direction along the curvature of the surface at rest: local space, length 1. Its sign has no meaning.'],
  ['smoothNormal', 'Normal at the rest position, averaged over the faces at each vertex, local space.'],
  ['radial', 'Radial curvature at rest times sin² θ, and its derivative towards the eye times sin θ, in units of the radius of the mesh.'],
  ['outward', 'Hull normal, for outlines: moving every vertex by it moves each face by the same distance.'],
  ['contour', 'In passes of edges: whether the edge is a silhouette in this view, or a border of the mesh.'],
  ['crease', 'In passes of edges: angle between the faces, radians; 0 if they are coplanar, negative if they are concave, π at a border.'],
  ['widthPx', 'In passes of edges: width of the line, pixels. 0 leaves it out.'],
  ['endPx', 'In passes of edges: how far a stroke of creases or borders goes beyond its ends, pixels.'],
  ['roomM', 'In passes of edges: how far apart lines lie around here, meters; very large where there are few.'],
  [
    'line',
    'In passes of edges: meters from the start of the stroke, position across the line from -1 to 1, and meters of the whole stroke, 0 for a silhouette.',
  ],
  ['position', 'Meters, world space.'],
  ['normal', 'Direction away from the surface, length 1.'],
  ['towardsEye', 'Direction to the eye, of length 1.'],
  ['towards', 'Direction to the light, of length 1.'],
  ['radiance', 'Light that would reach the surface without shadows, linear-sRGB.'],
  ['lit', 'Fraction of the light that is not in shadow, 0 to 1.'],
  ['uv', 'Texture coordinates.'],
  ['color', 'Color of its own, linear-sRGB with straight alpha.'],
  ['front', 'Whether the front face is visible.'],
]);

/** Keys of a header and their descriptions, by the object that contains them. */
export const HEADER_KEYS: Readonly<Record<'root' | 'input' | 'pass', Readonly<Record<string, string>>>> = {
  root: {
    ISFVSN: 'Version of ISF that the file is written for: "2".',
    VSN: 'Version of the file itself.',
    DESCRIPTION: 'What the effect does, in a sentence or two.',
    CREDIT: 'Author, and sources that the effect is based on.',
    CATEGORIES: 'Words to find it by.',
    INPUTS: 'Ports and parameters of the node.',
    PASSES: 'Passes, in the order they are drawn.',
    IMPORTED: 'Images that belong to the effect.',
    SCRIM_TITLE: 'Title of the node.',
    SCRIM_ALPHA: '"premultiplied": colors are read and written with alpha multiplied in.',
    SCRIM_OPAQUE: 'Images that make the output opaque if they and the colors are. Scrim believes it of its own files only.',
    SCRIM_ENCODING:
      'Encoding of the layers that the shader reads and outputs: "display" (default), "scene" for linear, unclamped light, "either", where SCRIM_SCENE is defined for scene layers, "scene to display" or "display to scene".',
    SCRIM_DEPTH: 'How the output gets its depth: "auto", "same", "none", "over" or "nearer".',
    SCRIM_UNITS: 'Units of inputs, by name.',
    SCRIM_RENAMED: 'What inputs were called in earlier versions of the file.',
  },
  input: {
    NAME: 'Name in the GLSL.',
    TYPE: 'Kind of value.',
    LABEL: 'Label in the inspector.',
    DOC: 'What this input does, in one sentence.',
    DEFAULT: 'Initial value.',
    MIN: 'Smallest value.',
    MAX: 'Greatest value.',
    IDENTITY: 'Value with which nothing changes.',
    VALUES: 'Numbers that a "long" can be.',
    LABELS: 'What those numbers are called.',
    UNIT: 'm, s, rad, px, K, Hz, cd, ratio or none.',
    STEP: 'Difference between a value of the control and the next.',
    HANDLE: 'Part of the gizmo in the preview that changes it: center, extent, angle, low, high, size or feather.',
    OPTIONAL: 'Whether an image may stay unconnected.',
  },
  pass: {
    TARGET: 'Buffer that the pass draws into; without it, the node’s output.',
    PERSISTENT: 'Whether the buffer keeps the previous frame.',
    FLOAT: 'Whether the buffer holds 32-bit floats, below 0 and above 1 too.',
    SCRIM_HALF: 'Whether 16-bit floats suffice, at half the memory.',
    WIDTH: 'Number, or expression of $WIDTH, $HEIGHT and inputs.',
    HEIGHT: 'Number, or expression of $WIDTH, $HEIGHT and inputs.',
    SIDE: 'Techniques: "front", "back", "both" or "object"; "edges" draws edges as lines.',
    OPEN: 'Techniques: whether the pass of edges is drawn only for meshes with a border.',
  },
};

export const INPUT_TYPE_DOCS: Readonly<Record<string, string>> = {
  event: 'True in the frame of a pulse.',
  bool: 'True or false.',
  long: 'A whole number, or one of several choices.',
  float: 'A number.',
  point2D: 'Two numbers: a place.',
  color: 'Red, green, blue and alpha from 0 to 1.',
  image: 'A layer.',
  audio: 'The waveform of a sound, as an image.',
  audioFFT: 'The spectrum of a sound, as an image.',
  depth: 'Distance to the real world. Scrim only.',
  curve: 'A curve from 0 to 1, edited in the inspector. Scrim only.',
  gradient: 'Colors from 0 to 1, edited in the inspector. Scrim only.',
};
