import { readDefinition } from '../../export/glsl/read-definition.ts';
import type { ReadShader } from '../../export/graph/library/project-library.ts';
import { defineNode, libraryOf, type NodeDefinition, type NodeLibrary } from '../../nodes/kit/definition.ts';
import { TEST_VALUES } from './test-values.ts';

/**
 * Node types with the interfaces of the real ones, for tests of the document and the compiler. Changes of real nodes do not affect
 * these tests.
 */

const layerOut = { type: 'layer', label: 'Layer', doc: '' } as const;
const objectsOut = { type: 'objects', label: 'Objects', doc: '' } as const;
const needed = { label: '', doc: '', required: true } as const;
const list = { label: '', doc: '', required: false, multiple: true } as const;
const number = { type: 'number', stage: 'uniform', label: 'Number', doc: '', default: 0 } as const;
const toggle = { type: 'toggle', label: 'Toggle', doc: '', default: true } as const;

const NODES: readonly NodeDefinition[] = [
  defineNode({
    type: 'source/camera-video',
    version: 1,
    title: 'Camera video',
    doc: '',
    inputs: {},
    outputs: { layer: { ...layerOut, domain: 'view', depth: false } },
    params: {},
    lowering: { kind: 'source', background: 'world' },
    needs: [
      {
        capability: 'camera-image',
        required: false,
        when: 'sampled',
        why: 'to style the camera picture',
        without: 'Only virtual things are styled.',
      },
    ],
  }),
  defineNode({
    type: 'source/image-file',
    version: 1,
    title: 'Picture',
    doc: '',
    inputs: {},
    outputs: { layer: { ...layerOut, domain: 'image', depth: false } },
    params: { image: { type: 'asset', stage: 'asset', label: 'Picture', doc: '', default: '', accept: 'image' } },
    lowering: { kind: 'source' },
  }),
  defineNode({
    type: 'source/model',
    version: 1,
    title: 'Model',
    doc: '',
    inputs: {},
    outputs: { objects: objectsOut },
    params: {
      model: { type: 'asset', stage: 'asset', label: 'Model', doc: '', default: '', accept: 'model' },
      speed: { ...number, label: 'Speed', default: 1, min: 0, max: 4 },
      clip: { type: 'text', stage: 'structure', label: 'Clip', doc: '', default: '' },
    },
    lowering: { kind: 'source' },
  }),
  defineNode({
    type: 'objects/primitive',
    version: 1,
    title: 'Primitive',
    doc: '',
    inputs: {},
    outputs: { objects: objectsOut },
    params: {
      shape: {
        type: 'choice',
        stage: 'structure',
        label: 'Shape',
        doc: '',
        default: 'box',
        options: [
          { value: 'box', label: 'Box' },
          { value: 'sphere', label: 'Sphere' },
        ],
      },
      color: { type: 'color', stage: 'uniform', label: 'Color', doc: '', default: [1, 1, 1, 1] },
    },
    lowering: { kind: 'geometry' },
  }),
  defineNode({
    type: 'objects/transform',
    version: 1,
    title: 'Transform',
    doc: '',
    inputs: { objects: { type: 'objects', ...needed, label: 'Objects' } },
    outputs: { objects: objectsOut },
    params: {
      position: { type: 'vector3', stage: 'uniform', label: 'Position', doc: '', default: [0, 0, 0], unit: 'm' },
      scale: { ...number, label: 'Scale', default: 1, min: 0.001, max: 1000 },
    },
    lowering: { kind: 'geometry' },
  }),
  defineNode({
    type: 'objects/group',
    version: 1,
    title: 'Group',
    doc: '',
    inputs: { objects: { type: 'objects', ...list, label: 'Objects' } },
    outputs: { objects: objectsOut },
    params: {},
    lowering: { kind: 'geometry' },
  }),
  defineNode({
    type: 'objects/phantom',
    version: 1,
    title: 'Phantom',
    doc: '',
    inputs: { objects: { type: 'objects', ...needed, label: 'Objects' } },
    outputs: { objects: objectsOut },
    params: { casts: { ...toggle, stage: 'structure', label: 'Casts shadows' } },
    lowering: { kind: 'geometry' },
  }),
  defineNode({
    type: 'light/directional',
    version: 1,
    title: 'Directional light',
    doc: '',
    inputs: {},
    outputs: { lights: { type: 'lights', label: 'Lights', doc: '' } },
    params: {
      direction: { type: 'vector3', stage: 'uniform', label: 'Direction', doc: '', default: [0, 1, 0] },
      intensity: { ...number, label: 'Intensity', default: 1, min: 0 },
    },
    lowering: { kind: 'geometry' },
  }),
  defineNode({
    type: 'world/depth',
    version: 1,
    title: 'Room depth',
    doc: '',
    inputs: {},
    outputs: { depth: { type: 'depth', label: 'Depth', doc: '' } },
    params: {},
    lowering: { kind: 'source' },
    needs: [
      {
        capability: 'depth',
        required: false,
        when: 'always',
        why: 'to hide things behind the room',
        without: 'Nothing is hidden by the room.',
      },
    ],
  }),
  defineNode({
    type: 'layer/scene',
    version: 1,
    title: 'Scene',
    doc: '',
    inputs: { objects: { type: 'objects', ...list, label: 'Objects' }, lights: { type: 'lights', ...list, label: 'Lights' } },
    outputs: { layer: { ...layerOut, domain: 'view', depth: true } },
    params: { shadows: { ...toggle, stage: 'structure', label: 'Shadows' } },
    lowering: { kind: 'geometry', shadowMap: { casters: ['objects'], lights: 'lights', enabledBy: 'shadows' } },
  }),
  defineNode({
    type: 'layer/shadow',
    version: 1,
    title: 'Shadow',
    doc: '',
    inputs: {
      casters: { type: 'objects', ...list, label: 'Casters' },
      receivers: { type: 'objects', ...list, label: 'Receivers' },
      lights: { type: 'lights', ...list, label: 'Lights' },
    },
    outputs: { layer: { ...layerOut, domain: 'view', depth: true } },
    params: { strength: { ...number, label: 'Strength', default: 0.5, min: 0, max: 1 } },
    lowering: { kind: 'geometry', shadowMap: { casters: ['casters'], lights: 'lights' } },
  }),
  defineNode({
    type: 'layer/depth-occlusion',
    version: 1,
    title: 'Depth occlusion',
    doc: '',
    inputs: { layer: { type: 'layer', ...needed, label: 'Layer' }, depth: { type: 'depth', ...needed, label: 'Depth' } },
    outputs: { layer: { ...layerOut, domain: 'same', depth: 'same' } },
    params: { softness: { ...number, label: 'Softness', default: 0.02, min: 0, max: 1, unit: 'm' } },
    lowering: { kind: 'image', shader: 'layer/depth-occlusion/occlusion.fs', access: 'pointwise', early: 'occlusion' },
  }),
  ...TEST_VALUES,
  defineNode({
    type: 'output/screen',
    version: 1,
    title: 'Screen',
    doc: '',
    inputs: { layer: { type: 'layer', ...needed, label: 'Layer' } },
    outputs: {},
    params: {
      antialias: { ...toggle, stage: 'structure', label: 'Smooth edges' },
      background: {
        type: 'choice',
        stage: 'structure',
        label: 'Background',
        doc: '',
        default: 'world',
        options: [
          { value: 'world', label: 'The world' },
          { value: 'color', label: 'A color' },
        ],
      },
      color: { type: 'color', stage: 'structure', label: 'Color', doc: '', default: [0, 0, 0, 1] },
    },
    lowering: { kind: 'present' },
  }),
];

function isf(header: object, body: string): string {
  return `/*${JSON.stringify({ ISFVSN: '2', ...header })}*/\n${body}\n`;
}

const image = (NAME: string) => ({ NAME, TYPE: 'image' });
const float = (NAME: string, DEFAULT: number, MIN: number, MAX: number) => ({ NAME, TYPE: 'float', DEFAULT, MIN, MAX });

/** ISF texts, by the names in lowerings. */
export const TEST_SHADERS: Readonly<Record<string, string>> = {
  'filters/sepia.fs': isf(
    { INPUTS: [image('inputImage'), float('amount', 1, 0, 1)] },
    'void main() {\n  vec4 c = IMG_THIS_PIXEL(inputImage);\n  gl_FragColor = vec4(mix(c.rgb, vec3(dot(c.rgb, vec3(0.3, 0.6, 0.1))), amount), c.a);\n}',
  ),
  'filters/curves.fs': isf(
    {
      INPUTS: [
        image('inputImage'),
        { NAME: 'tone', TYPE: 'curve' },
        {
          NAME: 'warmth',
          TYPE: 'curve',
          DEFAULT: [
            [0, 0.1],
            [1, 1],
          ],
        },
      ],
    },
    'void main() {\n  vec4 c = IMG_THIS_PIXEL(inputImage);\n  gl_FragColor = vec4(CURVE(warmth, CURVE(tone, c.r)), CURVE(tone, c.g), c.b, c.a);\n}',
  ),
  'filters/swirl.fs': isf(
    { INPUTS: [image('inputImage'), float('angle', 1, -10, 10)] },
    'void main() {\n  vec2 p = isf_FragNormCoord - 0.5;\n  float a = angle * length(p);\n  gl_FragColor = IMG_NORM_PIXEL(inputImage, 0.5 + mat2(cos(a), -sin(a), sin(a), cos(a)) * p);\n}',
  ),
  'filters/gaussian-blur.fs': isf(
    {
      SCRIM_ALPHA: 'premultiplied',
      INPUTS: [image('inputImage'), float('radius', 4, 0, 64)],
      PASSES: [{ TARGET: 'horizontal' }, {}],
    },
    `vec4 blur(vec2 axis) {
  return vec4(0.0);
}
void main() {
  if (PASSINDEX == 0) gl_FragColor = 0.5 * (IMG_PIXEL(inputImage, gl_FragCoord.xy - vec2(radius, 0.0)) + IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(radius, 0.0)));
  else gl_FragColor = 0.5 * (IMG_PIXEL(horizontal, gl_FragCoord.xy - vec2(0.0, radius)) + IMG_PIXEL(horizontal, gl_FragCoord.xy + vec2(0.0, radius)));
}`,
  ),
  'filters/sobel-edges.fs': isf(
    { INPUTS: [image('inputImage')] },
    'void main() {\n  vec4 a = IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(1.0, 0.0));\n  vec4 b = IMG_PIXEL(inputImage, gl_FragCoord.xy - vec2(1.0, 0.0));\n  gl_FragColor = vec4(abs(a.rgb - b.rgb), 1.0);\n}',
  ),
  'filters/trails.fs': isf(
    {
      INPUTS: [image('inputImage'), float('decay', 0.9, 0, 1)],
      PASSES: [{ TARGET: 'trail', PERSISTENT: true, FLOAT: true }, {}],
    },
    'void main() {\n  if (PASSINDEX == 0) gl_FragColor = max(IMG_THIS_PIXEL(inputImage), decay * IMG_THIS_PIXEL(trail));\n  else gl_FragColor = IMG_THIS_PIXEL(trail);\n}',
  ),
  'filters/thumbnail.fs': isf(
    {
      INPUTS: [image('inputImage'), float('fraction', 0.25, 0, 1)],
      PASSES: [{ TARGET: 'small', WIDTH: 'floor($WIDTH * $fraction)', HEIGHT: 'max($HEIGHT / 8.0, 1.0)' }, {}],
    },
    'void main() {\n  if (PASSINDEX == 0) gl_FragColor = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord);\n  else gl_FragColor = IMG_NORM_PIXEL(small, isf_FragNormCoord);\n}',
  ),
  'filters/fog.fs': isf(
    { INPUTS: [image('inputImage'), float('density', 0.1, 0, 1)] },
    'void main() {\n  vec4 c = IMG_THIS_PIXEL(inputImage);\n  float d = LAYER_DEPTH(inputImage, isf_FragNormCoord);\n  gl_FragColor = vec4(mix(c.rgb, vec3(0.5), 1.0 - exp(-density * d)), c.a);\n}',
  ),
  'operators/over.fs': isf(
    {
      SCRIM_ALPHA: 'premultiplied',
      SCRIM_DEPTH: 'over',
      INPUTS: [image('top'), image('bottom'), float('opacity', 1, 0, 1)],
    },
    'void main() {\n  vec4 t = opacity * IMG_THIS_PIXEL(top);\n  gl_FragColor = t + (1.0 - t.a) * IMG_THIS_PIXEL(bottom);\n}',
  ),
  'operators/mask.fs': isf(
    { SCRIM_ALPHA: 'premultiplied', INPUTS: [image('inputImage'), image('mask')] },
    'void main() {\n  gl_FragColor = IMG_THIS_PIXEL(inputImage) * IMG_THIS_PIXEL(mask).a;\n}',
  ),
  'generators/noise.fs': isf(
    { INPUTS: [float('scale', 10, 1, 100)] },
    'void main() {\n  gl_FragColor = vec4(vec3(fract(sin(dot(floor(scale * isf_FragNormCoord), vec2(12.9898, 78.233))) * 43758.5453)), 1.0);\n}',
  ),
  'layer/depth-occlusion/occlusion.fs': isf(
    {
      SCRIM_ALPHA: 'premultiplied',
      INPUTS: [image('layer'), { NAME: 'depth', TYPE: 'depth' }, float('softness', 0.02, 0, 1)],
    },
    'void main() {\n  float virtualM = LAYER_DEPTH(layer, isf_FragNormCoord);\n  float roomM = ROOM_DEPTH(depth, isf_FragNormCoord);\n  float hidden = roomM > 0.0 ? smoothstep(-softness, softness, virtualM - roomM) : 0.0;\n  gl_FragColor = IMG_THIS_PIXEL(layer) * (1.0 - hidden);\n}',
  ),
};

/** The ISF reader of the compiler, for tests of the document. */
export const readShader: ReadShader = (file, source) => readDefinition(source, file);

function libraryDefinitions(): NodeDefinition[] {
  return Object.entries(TEST_SHADERS).flatMap(([file, source]) => {
    if (file.startsWith('layer/')) return [];
    const { output, diagnostics } = readShader(file, source);
    if (output === null) throw new Error(`${file}: ${JSON.stringify(diagnostics)}`);
    return [output];
  });
}

export const TEST_LIBRARY: NodeLibrary = libraryOf([...NODES, ...libraryDefinitions()], TEST_SHADERS);
