import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/video-file',
  version: 1,
  title: 'Video file',
  doc: 'A video from a file, in its own size, silent, starting by itself. MP4 with H.264 and WebM with VP9 play everywhere; WebM can be transparent, for stickers or smoke. Where it meets the view, the node that brings them together says how it fits.',
  keywords: ['movie', 'clip', 'film', 'mp4', 'webm', 'alpha', 'sticker', 'overlay', 'footage'],
  inputs: {},
  outputs: {
    layer: {
      type: 'layer',
      label: 'Layer',
      doc: 'The video, transparent until its first picture is there.',
      domain: 'image',
      depth: false,
    },
  },
  params: {
    file: { type: 'asset', stage: 'asset', label: 'File', doc: 'The video to show.', default: '', accept: 'video' },
    playing: { type: 'toggle', stage: 'uniform', label: 'Playing', doc: 'Off holds the video where it is.', default: true },
    loop: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Loop',
      doc: 'Whether it starts over at its end. Off holds its last picture.',
      default: true,
    },
    speed: {
      type: 'number',
      stage: 'uniform',
      label: 'Speed',
      doc: 'How fast it plays: 1 as filmed.',
      default: 1,
      min: 0,
      max: 4,
      step: 0.01,
      unit: 'ratio',
    },
    startS: {
      type: 'number',
      stage: 'uniform',
      label: 'Start at',
      doc: 'The moment of the video that it begins with.',
      default: 0,
      min: 0,
      step: 0.1,
      unit: 's',
    },
  },
  lowering: { kind: 'source' },
  stateful: { moves: ['playing', 'speed'] },
});
