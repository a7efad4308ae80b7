/**
 * The shape of a port on the canvas. Each wire type has a color and a shape, so that ports can be distinguished without color vision;
 * only types that convert into each other share a shape.
 */
export type PortShape = 'circle' | 'square' | 'diamond' | 'triangle' | 'hexagon' | 'star' | 'cross' | 'pill' | 'ring' | 'half';

/** How the canvas and the docs show a wire type. */
export interface WireTypeInfo {
  readonly label: string;
  /** What a wire of the type carries, with units and spaces. */
  readonly doc: string;
  /** sRGB hex, chosen for a contrast of at least 3:1 on the canvas in both themes. */
  readonly color: `#${string}`;
  readonly shape: PortShape;
}

/** All wire types. */
export const WIRE_TYPES = {
  layer: {
    label: 'Layer',
    doc: 'A rendered image with optional depth in positive view-space meters. A display layer is premultiplied display-referred sRGB; a scene layer, drawn as a double wire, is linear and unclamped.',
    color: '#4f9dde',
    shape: 'square',
  },
  depth: {
    label: 'Room depth',
    doc: 'Distance to the real world along the view axis, meters, per view, with its own pose and UV transform.',
    color: '#7c8db5',
    shape: 'half',
  },
  objects: { label: 'Objects', doc: 'Placed 3D objects and phantoms, in world space, meters.', color: '#d9822b', shape: 'hexagon' },
  technique: { label: 'Material', doc: 'A custom material that draws objects.', color: '#c2569b', shape: 'star' },
  lights: { label: 'Lights', doc: 'Virtual lights in world space; colors linear-sRGB.', color: '#c9a400', shape: 'triangle' },
  environment: {
    label: 'Environment',
    doc: 'A panorama or cube map that lights the scene, linear-sRGB radiance.',
    color: '#3fa796',
    shape: 'ring',
  },
  surfaces: {
    label: 'Detected surfaces',
    doc: 'Planes and meshes that the session detected, world space, meters.',
    color: '#8a7a5c',
    shape: 'cross',
  },
  pose: {
    label: 'Pose',
    doc: 'A position and rotation in world space, meters, without scale. It can be invalid, as when a ray hits nothing.',
    color: '#9a6dd7',
    shape: 'diamond',
  },
  body: { label: 'Body', doc: 'A physics body, meters, kilograms, seconds.', color: '#a0522d', shape: 'pill' },
  capture: {
    label: 'Capture',
    doc: 'A captured place: its file, the cameras and the mesh of its photographs, which of them have loaded, and its pose and scale in world space, meters.',
    color: '#5f7f3f',
    shape: 'cross',
  },
  audio: { label: 'Audio', doc: 'Waveform and spectrum of a sound.', color: '#2f8f5b', shape: 'ring' },
  number: { label: 'Number', doc: 'One real number; its unit is named at the port.', color: '#8f98a3', shape: 'circle' },
  vector2: { label: 'Vector 2', doc: 'Two real numbers.', color: '#6f7fd1', shape: 'circle' },
  vector3: { label: 'Vector 3', doc: 'Three real numbers.', color: '#6a5fcb', shape: 'circle' },
  vector4: { label: 'Vector 4', doc: 'Four real numbers.', color: '#5a49b8', shape: 'circle' },
  color: { label: 'Color', doc: 'Display-referred sRGB with straight alpha, each channel in [0, 1].', color: '#d1567a', shape: 'circle' },
  toggle: { label: 'Toggle', doc: 'On or off.', color: '#4aa564', shape: 'pill' },
  text: { label: 'Text', doc: 'A string.', color: '#b08d57', shape: 'half' },
  pulse: { label: 'Pulse', doc: 'Events of this frame, each with a payload.', color: '#e0533d', shape: 'diamond' },
} as const satisfies Record<string, WireTypeInfo>;

/** The type of a wire and of a port. */
export type WireType = keyof typeof WIRE_TYPES;

/** The types of params that shaders read from a texture. */
export type TableType = 'curve' | 'gradient';

/** Wire types that carry plain values; they are stored in value slots and can be bound to params. */
export type ValueType = 'number' | 'vector2' | 'vector3' | 'vector4' | 'color' | 'toggle' | 'text';

/** The number of slots that a value of each type takes in the program; a text takes one entry of the text table instead. */
export const VALUE_SIZES = {
  number: 1,
  vector2: 2,
  vector3: 3,
  vector4: 4,
  color: 4,
  toggle: 1,
  text: 1,
} as const satisfies Record<ValueType, number>;

/**
 * Implicit conversions, all lossless: a toggle is 0 or 1; a color and a vector4 have the same four numbers. The canvas draws such a wire
 * as a gradient of both colors.
 */
const LOSSLESS: Readonly<Partial<Record<WireType, readonly WireType[]>>> = {
  toggle: ['number'],
  color: ['vector4'],
  vector4: ['color'],
};

/** How a wire converts from one type to another; `none`: the ports cannot be connected. */
export type Conversion = 'same' | 'lossless' | 'none';

/**
 * The conversion of a wire between two types.
 *
 * @param from Type of the output.
 * @param to Type of the input.
 *
 * @example
 * conversion('toggle', 'number'); // 'lossless'
 */
export function conversion(from: WireType, to: WireType): Conversion {
  if (from === to) return 'same';
  return LOSSLESS[from]?.includes(to) ? 'lossless' : 'none';
}

/**
 * Whether a name is a wire type.
 *
 * @example
 * isWireType('layer'); // true
 */
export function isWireType(name: string): name is WireType {
  return Object.hasOwn(WIRE_TYPES, name);
}

/**
 * Whether a wire type carries a plain value.
 *
 * @example
 * isValueType('color'); // true
 */
export function isValueType(type: WireType): type is ValueType {
  return Object.hasOwn(VALUE_SIZES, type);
}
