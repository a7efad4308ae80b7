import type { ParamValue } from '../../nodes/kit/definition.ts';

type Params = Readonly<Record<string, ParamValue>>;

/**
 * A cell of the wall, which demonstrates a node type. Wires address ports as `name.port`, where `name` is a node of the cell or one of
 * `SIGNALS`, which all cells share.
 */
export interface Cell {
  readonly title: string;
  readonly nodes: Readonly<Record<string, readonly [type: string, params?: Params]>>;
  readonly wires: readonly string[];
  /**
   * How the cell shows one of its outputs (`name.port`). `height`: as the height of a ball on its rail, from 0 at the foot to 1 at the top.
   * `place`: as the position of a ball relative to the center of the cell, in rail heights. `color`: as the color of a box. `things`: the
   * output has objects of its own, also in rail heights around the center.
   */
  readonly shows: readonly ['height' | 'place' | 'color' | 'things', string];
}

/** Cells that are next to each other in a row, from left to right. */
export interface Section {
  /** Name of the subgraph. */
  readonly name: string;
  readonly title: string;
  /** Row and column of its first cell, from the top left. */
  readonly row: number;
  readonly column: number;
  readonly cells: readonly Cell[];
}

/**
 * Signals for several cells. `time`: seconds. `saw`: seconds that start over after 2. `unit`: from 0 to 1 in the same time. `beat`: a pulse
 * every half second. `steps`: 0 and 1 in turn, changing with each beat.
 */
export const SIGNALS: Cell['nodes'] = {
  time: ['value/time'],
  saw: ['value/time', { loopS: 2 }],
  unit: ['value/math', { operation: 'multiply', b: 0.5 }],
  beat: ['pulse/every', { periodS: 0.5 }],
  steps: ['value/counter', { cycle: 2 }],
};
export const SIGNAL_WIRES: readonly string[] = ['saw.seconds -> unit.a', 'beat.pulse -> steps.up'];

const height = (output: string) => ['height', output] as const;
const QUARTERS: Params = { cycle: 5, step: 0.25 };
const RED = [0.85, 0.25, 0.2, 1] as const;
const BLUE = [0.2, 0.4, 0.85, 1] as const;

/** A ring that rotates about the vertical axis, tilted toward the viewer. */
const TURNING_RING: Cell['nodes'] = {
  heading: ['value/expression', { expression: 'a * pi / 2' }],
  angles: ['value/make-vector3'],
  ring: ['objects/primitive', { shape: 'torus', sizeM: [0.9, 1.1, 0.9], color: [0.85, 0.35, 0.3, 1] }],
  turn: ['objects/transform'],
  tilt: ['objects/transform', { rotationRad: [1, 0, 0.4] }],
};
const RING_TURNS = [
  'time.seconds -> heading.a',
  'heading.result -> angles.z',
  'angles.vector -> turn.rotationRad',
  'ring.objects -> turn.objects',
  'turn.objects -> tilt.objects',
];

/** Sections of the wall; each is a subgraph. */
export const SECTIONS: readonly Section[] = [
  {
    name: 'numbers',
    title: 'Numbers',
    row: 0,
    column: 0,
    cells: [
      { title: 'Number', nodes: { number: ['value/number', { value: 0.75 }] }, wires: [], shows: height('number.number') },
      { title: 'Time', nodes: { seconds: ['value/time', { loopS: 1 }] }, wires: [], shows: height('seconds.seconds') },
      {
        title: 'Math: divide by 2',
        nodes: { math: ['value/math', { operation: 'multiply', b: 0.5 }] },
        wires: ['saw.seconds -> math.a'],
        shows: height('math.result'),
      },
      {
        title: 'Expression: a wave',
        nodes: { expression: ['value/expression', { expression: '0.5 + 0.5 * sin(a * pi)' }] },
        wires: ['time.seconds -> expression.a'],
        shows: height('expression.result'),
      },
      {
        title: 'Remap: 0 to 2 becomes 1 to 0, smoothly',
        nodes: { remap: ['value/remap', { fromHigh: 2, toLow: 1, toHigh: 0, curve: 'smooth' }] },
        wires: ['saw.seconds -> remap.number'],
        shows: height('remap.result'),
      },
      {
        title: 'Compare: greater than 1',
        nodes: { compare: ['value/compare', { b: 1 }] },
        wires: ['saw.seconds -> compare.a'],
        shows: height('compare.result'),
      },
    ],
  },
  {
    name: 'motion',
    title: 'Motion',
    row: 1,
    column: 0,
    cells: [
      {
        title: 'Noise',
        nodes: { noise: ['value/noise', { low: 0, high: 1, seed: 4 }] },
        wires: ['time.seconds -> noise.along'],
        shows: height('noise.number'),
      },
      {
        title: 'Smooth',
        nodes: { smooth: ['value/smooth', { halfLifeS: 0.1 }] },
        wires: ['steps.number -> smooth.number'],
        shows: height('smooth.result'),
      },
      {
        title: 'Spring',
        nodes: { spring: ['value/spring', { frequencyHz: 2, damping: 0.5 }] },
        wires: ['steps.number -> spring.number'],
        shows: height('spring.result'),
      },
      {
        title: 'Delay: a quarter second late',
        nodes: { delay: ['value/delay', { delayS: 0.25 }] },
        wires: ['steps.number -> delay.number'],
        shows: height('delay.result'),
      },
      {
        title: 'Delay: a loop that approaches 1',
        nodes: { before: ['value/delay'], nearer: ['value/expression', { expression: 'a + (1 - a) * 0.02' }] },
        wires: ['before.result -> nearer.a', 'nearer.result -> before.number'],
        shows: height('nearer.result'),
      },
      {
        title: 'Noise: three components',
        nodes: { noise: ['value/noise', { low: -0.4, high: 0.4, octaves: 2 }] },
        wires: ['time.seconds -> noise.along'],
        shows: ['place', 'noise.vector'],
      },
    ],
  },
  {
    name: 'vectors',
    title: 'Vectors',
    row: 2,
    column: 0,
    cells: [
      {
        title: 'Make and split vector 2',
        nodes: { make: ['value/make-vector2', { x: 9 }], split: ['value/split-vector2'] },
        wires: ['unit.result -> make.y', 'make.vector -> split.vector'],
        shows: height('split.y'),
      },
      {
        title: 'Make vector 3: a ring',
        nodes: {
          x: ['value/expression', { expression: '0.4 * sin(a * pi)' }],
          y: ['value/expression', { expression: '0.4 * cos(a * pi)' }],
          make: ['value/make-vector3'],
        },
        wires: ['time.seconds -> x.a', 'time.seconds -> y.a', 'x.result -> make.x', 'y.result -> make.y'],
        shows: ['place', 'make.vector'],
      },
      {
        title: 'Split vector 3',
        nodes: { split: ['value/split-vector3', { vector: [0, 0, 0.6] }] },
        wires: [],
        shows: height('split.z'),
      },
      {
        title: 'Make vector 4: a color',
        nodes: { make: ['value/make-vector4', { x: 0.9, y: 0.6, z: 0.1, w: 1 }] },
        wires: [],
        shows: ['color', 'make.vector'],
      },
      {
        title: 'Split vector 4: the blue of a color',
        nodes: { paint: ['value/color', { value: [...BLUE] }], split: ['value/split-vector4'] },
        wires: ['paint.color -> split.vector'],
        shows: height('split.z'),
      },
      {
        title: 'Switch vectors, with smoothing',
        nodes: {
          switch: ['value/switch-vector3', { first: [-0.3, -0.3, 0], second: [0.3, 0.3, 0] }],
          glide: ['value/smooth-vector3', { halfLifeS: 0.1 }],
        },
        wires: ['steps.number -> switch.index', 'switch.chosen -> glide.vector'],
        shows: ['place', 'glide.result'],
      },
    ],
  },
  {
    name: 'colors',
    title: 'Colors',
    row: 3,
    column: 0,
    cells: [
      { title: 'Color', nodes: { paint: ['value/color', { value: [...RED] }] }, wires: [], shows: ['color', 'paint.color'] },
      {
        title: 'Color from RGB: green comes and goes',
        nodes: { rgb: ['value/rgb-color', { red: 0.2, blue: 0.6 }] },
        wires: ['steps.number -> rgb.green'],
        shows: ['color', 'rgb.color'],
      },
      {
        title: 'Color from HSV: a rainbow',
        nodes: { turn: ['value/math', { operation: 'multiply', b: Math.PI }], hsv: ['value/hsv-color', { brightness: 0.9 }] },
        wires: ['saw.seconds -> turn.a', 'turn.result -> hsv.hueRad'],
        shows: ['color', 'hsv.color'],
      },
      {
        title: 'Mix colors',
        nodes: { mix: ['value/mix-color', { a: [...RED], b: [...BLUE] }] },
        wires: ['unit.result -> mix.amount'],
        shows: ['color', 'mix.color'],
      },
      {
        title: 'Adjust color: hue of red shifted by a third',
        nodes: { adjust: ['value/adjust-color', { base: [0.8, 0.2, 0.2, 1], hueRad: (2 * Math.PI) / 3 }] },
        wires: [],
        shows: ['color', 'adjust.color'],
      },
      {
        title: 'Split color: the brightness',
        nodes: { split: ['value/split-color', { color: [0.1, 0.35, 0.2, 1] }] },
        wires: [],
        shows: height('split.brightness'),
      },
    ],
  },
  {
    name: 'choices',
    title: 'Counters, switches and memory',
    row: 4,
    column: 0,
    cells: [
      {
        title: 'Random: a new number each interval',
        nodes: { random: ['value/random', { seed: 1 }] },
        wires: ['beat.pulse -> random.draw'],
        shows: height('random.number'),
      },
      {
        title: 'Counter: intervals, in quarters',
        nodes: { counter: ['value/counter', QUARTERS] },
        wires: ['beat.pulse -> counter.up'],
        shows: height('counter.number'),
      },
      {
        title: 'Sample & hold: the time of the last interval',
        nodes: { latch: ['value/latch'] },
        wires: ['unit.result -> latch.number', 'beat.pulse -> latch.take'],
        shows: height('latch.result'),
      },
      {
        title: 'Switch numbers: four, one after the other',
        nodes: {
          turn: ['value/counter', { cycle: 4 }],
          switch: ['value/switch-number', { first: 0.1, second: 0.9, third: 0.3, fourth: 0.7 }],
        },
        wires: ['beat.pulse -> turn.up', 'turn.number -> switch.index'],
        shows: height('switch.chosen'),
      },
      {
        title: 'Switch colors',
        nodes: { switch: ['value/switch-color', { first: [...RED], second: [...BLUE] }] },
        wires: ['steps.number -> switch.index'],
        shows: ['color', 'switch.chosen'],
      },
      {
        title: 'Toggle latch',
        nodes: { flip: ['pulse/toggle'] },
        wires: ['beat.pulse -> flip.flip'],
        shows: height('flip.on'),
      },
    ],
  },
  {
    name: 'pulses',
    title: 'Pulses',
    row: 5,
    column: 0,
    cells: [
      {
        title: 'On start: after a second',
        nodes: { start: ['pulse/on-start', { delayS: 1 }], counter: ['value/counter', QUARTERS] },
        wires: ['start.pulse -> counter.up'],
        shows: height('counter.number'),
      },
      {
        title: 'Interval: a quarter second',
        nodes: { every: ['pulse/every', { periodS: 0.25 }], counter: ['value/counter', QUARTERS] },
        wires: ['every.pulse -> counter.up'],
        shows: height('counter.number'),
      },
      {
        title: 'On change: the time wraps',
        nodes: { change: ['pulse/on-change', { direction: 'falls' }], counter: ['value/counter', QUARTERS] },
        wires: ['saw.seconds -> change.number', 'change.changed -> counter.up'],
        shows: height('counter.number'),
      },
      {
        title: 'Gate: open in every other second',
        nodes: { late: ['value/compare', { b: 1 }], gate: ['pulse/gate'], counter: ['value/counter', QUARTERS] },
        wires: ['saw.seconds -> late.a', 'late.result -> gate.open', 'beat.pulse -> gate.pulse', 'gate.passed -> counter.up'],
        shows: height('counter.number'),
      },
      {
        title: 'Tap: a quarter each',
        nodes: { tap: ['input/tap'], counter: ['value/counter', QUARTERS] },
        wires: ['tap.tapped -> counter.up'],
        shows: height('counter.number'),
      },
      {
        title: 'Controller: the stick',
        nodes: {
          gamepad: ['input/gamepad', { deadZone: 0 }],
          x: ['value/math', { operation: 'multiply', b: 0.4 }],
          y: ['value/math', { operation: 'multiply', b: 0.4 }],
          make: ['value/make-vector3'],
        },
        wires: ['gamepad.x -> x.a', 'gamepad.y -> y.a', 'x.result -> make.x', 'y.result -> make.y'],
        shows: ['place', 'make.vector'],
      },
    ],
  },
  {
    name: 'controls',
    title: 'Controls on screen',
    row: 6,
    column: 0,
    cells: [
      {
        title: 'Slider',
        nodes: { slider: ['input/slider', { label: 'Height', place: 1 }] },
        wires: [],
        shows: height('slider.number'),
      },
      {
        title: 'Toggle',
        nodes: { toggle: ['input/toggle', { label: 'Up', place: 2 }] },
        wires: [],
        shows: height('toggle.on'),
      },
      {
        title: 'Button: a quarter each',
        nodes: { button: ['input/button', { label: 'One more', place: 3 }], counter: ['value/counter', QUARTERS] },
        wires: ['button.pressed -> counter.up'],
        shows: height('counter.number'),
      },
      {
        title: 'Choice',
        nodes: {
          choice: ['input/choice', { label: 'Where', options: 'Low, Middle, High', place: 4 }],
          switch: ['value/switch-number', { first: 0.1, second: 0.5, third: 0.9 }],
        },
        wires: ['choice.index -> switch.index'],
        shows: height('switch.chosen'),
      },
    ],
  },
  {
    name: 'techniques',
    title: 'Techniques',
    row: 6,
    column: 4,
    cells: [
      {
        title: 'Set material: Gooch’s cool and warm tones',
        nodes: { ...TURNING_RING, style: ['technique/gooch'], apply: ['objects/apply-technique'] },
        wires: [...RING_TURNS, 'tilt.objects -> apply.objects', 'style.technique -> apply.technique'],
        shows: ['things', 'apply.objects'],
      },
      {
        title: 'Set material: a cartoon',
        nodes: { ...TURNING_RING, style: ['technique/toon', { outlinePx: 2 }], apply: ['objects/apply-technique'] },
        wires: [...RING_TURNS, 'tilt.objects -> apply.objects', 'style.technique -> apply.technique'],
        shows: ['things', 'apply.objects'],
      },
    ],
  },
];
