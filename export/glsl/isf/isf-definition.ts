import type { ChoiceParam, InputPort, NodeDefinition, OutputPort, ParamDefinition } from '../../../nodes/kit/definition.ts';
import { isImageHandleOf } from '../../../nodes/kit/handles.ts';
import { findAccess } from '../access/find-access.ts';
import { findInput, type IsfInput, type IsfShader, imageInputs } from './isf-shader.ts';

/** The param that fits images of another domain to the view; every composite has it. */
export const FIT_PARAM = 'fit';

const FIT: ChoiceParam = {
  type: 'choice',
  stage: 'structure',
  label: 'Fit',
  doc: 'How an image of another size fits the view: crop what does not fit, show all of it, or stretch it.',
  default: 'cover',
  options: [
    { value: 'cover', label: 'Cover' },
    { value: 'contain', label: 'Contain' },
    { value: 'stretch', label: 'Stretch' },
  ],
};

/**
 * Creates the node type of an ISF file. `name` is the last part of its type: `sepia` gives `filter/sepia`. `access` defaults to what the
 * GLSL says.
 */
export function isfDefinition(shader: IsfShader, name: string, access = findAccess(shader)): NodeDefinition {
  const inputs = portsOf(shader.inputs, inputEncoding(shader));
  const params = paramsOf(shader.inputs);
  if (shader.kind === 'operator' && findInput(shader, FIT_PARAM) === undefined) params[FIT_PARAM] = { ...FIT, default: shader.fit };
  const title = shader.title ?? titleFrom(name);
  return {
    type: `${shader.kind}/${name}`,
    version: shader.renamed.length + 1,
    title,
    doc: shader.description || `${title}, an ISF shader.`,
    ...(shader.categories.length > 0 ? { keywords: shader.categories.map((category) => category.toLowerCase()) } : {}),
    inputs,
    outputs: { layer: outputOf(shader, access) },
    params,
    lowering: { kind: 'image', shader: shader.file, access },
    ...(shader.renamed.length === 0 ? {} : { renamed: shader.renamed }),
    ...(shader.credit === '' ? {} : { credit: shader.credit }),
    ...(shader.licence === '' ? {} : { licence: shader.licence }),
  };
}

/** The name of a shader from its file: `filters/gaussian-blur.fs` gives `gaussian-blur`. */
export function shaderName(file: string): string {
  return file.slice(file.lastIndexOf('/') + 1).replace(/\.(fs|frag|glsl)$/, '');
}

/** Creates the ports of the inputs that only wires can provide, by name. */
export function portsOf(inputs: readonly IsfInput[], encoding: InputPort['encoding'] = 'display'): Record<string, InputPort> {
  return Object.fromEntries(
    inputs.flatMap((input) => {
      const port = portOf(input);
      if (port === null) return [];
      return [[input.name, port.type === 'layer' && encoding !== 'display' ? { ...port, encoding } : port]];
    }),
  );
}

function inputEncoding({ encoding, readsScene }: IsfShader): NonNullable<InputPort['encoding']> {
  if (encoding === 'either') return 'either';
  return readsScene ? 'scene' : 'display';
}

/** The encoding of the output port. Empty for display layers, because display is the default. */
function outputEncoding({ encoding, writesScene }: IsfShader): Pick<OutputPort, 'encoding'> {
  if (encoding === 'either') return { encoding: 'same' };
  return writesScene ? { encoding: 'scene' } : {};
}

function portOf(input: IsfInput): InputPort | null {
  const { label, optional } = input;
  switch (input.type) {
    case 'image':
      return {
        type: 'layer',
        label,
        doc: input.doc || (optional ? 'A layer. Not connected: transparent.' : 'A layer.'),
        required: !optional,
      };
    case 'depth':
      return { type: 'depth', label, doc: input.doc || 'Room depth. Not connected: unknown everywhere.', required: !optional };
    case 'event':
      return { type: 'pulse', label, doc: input.doc || 'True in the frame of a pulse.', required: false, multiple: true };
    case 'audio':
    case 'audioFFT':
      return { type: 'audio', label, doc: input.doc || 'The sound to analyze. Not connected: silence.', required: false };
    case 'bool':
    case 'long':
    case 'float':
    case 'point2D':
    case 'vector3':
    case 'vector4':
    case 'color':
    case 'curve':
    case 'gradient':
      return null;
  }
}

/** Creates the params of the inputs that are values, by name. */
export function paramsOf(inputs: readonly IsfInput[]): Record<string, ParamDefinition> {
  const params: Record<string, ParamDefinition> = {};
  for (const input of inputs) {
    const param = paramOf(input);
    if (param !== null) params[input.name] = param;
  }
  return params;
}

function paramOf(input: IsfInput): ParamDefinition | null {
  const base = { label: input.label, doc: input.doc, stage: 'uniform' } as const;
  const [first = 0] = input.default;
  switch (input.type) {
    case 'float':
      return {
        ...base,
        type: 'number',
        default: first,
        ...range(input),
        ...(input.step === null ? {} : { step: input.step }),
        ...unit(input),
        ...(isImageHandleOf('number', input.handle) ? { handle: input.handle } : {}),
      };
    case 'long':
      if (input.choices.length > 0) return { ...base, type: 'choice', default: first, options: input.choices };
      return { ...base, type: 'number', default: first, ...range(input), step: 1, ...unit(input) };
    case 'bool':
      return { ...base, type: 'toggle', default: first !== 0 };
    case 'point2D':
      return {
        ...base,
        type: 'vector2',
        default: input.default,
        ...(input.min === null ? {} : { min: input.min }),
        ...(input.max === null ? {} : { max: input.max }),
        ...unit(input),
        ...(isImageHandleOf('vector2', input.handle) ? { handle: input.handle } : {}),
      };
    case 'vector3':
    case 'vector4':
      return { ...base, type: input.type, default: input.default };
    case 'curve':
    case 'gradient':
      return { ...base, type: input.type, default: input.default };
    case 'color': {
      const [r = 0, g = 0, b = 0, a = 1] = input.default;
      return { ...base, type: 'color', default: [r, g, b, a] };
    }
    case 'image':
    case 'depth':
    case 'event':
    case 'audio':
    case 'audioFFT':
      return null;
  }
}

function range(input: IsfInput): { min?: number; max?: number } {
  const [min] = input.min ?? [];
  const [max] = input.max ?? [];
  return { ...(min === undefined ? {} : { min }), ...(max === undefined ? {} : { max }) };
}

function unit(input: IsfInput): { unit?: IsfInput['unit'] } {
  return input.unit === 'none' ? {} : { unit: input.unit };
}

/**
 * Creates the output port. By default (`"SCRIM_DEPTH": "auto"`), the layer keeps the depth of the input if the shader does not move its
 * pixels.
 */
function outputOf(shader: IsfShader, access: ReturnType<typeof findAccess>): OutputPort {
  const port = { type: 'layer', label: 'Layer', doc: 'The result.', ...outputEncoding(shader) } as const;
  if (imageInputs(shader).length === 0) return { ...port, domain: 'view', depth: false };
  const stays = access === 'pointwise' || access === 'neighborhood';
  const depth = { auto: stays ? ('same' as const) : false, same: 'same' as const, none: false, over: true, nearer: true }[shader.depth];
  return { ...port, domain: 'same', depth };
}

/** A title from a name: `gaussian-blur` gives `Gaussian blur`. */
export function titleFrom(name: string): string {
  const words = name.replace(/[-_]+/g, ' ').trim();
  return words === '' ? name : words[0]?.toUpperCase() + words.slice(1);
}
