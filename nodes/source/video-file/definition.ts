import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/video-file',
  version: 1,
  title: 'Video file',
  doc: 'Plays a video file without sound, at its own size, and starts automatically. MP4 with H.264 and WebM with VP9 play on all supported browsers; WebM can have an alpha channel. The node that combines the video with a view scales it to cover the view.',
  keywords: ['movie', 'clip', 'film', 'mp4', 'webm', 'alpha', 'sticker', 'overlay', 'footage'],
  inputs: {},
  outputs: {
    layer: {
      type: 'layer',
      label: 'Layer',
      doc: 'The video; transparent until its first frame has loaded.',
      domain: 'image',
      depth: false,
    },
  },
  params: {
    file: { type: 'asset', stage: 'asset', label: 'File', doc: 'The video file.', default: '', accept: 'video' },
    playing: { type: 'toggle', stage: 'uniform', label: 'Playing', doc: 'Off pauses the video.', default: true },
    loop: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Loop',
      doc: 'Whether playback restarts at the end. Off holds the last frame.',
      default: true,
    },
    speed: {
      type: 'number',
      stage: 'uniform',
      label: 'Speed',
      doc: 'Playback speed: 1 is normal.',
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
      doc: 'Position in the file at which playback starts, in seconds.',
      default: 0,
      min: 0,
      step: 0.1,
      unit: 's',
    },
  },
  lowering: { kind: 'source' },
  stateful: { moves: ['playing', 'speed'] },
});
