import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/audio-file',
  version: 1,
  title: 'Audio file',
  doc: 'Plays a sound file and outputs its audio for effects that react to sound. Browsers start audible playback only after the visitor has tapped or clicked the page; until then the sound is silent but advances. Connect “Level” to any parameter that should follow the loudness.',
  keywords: ['sound', 'music', 'song', 'mp3', 'wav', 'ogg', 'spectrum', 'fft', 'waveform', 'beat', 'level'],
  inputs: {},
  outputs: {
    audio: { type: 'audio', label: 'Audio', doc: 'The sound at this moment; silence until the file has loaded.' },
    level: { type: 'number', label: 'Level', doc: 'Loudness at this moment, from 0 to 1: the root mean square of the last 21 ms.' },
  },
  params: {
    file: { type: 'asset', stage: 'asset', label: 'File', doc: 'The sound file.', default: '', accept: 'audio' },
    playing: { type: 'toggle', stage: 'uniform', label: 'Playing', doc: 'Off pauses the sound; on resumes it.', default: true },
    loop: { type: 'toggle', stage: 'uniform', label: 'Loop', doc: 'Whether playback restarts at the end.', default: true },
    volume: {
      type: 'number',
      stage: 'uniform',
      label: 'Volume',
      doc: 'Volume of the speakers. It does not affect the outputs.',
      default: 1,
      min: 0,
      max: 1,
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
  stateful: { moves: ['playing'] },
});
