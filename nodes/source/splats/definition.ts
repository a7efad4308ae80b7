import { defineNode } from '../../kit/definition.ts';
import { POSITION_PARAM, ROTATION_PARAM, SCALE_PARAM } from '../../kit/pose-params.ts';

export const definition = defineNode({
  type: 'source/splats',
  version: 1,
  title: 'Splats',
  doc: 'Draws Gaussian splats: a place or an object that was trained from photographs. The layer has depth, and a depth occlusion after the node hides each splat behind real surfaces. Drop a PLY file as the training writes it, or a SOG file; a page gets the splats in a packed form.',
  keywords: ['gaussian splatting', '3dgs', 'radiance field', 'ply', 'sog', 'photogrammetry', 'scan', 'place'],
  inputs: {},
  outputs: {
    layer: {
      type: 'layer',
      label: 'Layer',
      doc: 'The splats over transparency; nothing while they load. Where they cover at least half of a pixel, it has depth.',
      domain: 'view',
      depth: true,
    },
  },
  params: {
    file: { type: 'asset', stage: 'asset', label: 'File', doc: 'The splats.', default: '', accept: 'splats' },
    up: {
      type: 'choice',
      stage: 'structure',
      label: 'Up in the file',
      doc: 'The axis of the file that points up. Training after COLMAP gives −y; editors may turn a file.',
      default: '-y',
      options: [
        { value: '-y', label: '−y' },
        { value: 'y', label: 'y' },
        { value: 'z', label: 'z' },
      ],
    },
    antialiased: {
      type: 'toggle',
      stage: 'structure',
      label: 'Trained antialiased',
      doc: 'For splats that were trained with antialiasing: small splats become fainter instead of larger. SOG files say it themselves.',
      default: false,
    },
    positionM: POSITION_PARAM,
    rotationRad: { ...ROTATION_PARAM, handle: 'rotation' },
    scale: { ...SCALE_PARAM, doc: 'Meters per unit of the file.' },
  },
  worker: true,
  lowering: { kind: 'geometry', ownDrawing: { hidesBehindRoom: true, blends: true } },
});
