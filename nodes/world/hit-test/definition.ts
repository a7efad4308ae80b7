import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'world/hit-test',
  version: 1,
  title: 'Hit test',
  doc: 'Finds where a ray meets the real room, as a pose on the surface: y is the normal; on floors z points to the visitor, on walls z points down. The first of these that has an answer is used: the hit test of the device, detected planes, detected meshes, room depth, the voxels of a physics room, the floor.',
  keywords: ['raycast', 'ray', 'surface', 'reticle', 'place', 'tap to place', 'floor', 'wall', 'plane', 'point', 'cursor'],
  inputs: {
    ray: {
      type: 'pose',
      label: 'Ray',
      doc: 'With “From” at “The connected ray”: the ray, which starts at the pose, along -z. The device’s own hit test does not follow it. Without a wire nothing is hit.',
      required: false,
    },
  },
  outputs: {
    pose: { type: 'pose', label: 'Pose', doc: 'The point that is hit, with the axes of the surface. Invalid while nothing is hit.' },
    hit: { type: 'toggle', label: 'Hit', doc: 'On while something is hit.' },
    distanceM: { type: 'number', label: 'Distance', doc: 'From the start of the ray to the surface, in meters. 0 while nothing is hit.' },
    orientation: {
      type: 'text',
      label: 'Kind of surface',
      doc: '“floor” for surfaces that face up within 20°, tables too; “wall”, “ceiling” or “sloped” for others; empty while nothing is hit.',
    },
    label: {
      type: 'text',
      label: 'Label',
      doc: 'What the device calls the surface, such as “floor”, “wall” or “table”, where a detected plane or mesh answered; otherwise empty.',
    },
    source: {
      type: 'text',
      label: 'Source',
      doc: 'What answered: “session” (the device), “plane”, “mesh”, “depth”, “voxels” (of a physics room) or “floor”; empty while nothing is hit.',
    },
  },
  params: {
    from: {
      type: 'choice',
      stage: 'structure',
      label: 'From',
      doc: 'Where the ray starts. AR on a device answers by its own hit test, then as all others do: by planes and meshes that it detects, by room depth, by the voxels of a physics room, by the floor. Only what other nodes of the graph ask of the device is there. A recording answers by its planes, its depth and the floor at y = 0; a camera page by an assumed floor 1.5 m below the eyes; a page without AR by the floor at y = 0.',
      default: 'center',
      options: [
        { value: 'center', label: 'The center of the view' },
        { value: 'pointers', label: 'Fingers, mouse, controllers and hands' },
        { value: 'left', label: 'Left controller or hand' },
        { value: 'right', label: 'Right controller or hand' },
        { value: 'ray', label: 'The connected ray' },
      ],
    },
    smoothingS: {
      type: 'number',
      stage: 'uniform',
      label: 'Smoothing',
      doc: 'Filters the pose by a One Euro filter, so that it rests while the view rests: its time constant at rest, which is 1 / (2 π · the published minimum cutoff). 0.16 is 1 Hz; 0: no filter. The filter begins anew at re-centering, and where another pointer or nothing was hit before. Distance and kind of surface are not filtered.',
      default: 0,
      min: 0,
      max: 10,
      step: 0.01,
      unit: 's',
    },
    beta: {
      type: 'number',
      stage: 'uniform',
      label: 'Speed coefficient',
      doc: 'The beta of the One Euro filter: by how many hertz its cutoff rises per meter, or radian, per second. Higher lags less in fast motions.',
      default: 5,
      min: 0,
      max: 100,
      step: 0.1,
    },
  },
  readsInput: true,
  lowering: { kind: 'value' },
  stateful: { param: 'smoothingS', above: 0 },
  needs: [
    {
      capability: 'hit-test',
      required: false,
      when: 'always',
      why: 'to find floors, tables and walls to place things on',
      without: 'Rays meet detected planes, room depth or an assumed floor instead of the surfaces that the device finds.',
    },
  ],
});
