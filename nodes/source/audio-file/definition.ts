import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/audio-file',
  version: 1,
  title: 'Audio file',
  doc: 'A sound from a file, for shaders that look at sound, and to be heard. Browsers play nothing before the page is touched: until then it runs on unheard. Level follows how loud it is, for any param.',
  keywords: ['sound', 'music', 'song', 'mp3', 'wav', 'ogg', 'spectrum', 'fft', 'waveform', 'beat', 'level'],
  inputs: {},
  outputs: {
    audio: { type: 'audio', label: 'Audio', doc: 'What is played now; silence until the file is there.' },
    level: { type: 'number', label: 'Level', doc: 'How loud it is just now, from 0 to 1: the root mean square of the last 21 ms.' },
  },
  params: {
    file: { type: 'asset', stage: 'asset', label: 'File', doc: 'The sound to play.', default: '', accept: 'audio' },
    playing: { type: 'toggle', stage: 'uniform', label: 'Playing', doc: 'Off is silence; on goes on where it was.', default: true },
    loop: { type: 'toggle', stage: 'uniform', label: 'Loop', doc: 'Whether it starts over at its end.', default: true },
    volume: {
      type: 'number',
      stage: 'uniform',
      label: 'Volume',
      doc: 'How loud it is heard. Shaders and Level see the sound as it is in the file.',
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
      doc: 'The moment of the sound that it begins with.',
      default: 0,
      min: 0,
      step: 0.1,
      unit: 's',
    },
  },
  lowering: { kind: 'source' },
  stateful: { moves: ['playing'] },
});
