import { join, resolve } from 'node:path';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { LIBRARY } from '../../services/compile-project.ts';
import { refusal } from '../../services/file-errors.ts';
import { readText } from '../../services/read-file.ts';
import { MAX_SESSION_BYTES } from '../../services/session-list.ts';
import { type Call, type Command, failed, type Outcome, UsageError } from '../command.ts';
import { compileFolder } from '../compile-folder.ts';
import { readRange, readSize } from '../render/render-options.ts';
import { findRenderSession } from '../render/render-session.ts';
import { scoreFrames } from '../score/score-frames.ts';
import { type Limits, missedLimits, scoreLines, summarize } from '../score/score-summary.ts';
import { type ScoredLayers, scoredLayers } from '../score/scored-layers.ts';

export const scoreCommand: Command = {
  name: 'score',
  usage: 'PROJECT --session FOLDER',
  summary: 'Measure occlusion, flicker and tones over a recording',
  doc: 'Plays PROJECT over a recorded session with depth, in a headless browser, and compares what it draws with what the session measured. Occlusion: the intersection over union (IoU) of the pixels of virtual objects that are drawn and those that the measured depth says are visible, and the same for hidden ones. Flicker: the difference between each frame and the one before it, moved by the true motion that poses and depth give, without what the previous frame did not see. Contrast kept: how much strokes and details differ from the tone around them, relative to the first frame; a blur has little flicker and little contrast. Tone error: the difference of the smoothed luma from the camera video, beside virtual objects. Differences are means in steps of 8 bits. docs/SCORE.md says more. If a limit is missed, the exit status is 1.',
  project: 'required',
  options: {
    session: { type: 'string', value: 'FOLDER', doc: 'The folder of a recorded session with depth.' },
    frames: { type: 'string', value: 'A..B', doc: 'First and last frame, from 0, both included; by default all.' },
    size: { type: 'string', value: 'WxH', doc: 'Size in pixels; by default that of the session.' },
    reference: {
      type: 'string',
      value: 'NODE.PORT',
      doc: 'The layer without style, with which tones are compared. By default the camera video.',
    },
    'min-iou': { type: 'string', value: 'RATIO', doc: 'The least IoU of what is visible, from 0 to 1.' },
    'max-flicker': { type: 'string', value: 'STEPS', doc: 'The largest mean flicker, in steps of 8 bits.' },
    'min-contrast': { type: 'string', value: 'RATIO', doc: 'The least contrast that each frame keeps, relative to the first one.' },
    'max-tone-error': { type: 'string', value: 'STEPS', doc: 'The largest tone error, in steps of 8 bits.' },
  },
  examples: [
    { line: 'scrim score my-project --session recordings/desk', says: 'Prints all figures.' },
    {
      line: 'scrim score my-project --session recordings/desk --min-iou 0.95 --max-flicker 4 --json',
      says: 'For CI: figures of each frame as JSON, and the exit status 1 if a limit is missed.',
    },
  ],
  run: async (call, { installation, say, interrupted }): Promise<Outcome> => {
    const named = call.text('session');
    if (!named) throw new UsageError('--session FOLDER is missing. Name the folder of a recorded session with depth.');
    const frames = call.text('frames');
    const range = frames === null ? { first: 0, last: null } : readRange(frames);
    const size = readSize(call.text('size'));
    const limits = limitsOf(call);
    const reference = call.text('reference');

    let scored: ScoredLayers = { layers: [], camera: null };
    const compiled = await compileFolder(call.project, (project) => {
      scored = scoredLayers(project);
      return { taps: tapsOf(scored, reference) };
    });
    const { program, files } = compiled;
    if (program === null) return failed(compiled.diagnostics, files);
    const isTap = (tap: string): boolean => Object.hasOwn(program.taps, tap);
    if (reference !== null && !isTap(reference)) {
      throw new UsageError(`--reference ${reference} is not a layer of the project, or its inputs are not connected.`);
    }
    await expectDepth(named);
    const session = await findRenderSession(named, compiled.root, installation, size);
    if (session.output === null) return failed(session.diagnostics);

    const layers = scored.layers.filter(({ whole, shown }) => isTap(shown) && isTap(whole) && program.taps[whole]?.depth !== null);
    const compared = reference ?? (scored.camera !== null && isTap(scored.camera) ? scored.camera : null);
    const { sizePx } = session.output;
    const result = await scoreFrames({
      ...session.output,
      ...range,
      root: installation.root,
      projectRoot: compiled.root,
      job: { program, session: session.output.session, ...sizePx, subject: { kind: 'screen' } },
      sourceOf: (file) => files.sources[file.replace(/^shaders\//, '')] ?? LIBRARY.shader(file),
      layers,
      reference: compared,
      interrupted,
      say,
    });
    const said = [...compiled.diagnostics, ...result.diagnostics];
    if (hasErrors(said)) return failed(said, files);
    if (result.frames.length === 0) throw noDepth(named, 'none of these frames has a depth image');
    const summary = summarize(result.frames, { layers, reference: compared, pixels: sizePx.widthPx * sizePx.heightPx });
    const missed = missedLimits(summary, limits).map((message): Diagnostic => ({ code: 'SCR077', severity: 'error', message }));
    const diagnostics = [...said, ...missed];
    const ok = missed.length === 0;
    const count = result.frames.length;
    const text = [
      `Scored ${count} ${count === 1 ? 'frame' : 'frames'} of ${sizePx.widthPx} × ${sizePx.heightPx} pixels.`,
      ...scoreLines(summary),
    ];
    return {
      status: ok ? 0 : 1,
      json: { ok, session: named, ...sizePx, ...summary, frames: result.frames, diagnostics },
      text: text.join('\n'),
      diagnostics,
      files,
    };
  },
};

function tapsOf({ layers, camera }: ScoredLayers, reference: string | null): string[] {
  const taps = [...layers.flatMap(({ whole, shown }) => [whole, shown]), reference ?? camera];
  return [...new Set(taps.filter((tap) => tap !== null))];
}

/** @throws SCR054 if a session is an emulated room or has no depth. Other mistakes are reported when it is opened. */
async function expectDepth(named: string): Promise<void> {
  if (named.startsWith('room:')) throw noDepth(named, 'it is an emulated room, not a recording');
  const text = await readText(join(resolve(named), 'session.json'), MAX_SESSION_BYTES).catch(() => null);
  if (text === null) return;
  let file: unknown = null;
  try {
    file = JSON.parse(text);
  } catch {
    return;
  }
  if (typeof file === 'object' && file !== null && !('depth' in file)) throw noDepth(named, 'its session.json has no "depth"');
}

function noDepth(named: string, why: string) {
  const fix = 'Name a recorded session with depth images; docs/SESSION-FORMAT.md describes it.';
  return refusal('SCR054', `${named} has no measured depth to compare with: ${why}.`, fix);
}

function limitsOf(call: Call): Limits {
  return {
    minIou: limitOf(call, 'min-iou', 1),
    maxFlicker: limitOf(call, 'max-flicker', 255),
    minContrast: limitOf(call, 'min-contrast', 1),
    maxToneError: limitOf(call, 'max-tone-error', 255),
  };
}

function limitOf(call: Call, option: string, most: number): number | null {
  const text = call.text(option);
  if (text === null) return null;
  const value = Number(text);
  if (text.trim() !== '' && value >= 0 && value <= most) return value;
  throw new UsageError(`--${option} needs a number from 0 to ${most}, not ${JSON.stringify(text)}.`);
}
