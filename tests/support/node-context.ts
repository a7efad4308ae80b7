import { createPulseQueue, type PulseQueue } from '../../export/runtime/values/pulses.ts';
import { createCapturedPlace } from '../../nodes/kit/captured-place.ts';
import type { InputPort, NodeDefinition, ParamDefinition, ParamValue } from '../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { createPose } from '../../nodes/kit/pose.ts';
import type { NodeContext, PulseList } from '../../nodes/kit/runtime.ts';
import { VALUE_SIZES, type WireType } from '../../nodes/kit/wire-types.ts';

export interface FakeContextOptions<D extends NodeDefinition> {
  /** Values of params. Others have their defaults. */
  readonly params?: { readonly [K in keyof D['params']]?: ParamValue };
  /** Values of inputs. Others are not connected. */
  readonly inputs?: Partial<NodeContext<D>['inputs']>;
  /** Services that the node uses (`gl`, `scenes`, `assets`, `session`, `workers`). Access to others throws. */
  readonly services?: Partial<Pick<NodeContext<D>, 'gl' | 'scenes' | 'assets' | 'session' | 'random' | 'workers' | 'occlusion'>>;
}

export interface FakeContext<D extends NodeDefinition> {
  readonly ctx: NodeContext<D>;
  /** All diagnostics that the node reported. */
  readonly reports: readonly Omit<Diagnostic, 'nodeId'>[];
  /** Changes a uniform param, as a wire or the inspector does between two frames. */
  set(param: keyof D['params'] & string, value: ParamValue): void;
  /** Advances the clock to the next frame, and clears pulse outputs. */
  tick(deltaS: number): void;
}

/** A context for the runtime of a node outside the player: params by definition, readable outputs, and a manual clock. */
export function fakeContext<const D extends NodeDefinition>(definition: D, options: FakeContextOptions<D> = {}): FakeContext<D> {
  const given: Readonly<Record<string, ParamValue | undefined>> = options.params ?? {};
  const unknown = Object.keys(given).filter((name) => !Object.hasOwn(definition.params, name));
  if (unknown.length > 0) throw new Error(`${definition.type} has no param ${unknown.join(', ')}.`);
  const ofStage = <T>(stage: ParamDefinition['stage'], make: (value: ParamValue, param: ParamDefinition) => T): Record<string, T> =>
    Object.fromEntries(
      Object.entries(definition.params)
        .filter(([, param]) => param.stage === stage)
        .map(([name, param]) => [name, make(given[name] ?? param.default, param)]),
    );

  const params = ofStage('uniform', (value, param) => ({ value: live(value, param) }));
  const clock = { timeS: 0, deltaS: 0, frame: 0, held: false };
  const reports: Omit<Diagnostic, 'nodeId'>[] = [];
  // As where nothing reads outputs that are computed only then.
  const written = Object.entries(definition.outputs).filter(([, port]) => !port.whenRead);
  const outputs = Object.fromEntries(written.map(([name, port]) => [name, emptyOutput(port.type)]));
  const context = {
    node: `${definition.type.split('/')[1]}-test`,
    inputs: {
      ...Object.fromEntries(Object.entries(definition.inputs).map(([name, port]) => [name, emptyInput(port)])),
      ...options.inputs,
    },
    outputs,
    params,
    config: ofStage('structure', (value) => value),
    assetIds: ofStage('asset', (value) => (value === '' ? null : value)),
    clock,
    random: () => 0.5,
    occlusion: options.services?.occlusion ?? null,
    report: (diagnostic: Omit<Diagnostic, 'nodeId'>) => reports.push(diagnostic),
    ...services(options.services ?? {}),
  };
  return {
    // Built from the definition by the rules of the type, which TypeScript cannot check in a loop over keys.
    ctx: context as unknown as NodeContext<D>,
    reports,
    set: (name, value) => {
      const view = params[name];
      const param = definition.params[name];
      if (!view || !param) throw new Error(`${definition.type} has no uniform param ${name}.`);
      view.value = live(value, param);
    },
    tick: (deltaS) => {
      clock.timeS += deltaS;
      clock.deltaS = deltaS;
      clock.frame += 1;
      for (const [name, { type }] of Object.entries(definition.outputs)) if (type === 'pulse') (outputs[name] as PulseQueue).clear();
    },
  };
}

/** Value as in the slots of the player: vectors and colors in a `Float64Array`. */
function live(value: ParamValue, param: ParamDefinition): unknown {
  return Array.isArray(value) && param.type !== 'choice' ? Float64Array.from(value as readonly number[]) : value;
}

/** The numbers of the pulses in a list. */
export function pulseNumbers(list: PulseList): number[] {
  return Array.from({ length: list.count }, (_, i) => list.at(i).number);
}

function emptyInput({ type, multiple }: InputPort): unknown {
  if (type === 'pulse') return createPulseQueue();
  return multiple ? [] : null;
}

function emptyOutput(type: WireType): unknown {
  switch (type) {
    case 'number':
      // Not 0, so that a missing write is noticed.
      return { value: Number.NaN };
    case 'vector2':
    case 'vector3':
    case 'vector4':
    case 'color':
      return { value: new Float64Array(VALUE_SIZES[type]).fill(Number.NaN) };
    case 'toggle':
      return { value: false };
    case 'text':
      return { value: '' };
    case 'pulse':
      return createPulseQueue();
    case 'pose':
      return createPose();
    case 'capture':
      return createCapturedPlace();
    case 'objects':
    case 'lights':
      return { version: 0, items: [] };
    case 'body':
      return { version: 0, bodies: [] };
    case 'environment':
      return { asset: null, intensity: 1, rotationRad: 0 };
    case 'audio':
      return { channelCount: 0, sampleRateHz: 0, samples: [new Float32Array(4096), new Float32Array(4096)], version: 0 };
    case 'layer':
    case 'depth':
      return { views: [] };
    default:
      throw new Error(`No node makes ${type} yet, so there is no empty one.`);
  }
}

/** The given services; access to others throws with their name. */
function services(given: Readonly<Record<string, unknown>>): Record<string, unknown> {
  const all = ['gl', 'scenes', 'assets', 'session', 'workers'].map((name) => [name, given[name] ?? refusing(name)] as const);
  return { ...Object.fromEntries(all), ...(given.random === undefined ? {} : { random: given.random }) };
}

function refusing(name: string): unknown {
  return new Proxy(
    {},
    {
      get: (_target, key) => {
        throw new Error(`The node read ctx.${name}.${String(key)}, and the test gave no ${name}.`);
      },
    },
  );
}
