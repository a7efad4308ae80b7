import type { SoundOutput } from '../../../nodes/kit/sound.ts';
import { MAX_CHANNELS } from '../../program/texture-sizes.ts';
import { allocateTexture } from '../gl/allocate-texture.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { prepareUpload } from '../gl/upload.ts';
import { createSpectrum, type Spectrum } from './spectrum.ts';

export type SoundAnalysis = 'waveform' | 'spectrum';

/** The most recent sound as a texture (ISF `audio` and `audioFFT`): one row per channel, in the red channel. */
export interface SoundTexture {
  /** A texture of half floats, filtered linearly. */
  readonly texture: WebGLTexture;
  readonly widthPx: number;
  /** Number of channels; 1 for silence. */
  readonly heightPx: number;
  /** Updates the texture if the sound changed. Call it outside of a pass. */
  update(): void;
  dispose(): void;
}

/**
 * Creates the texture for an analysis. `waveform`: the last `count` samples, oldest first, around 0.5. `spectrum`: the amplitude in `count`
 * equal bands from 0 Hz to half the sample rate; if `count` is not a power of two, each band has the maximum of its bins.
 */
export function createSoundTexture(objects: GlObjects, sound: SoundOutput, analysis: SoundAnalysis, count: number): SoundTexture {
  const { gl } = objects;
  const texture = allocateTexture(gl, objects.createTexture(), gl.R16F, gl.LINEAR, count, MAX_CHANNELS);
  const row = new Float32Array(count);
  const writeRow = analysis === 'waveform' ? writeWaveform : createSpectrumRows(count);
  let version = -1;
  let heightPx = 1;

  function upload(channel: number): void {
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, channel, count, 1, gl.RED, gl.FLOAT, row);
  }

  return {
    texture,
    widthPx: count,
    get heightPx() {
      return heightPx;
    },
    update: () => {
      if (version === sound.version) return;
      version = sound.version;
      heightPx = Math.max(1, sound.channelCount);
      prepareUpload(gl, 4);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      for (let channel = 0; channel < MAX_CHANNELS; channel++) {
        // A single channel fills both rows, so that shaders may read either.
        const samples = sound.samples[Math.min(channel, heightPx - 1)];
        if (sound.channelCount > 0 && samples) writeRow(samples, row);
        else row.fill(analysis === 'waveform' ? 0.5 : 0);
        upload(channel);
      }
    },
    dispose: () => objects.deleteTexture(texture),
  };
}

function writeWaveform(samples: Float32Array, row: Float32Array): void {
  const first = samples.length - row.length;
  for (let i = 0; i < row.length; i++) row[i] = 0.5 + 0.5 * (samples[first + i] ?? 0);
}

function createSpectrumRows(count: number): (samples: Float32Array, row: Float32Array) => void {
  const bins = new Float32Array(2 ** Math.ceil(Math.log2(Math.max(count, MIN_BINS))));
  const spectrum: Spectrum = createSpectrum(bins.length);
  return (samples, row) => {
    spectrum.measure(samples, bins);
    for (let i = 0; i < count; i++) {
      const from = Math.floor((i * bins.length) / count);
      const to = Math.max(from + 1, Math.floor(((i + 1) * bins.length) / count));
      let loudest = 0;
      for (let bin = from; bin < to; bin++) loudest = Math.max(loudest, bins[bin] ?? 0);
      row[i] = loudest;
    }
  };
}

/** Minimum number of bins of the transform. With fewer, its window would be too short for low tones. */
const MIN_BINS = 256;
