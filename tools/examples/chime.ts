/** A second of three tones with decreasing volume: a small sound with a visible spectrum. */
const TONES = [
  { frequencyHz: 440, amplitude: 0.5 },
  { frequencyHz: 880, amplitude: 0.25 },
  { frequencyHz: 1760, amplitude: 0.125 },
] as const;

const SAMPLE_RATE_HZ = 8_000;

/** A WAVE file of 8-bit samples (Microsoft, "Multimedia Programming Interface and Data Specifications 1.0", 1991). */
export function makeChime(): Uint8Array<ArrayBuffer> {
  const samples = Uint8Array.from({ length: SAMPLE_RATE_HZ }, (_, i) => {
    const sum = TONES.reduce(
      (all, { frequencyHz, amplitude }) => all + amplitude * Math.sin((2 * Math.PI * frequencyHz * i) / SAMPLE_RATE_HZ),
      0,
    );
    return Math.round(128 + 127 * sum);
  });
  const file = new Uint8Array(44 + samples.length);
  const view = new DataView(file.buffer);
  const word = (offset: number, text: string): void => {
    for (let i = 0; i < text.length; i++) file[offset + i] = text.charCodeAt(i);
  };
  word(0, 'RIFF');
  view.setUint32(4, 36 + samples.length, true);
  word(8, 'WAVEfmt ');
  view.setUint32(16, 16, true);
  // Plain samples, one channel, 8 bits.
  view.setUint16(20, 1, true);
  view.setUint16(22, 1, true);
  view.setUint32(24, SAMPLE_RATE_HZ, true);
  view.setUint32(28, SAMPLE_RATE_HZ, true);
  view.setUint16(32, 1, true);
  view.setUint16(34, 8, true);
  word(36, 'data');
  view.setUint32(40, samples.length, true);
  file.set(samples, 44);
  return file;
}
