import type { NodeDefinition, ParamDefinition, Unit } from '../../nodes/kit/definition.ts';

/** Name endings of units (docs/CONVENTIONS.md): `sizeM`, `delayS`, `angleRad`, `radiusPx`. */
const ENDINGS: readonly (readonly [string, Unit])[] = [
  ['Rad', 'rad'],
  ['Px', 'px'],
  ['Hz', 'Hz'],
  ['Cd', 'cd'],
  ['M', 'm'],
  ['S', 's'],
  ['K', 'K'],
];

/**
 * Checks rules for definitions that types cannot express. Returns one line per problem.
 *
 * @param isShader Whether the library has a shader of this name.
 */
export function definitionProblems(definition: NodeDefinition, isShader: (name: string) => boolean): string[] {
  return [
    ...wordProblems(definition),
    ...nameProblems(definition),
    ...Object.entries(definition.params).flatMap(([name, param]) =>
      paramProblems(name, param).map((problem) => `param ${name}: ${problem}`),
    ),
    ...layerProblems(definition),
    ...pulseProblems(definition),
    ...controlProblems(definition),
    ...loweringProblems(definition, isShader),
    ...needProblems(definition),
    ...statefulProblems(definition),
  ];
}

function wordProblems({ title, doc, inputs, outputs, params }: NodeDefinition): string[] {
  const problems = [...(title.trim() === '' ? ['has no title'] : []), ...(doc.trim() === '' ? ['has no doc'] : [])];
  const parts = { input: inputs, output: outputs, param: params };
  for (const [kind, record] of Object.entries(parts)) {
    for (const [name, { label, doc: words }] of Object.entries(record)) {
      if (label.trim() === '') problems.push(`${kind} ${name} has no label`);
      if (words.trim() === '') problems.push(`${kind} ${name} has no doc`);
    }
  }
  return problems;
}

function nameProblems({ version, migrations, renamed, inputs, params }: NodeDefinition): string[] {
  const shared = Object.keys(inputs).filter((name) => Object.hasOwn(params, name));
  const steps = (migrations ?? renamed)?.length ?? 0;
  // Only the last name of a renamed param is current.
  const lost = Object.values(renamed?.at(-1) ?? {}).filter(({ to }) => !Object.hasOwn(params, to) && !Object.hasOwn(inputs, to));
  return [
    ...lost.map(({ to }) => `a param was renamed to ${to}, which there is not`),
    ...shared.map((name) => `${name} is an input and a param: a wire to it would be ambiguous`),
    ...(steps === version - 1 ? [] : [`version ${version} needs ${version - 1} migrations, not ${steps}`]),
  ];
}

function paramProblems(name: string, param: ParamDefinition): string[] {
  switch (param.type) {
    case 'number':
      return [...unitProblems(name, param.unit), ...rangeProblems([param.default], one(param.min), one(param.max))];
    case 'vector2':
    case 'vector3':
    case 'vector4': {
      const size = Number(param.type.slice(-1));
      const lists = [param.default, param.min, param.max].filter((list) => list !== undefined);
      if (lists.some((list) => list.length !== size)) return [`default, min and max have ${size} numbers each`];
      return [...unitProblems(name, param.unit), ...rangeProblems(param.default, param.min, param.max)];
    }
    case 'color':
      return rangeProblems(param.default, [0, 0, 0, 0], [1, 1, 1, 1]);
    case 'choice':
      return choiceProblems(param);
    default:
      return [];
  }
}

/** A param has a unit in its name if and only if it has a `unit`. */
function unitProblems(name: string, unit: Unit | undefined): string[] {
  const said = ENDINGS.find(([ending]) => name.endsWith(ending) && name !== ending)?.[1];
  return said === undefined || said === unit ? [] : [`its name says ${said}, its unit ${unit ?? 'nothing'}`];
}

function rangeProblems(value: readonly number[], min?: readonly number[], max?: readonly number[]): string[] {
  const outside = value.some((v, i) => v < (min?.[i] ?? Number.NEGATIVE_INFINITY) || v > (max?.[i] ?? Number.POSITIVE_INFINITY));
  const wrong = [...value, ...(min ?? []), ...(max ?? [])].some((v) => !Number.isFinite(v));
  return [...(outside ? ['its default is out of range'] : []), ...(wrong ? ['not finite'] : [])];
}

function one(value: number | undefined): readonly number[] | undefined {
  return value === undefined ? undefined : [value];
}

function choiceProblems(param: Extract<ParamDefinition, { type: 'choice' }>): string[] {
  const values = param.options.map((option) => option.value);
  const kind = param.stage === 'uniform' ? 'number' : 'string';
  return [
    ...(values.includes(param.default) ? [] : ['its default is no option']),
    ...(new Set(values).size === values.length ? [] : ['two options have the same value']),
    ...(values.every((value) => typeof value === kind) ? [] : [`a ${param.stage} choice holds ${kind}s`]),
  ];
}

/** Layer outputs must declare domain and depth, which the compiler needs. */
function layerProblems({ inputs, outputs }: NodeDefinition): string[] {
  const takesLayer = Object.values(inputs).some((port) => port.type === 'layer');
  return Object.entries(outputs).flatMap(([name, port]) => {
    if (port.type !== 'layer') return [];
    const unsaid = port.domain === undefined || port.depth === undefined;
    const same = (port.domain === 'same' || port.depth === 'same') && !takesLayer;
    return [
      ...(unsaid ? [`output ${name} has to say its domain and depth`] : []),
      ...(same ? [`output ${name} cannot be the same as an input layer: there is none`] : []),
    ];
  });
}

/** Inputs of pulses must accept several wires. */
function pulseProblems({ inputs }: NodeDefinition): string[] {
  return Object.entries(inputs).flatMap(([name, { type, multiple }]) =>
    type === 'pulse' && multiple !== true ? [`input ${name} has to take pulses of several wires`] : [],
  );
}

const CONTROL_PARAMS = {
  slider: { value: 'uniform number', min: 'structure number', max: 'structure number', step: 'structure number' },
  toggle: { value: 'uniform toggle' },
  button: { presses: 'uniform number' },
  choice: { value: 'uniform number', options: 'structure text' },
} as const;

/** The compiler finds these params by name. */
function controlProblems({ control, params }: NodeDefinition): string[] {
  if (control === undefined) return [];
  const expected = { label: 'structure text', place: 'structure number', ...CONTROL_PARAMS[control] };
  return Object.entries(expected).flatMap(([name, kind]) => {
    const param = params[name];
    return param && `${param.stage} ${param.type}` === kind ? [] : [`a ${control} has a param ${name}, a ${kind}`];
  });
}

function loweringProblems({ lowering, inputs, outputs, params }: NodeDefinition, isShader: (name: string) => boolean): string[] {
  if (lowering.kind === 'cpu') {
    const one = [inputs, outputs].every((ports) => Object.values(ports).filter(({ type }) => type === 'layer').length === 1);
    return one && Object.keys(inputs).length === 1 ? [] : ['a CPU filter takes one layer and gives one'];
  }
  if (lowering.kind === 'image' || lowering.kind === 'technique')
    return isShader(lowering.shader) ? [] : [`there is no shader ${lowering.shader}`];
  if (lowering.kind !== 'geometry' || lowering.shadowMap === undefined) return [];
  const { casters, lights, enabledBy } = lowering.shadowMap;
  const toggle = enabledBy === undefined ? null : params[enabledBy];
  return [
    ...casters.filter((name) => inputs[name]?.type !== 'objects').map((name) => `casters ${name} is no input of objects`),
    ...(inputs[lights]?.type === 'lights' ? [] : [`lights ${lights} is no input of lights`]),
    ...(toggle === null || (toggle?.type === 'toggle' && toggle.stage === 'structure') ? [] : [`${enabledBy} is no structure toggle`]),
  ];
}

function needProblems({ needs = [] }: NodeDefinition): string[] {
  return needs.flatMap(({ capability, why, without }) => [
    ...(why.startsWith('to ') ? [] : [`why it needs ${capability} has to read "to …"`]),
    ...(without.trim() === '' ? [`says nothing about a session without ${capability}`] : []),
  ]);
}

/** The compiler finds these params by name. */
function statefulProblems({ stateful, params }: NodeDefinition): string[] {
  if (stateful === undefined || stateful === true) return [];
  if ('moves' in stateful)
    return stateful.moves.flatMap((name) => (params[name]?.stage === 'uniform' ? [] : [`it is stateful by ${name}, no uniform param`]));
  const param = params[stateful.param];
  return param?.type === 'number' && param.stage === 'uniform' ? [] : [`it is stateful by ${stateful.param}, no uniform number`];
}
