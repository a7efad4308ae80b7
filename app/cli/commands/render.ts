import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { LIBRARY } from '../../services/compile-project.ts';
import { type Call, type Command, failed, type Outcome, UsageError } from '../command.ts';
import { compileFolder } from '../compile-folder.ts';
import { createFrameWriter } from '../render/frame-writer.ts';
import { renderFrames } from '../render/render-frames.ts';
import { readRange, readSize, subjectOf, tapsFor } from '../render/render-options.ts';
import { findRenderSession } from '../render/render-session.ts';

/** Matches `scene-k7q2.layer`, also inside subgraphs, but no file name. */
const NODE_PORT = /^(?!.*\.(?:png|json)$)[a-z][a-z0-9/-]*-[a-z0-9]+\.[A-Za-z_]\w*$/;

export const renderCommand: Command = {
  name: 'render',
  usage: 'PROJECT --out FILE.png|DIR',
  summary: 'Render frames to PNG files',
  doc: 'Plays PROJECT over a recorded session or in an emulated room, in a headless browser with fixed time, date and random seed, and writes what a visitor would see: the same pixels each time. Writes one frame to FILE.png, several to DIR/000000.png and so on, as RGBA with straight alpha. After an error nothing is written.',
  project: 'required',
  options: {
    out: { type: 'string', value: 'FILE.png|DIR', doc: 'File or folder to write the frames to.' },
    session: {
      type: 'string',
      value: 'FOLDER|room:NAME',
      doc: 'A folder with session.json, or an emulated room: room:studio, room:living_room, room:meeting_room, room:music_room, room:office_large, room:office_small. Without it, the project’s own first session, else the studio that comes with Scrim.',
    },
    frames: { type: 'string', value: 'A..B', doc: 'First and last frame, from 0, both included; by default frame 0.' },
    size: { type: 'string', value: 'WxH', doc: 'Size in pixels; by default that of the session.' },
    layer: { type: 'string', value: 'NODE.PORT', doc: 'Write this layer instead of the screen output.' },
    depth: {
      type: 'string',
      value: '[NODE.PORT]',
      optionalValue: NODE_PORT,
      doc: 'Write depth instead of color, in millimeters, 16 bits: 0 is nothing, 65535 is 65.5 m or more. Depth of the layer named here or by --layer, else of the screen output.',
    },
  },
  examples: [
    { line: 'scrim render my-project --out picture.png', says: 'The first frame.' },
    {
      line: 'scrim render my-project --session recordings/desk --frames 0..59 --out frames',
      says: 'A second of a recording, to frames/000000.png and on.',
    },
    { line: 'scrim render my-project --layer scene-k7q2.layer --out scene.png', says: 'What one node draws, before everything after it.' },
    {
      line: 'scrim render my-project --out depth.png --session room:living_room --depth',
      says: 'Writes the depth of the virtual objects.',
    },
  ],
  run: async (call, { installation, say, interrupted }): Promise<Outcome> => {
    const out = readOut(call);
    const range = readRange(call.text('frames'));
    const size = readSize(call.text('size'));
    const isFile = out.toLowerCase().endsWith('.png');
    if (isFile && range.first !== range.last) throw new UsageError(`${out} is one file, but --frames names several frames. Name a folder.`);

    const compiled = await compileFolder(call.project, (project) => ({ taps: tapsFor(call, project) }));
    const { project, program } = compiled;
    if (project === null || program === null) return failed(compiled.diagnostics, compiled.files);
    const subject = subjectOf(call, project, program);
    if (subject.output === null) return failed(subject.diagnostics, compiled.files);
    const session = await findRenderSession(call.text('session'), compiled.root, installation, size);
    if (session.output === null) return failed(session.diagnostics);

    const writer = await createFrameWriter(out, isFile, subject.output.kind === 'depth');
    try {
      const diagnostics = await renderFrames({
        ...session.output,
        ...range,
        root: installation.root,
        projectRoot: compiled.root,
        job: { program, session: session.output.session, ...session.output.sizePx, subject: subject.output },
        sourceOf: (file) => compiled.files.sources[file.replace(/^shaders\//, '')] ?? LIBRARY.shader(file),
        onImage: async (...image) => {
          interrupted.throwIfAborted();
          await writer.add(...image);
        },
        say,
      });
      const all = [...compiled.diagnostics, ...diagnostics];
      if (hasErrors(all)) return failed(all, compiled.files);
      const files = await writer.finish();
      const text = files.length === 1 ? `Wrote ${files[0]}` : `Wrote ${files.length} frames to ${out}`;
      return { status: 0, json: { ok: true, out, files, diagnostics: all }, text, diagnostics: all, files: compiled.files };
    } finally {
      await writer.dispose();
    }
  },
};

function readOut(call: Call): string {
  const out = call.text('out');
  if (out === null || out === '') throw new UsageError('--out FILE.png or --out DIR is missing. Name the file or folder to write to.');
  return out;
}
