import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/device-motion',
  version: 1,
  title: 'Device motion',
  doc: 'Tells how a phone or tablet is tilted, turned and shaken, along the axes of its screen: x to the right, y up, z to the visitor. iPhones ask the visitor for permission at the first tap, and only if a node uses the motion. Without permission or sensor, the node says so and outputs a device that is held upright and still.',
  keywords: ['accelerometer', 'gyroscope', 'tilt', 'shake', 'acceleration', 'rotation rate', 'sensor', 'phone', 'gravity', 'level', 'imu'],
  inputs: {},
  outputs: {
    acceleration: { type: 'vector3', label: 'Acceleration', doc: 'Of the device without gravity, in m/s².' },
    rotationRate: {
      type: 'vector3',
      label: 'Rotation rate',
      doc: 'How fast it turns about each axis, in radians per second, counterclockwise seen from the tip of the axis.',
    },
    tilt: {
      type: 'vector2',
      label: 'Tilt',
      doc: 'How far it leans, in radians. x: its right edge is lower than its left. y: it leans back; 0 is upright, π/2 lies on a table with the screen up.',
    },
    up: { type: 'vector3', label: 'Up', doc: 'The direction away from the ground, a unit vector. (0, 1, 0) is upright.' },
    shaken: {
      type: 'pulse',
      label: 'Shaken',
      doc: 'A pulse when the device is shaken: three strong accelerations, each against the one before, within a second. Its number is the strongest one, in m/s².',
    },
    available: { type: 'toggle', label: 'Available', doc: 'On once the sensor has given a reading.' },
  },
  params: {
    smoothingS: {
      type: 'number',
      stage: 'uniform',
      label: 'Smoothing',
      doc: 'Time constant of the smoothing of all outputs but “Shaken”. 0 smooths nothing.',
      default: 0.1,
      min: 0,
      max: 5,
      step: 0.01,
      unit: 's',
    },
    shakeMPerS2: {
      type: 'number',
      stage: 'uniform',
      label: 'Shake from',
      doc: 'Acceleration from which a movement counts as shaking, in m/s².',
      default: 12,
      min: 1,
      max: 60,
      step: 0.5,
    },
  },
  lowering: { kind: 'value' },
  needs: [
    {
      capability: 'motion',
      required: false,
      when: 'always',
      why: 'to react to how the device is moved',
      without: 'Effects that react to motion behave as if the device were held still.',
    },
  ],
});
