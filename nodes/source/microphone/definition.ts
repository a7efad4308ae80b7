import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/microphone',
  version: 1,
  title: 'Microphone',
  doc: 'Outputs the sound of the microphone, for effects that react to sound. The visitor is asked for permission after the first tap, and only if a node uses the sound. Without permission the output is silence. Nothing is recorded or sent.',
  keywords: ['sound', 'voice', 'listen', 'mic', 'spectrum', 'fft', 'waveform', 'level', 'music'],
  inputs: {},
  outputs: {
    audio: { type: 'audio', label: 'Audio', doc: 'The sound at this moment; silence until the visitor gives permission.' },
    level: { type: 'number', label: 'Level', doc: 'Loudness at this moment, from 0 to 1: the root mean square of the last 21 ms.' },
  },
  params: {
    gain: {
      type: 'number',
      stage: 'uniform',
      label: 'Gain',
      doc: 'Factor on the amplitude of the sound.',
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
      why: 'to make effects react to sound',
      without: 'Effects that react to sound behave as in silence.',
    },
  ],
});
