import { defineNode } from '../../kit/definition.ts';
import { POSITION_PARAM, ROTATION_PARAM, SCALE_PARAM } from '../../kit/pose-params.ts';
import { SURFACE_CASTS_SHADOW, SURFACE_CATCHES_SHADOW } from '../../kit/surface-params.ts';

export const definition = defineNode({
  type: 'source/capture-mesh',
  version: 1,
  title: 'Capture mesh',
  doc: 'Outputs the mesh of a captured place as a phantom: it hides virtual objects that are behind the captured ones, and receives their shadows. Put the layers of Scene and Shadow over that of the Capture node that is connected, or of one that has the same file, position, rotation and scale.',
  keywords: ['proxy', 'occlusion', 'shadow catcher', 'phantom', 'photogrammetry', 'scan', 'room', 'place'],
  inputs: {
    capture: {
      type: 'capture',
      label: 'Capture',
      doc: 'The captured place, from a Capture node: the mesh moves with it. Optional. Without it, the node has a file, position, rotation and scale of its own.',
      required: false,
      replaces: ['file', 'positionM', 'rotationRad', 'scale'],
    },
  },
  outputs: {
    objects: {
      type: 'objects',
      label: 'Phantom',
      doc: 'The mesh; nothing while it loads. Connect it to a Scene node to hide what is behind it, and to “Receivers” of a Shadow node to show shadows on it.',
    },
  },
  params: {
    file: { type: 'asset', stage: 'asset', label: 'Capture', doc: 'The capture.', default: '', accept: 'capture' },
    positionM: POSITION_PARAM,
    rotationRad: { ...ROTATION_PARAM, handle: 'rotation' },
    scale: { ...SCALE_PARAM, doc: 'Uniform scale factor, as that of the Capture node.' },
    receiveShadow: SURFACE_CATCHES_SHADOW,
    castShadow: SURFACE_CASTS_SHADOW,
  },
  lowering: { kind: 'source' },
});
