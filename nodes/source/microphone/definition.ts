import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/microphone',
  version: 1,
  title: 'Microphone',
  doc: 'What the microphone hears, for shaders that look at sound. The visitor is asked once the page is touched, and only where something looks at it; who refuses has silence, and the rest of the picture. Nothing is recorded or sent anywhere.',
  keywords: ['sound', 'voice', 'listen', 'mic', 'spectrum', 'fft', 'waveform', 'level', 'music'],
  inputs: {},
  outputs: {
    audio: { type: 'audio', label: 'Audio', doc: 'What is heard now; silence until the visitor allows it.' },
    level: { type: 'number', label: 'Level', doc: 'How loud it is just now, from 0 to 1: the root mean square of the last 21 ms.' },
  },
  params: {
    gain: {
      type: 'number',
      stage: 'uniform',
      label: 'Gain',
      doc: 'Factor on what is heard.',
      default: 1,
      min: 0,
      max: 8,
      step: 0.01,
      unit: 'ratio',
    },
  },
  lowering: { kind: 'source' },
  needs: [
    {
      capability: 'microphone',
      required: false,
      when: 'always',
      why: 'to let the picture follow what is heard',
      without: 'The picture moves as in silence.',
    },
  ],
});
