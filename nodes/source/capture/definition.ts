import { defineNode } from '../../kit/definition.ts';
import { POSITION_PARAM, ROTATION_PARAM, SCALE_PARAM } from '../../kit/pose-params.ts';

export const definition = defineNode({
  type: 'source/capture',
  version: 2,
  title: 'Capture',
  doc: 'Draws a captured place: photographs projected on the mesh of what they show, so that one can walk around in it. `scrim import capture` makes the asset from a folder of photographs with cameras and a mesh. The layer has depth, so virtual objects stand in the place.',
  keywords: ['photogrammetry', 'image-based rendering', 'lumigraph', 'colmap', 'scan', 'photographs', 'room', 'place'],
  inputs: {},
  outputs: {
    layer: {
      type: 'layer',
      label: 'Layer',
      doc: 'The place, transparent where its mesh is not; nothing while it loads.',
      domain: 'view',
      depth: true,
    },
    capture: {
      type: 'capture',
      label: 'Capture',
      doc: 'The place for other nodes, as Capture mesh: its file, position, rotation and scale. It does not depend on the method, and needs no layer that is shown.',
      whenRead: true,
      part: 'part/capture-place',
    },
  },
  params: {
    file: {
      type: 'asset',
      stage: 'asset',
      label: 'Capture',
      doc: 'The capture.',
      default: '',
      accept: 'capture',
      depthMeshes: { param: 'method', is: 'depth-meshes' },
    },
    method: {
      type: 'choice',
      stage: 'structure',
      label: 'Method',
      doc: 'Lumigraph: each pixel shows the photographs that saw it from nearly the same direction, so highlights move. Depth meshes: as the lumigraph, but each photograph is drawn on the depth that its own camera saw, which is sharper at edges; 360° photographs, too. Nearest: each pixel shows the photograph that was taken nearest to the eye and sees it. Plain: the mesh in the mean colors of the photographs, the fastest.',
      default: 'lumigraph',
      options: [
        { value: 'plain', label: 'Plain' },
        { value: 'nearest', label: 'Nearest' },
        { value: 'lumigraph', label: 'Lumigraph' },
        { value: 'depth-meshes', label: 'Depth meshes' },
      ],
    },
    blended: {
      type: 'number',
      stage: 'structure',
      label: 'Photographs per pixel',
      doc: 'How many photographs a pixel blends (lumigraph). More hide seams, fewer are sharper.',
      default: 2,
      min: 1,
      max: 4,
      step: 1,
      unit: 'none',
    },
    updateFrames: {
      type: 'number',
      stage: 'structure',
      label: 'Frames per update',
      doc: 'For slow devices and fine meshes (lumigraph). 0: each pixel chooses its photographs, in each frame. Above 0: each vertex of the mesh does, and keeps its choice; all choose again within so many frames while the eye moves, and none while it rests. Renders wait for all.',
      default: 0,
      min: 0,
      max: 60,
      step: 1,
      unit: 'none',
    },
    positionM: POSITION_PARAM,
    rotationRad: { ...ROTATION_PARAM, handle: 'rotation' },
    scale: { ...SCALE_PARAM, doc: 'Uniform scale factor, if the capture was imported without its true size.' },
  },
  // Version 1 had no “Frames per update”.
  migrations: [(params) => params],
  lowering: { kind: 'geometry', ownDrawing: {} },
});
