import type { SoundOutput } from '../../kit/sound.ts';

/** The visitor's microphone. It is requested at the first gesture and released by `dispose`. */
export interface Ear {
  /** Writes the newest samples to the output; returns false while there are none. */
  hear(output: SoundOutput, gain: number): boolean;
  dispose(): void;
}

interface Microphone {
  readonly stream: MediaStream;
  readonly context: AudioContext;
  /** The analysers that collect the samples, one per channel. */
  readonly analysers: readonly AnalyserNode[];
}

/** The requested settings of the microphone. Voice processing is off, because it suppresses music. */
const WISHES: MediaTrackConstraints = { echoCancellation: false, noiseSuppression: false, autoGainControl: false };

const GESTURES = ['pointerup', 'keyup'] as const;

/**
 * Prepares the microphone.
 *
 * @param onRefusal Called once if the microphone is not available, with sentences for the visitor.
 */
export function listen(onRefusal: (message: string, fix: string) => void): Ear {
  let microphone: Microphone | null = null;
  let asked = false;
  let disposed = false;

  function ask(): void {
    if (asked) {
      void microphone?.context.resume().catch(() => {});
      return;
    }
    asked = true;
    void open();
  }

  async function open(): Promise<void> {
    // Undefined without HTTPS, and in some browsers for pages from a disk.
    const media: MediaDevices | undefined = navigator.mediaDevices;
    if (!media) {
      onRefusal('The microphone is not available: the page was not loaded over HTTPS.', 'Open the page over HTTPS.');
      return;
    }
    try {
      const stream = await media.getUserMedia({ audio: WISHES });
      if (disposed) stop(stream);
      else microphone = connect(stream);
    } catch (error) {
      if (!disposed) onRefusal(...refusal(error));
    }
  }

  for (const gesture of GESTURES) document.addEventListener(gesture, ask);
  // The gesture that entered AR may have happened before these listeners existed.
  if (navigator.userActivation?.hasBeenActive) ask();

  return {
    hear: (output, gain) => {
      if (microphone === null || microphone.context.state !== 'running') return false;
      const { analysers, context } = microphone;
      for (let channel = 0; channel < analysers.length; channel++) {
        const samples = output.samples[channel] as Float32Array<ArrayBuffer> | undefined;
        if (!samples) continue;
        analysers[channel]?.getFloatTimeDomainData(samples);
        if (gain !== 1) for (let i = 0; i < samples.length; i++) samples[i] = (samples[i] ?? 0) * gain;
      }
      output.channelCount = analysers.length;
      output.sampleRateHz = context.sampleRate;
      output.version++;
      return true;
    },
    dispose: () => {
      disposed = true;
      for (const gesture of GESTURES) document.removeEventListener(gesture, ask);
      if (microphone === null) return;
      stop(microphone.stream);
      void microphone.context.close();
      microphone = null;
    },
  };
}

function connect(stream: MediaStream): Microphone {
  const context = new AudioContext();
  const source = context.createMediaStreamSource(stream);
  const channelCount = Math.min(stream.getAudioTracks()[0]?.getSettings().channelCount ?? 1, 2);
  const splitter = context.createChannelSplitter(channelCount);
  source.connect(splitter);
  const analysers = Array.from({ length: channelCount }, (_, channel) => {
    // The length of the window of `SoundOutput`.
    const analyser = new AnalyserNode(context, { fftSize: 4096 });
    splitter.connect(analyser, channel);
    return analyser;
  });
  void context.resume().catch(() => {});
  return { stream, context, analysers };
}

function stop(stream: MediaStream): void {
  for (const track of stream.getTracks()) track.stop();
}

function refusal(error: unknown): [message: string, fix: string] {
  const name = error instanceof DOMException ? error.name : '';
  if (name === 'NotAllowedError' || name === 'SecurityError')
    return ['The microphone was not allowed.', 'Allow it beside the address bar, then reload the page.'];
  if (name === 'NotFoundError') return ['No microphone was found.', 'Connect one, then reload the page.'];
  return ['The microphone is not available.', 'Close other apps that use it, then reload the page.'];
}
