import { join } from 'node:path';
import { cameraPoses } from '../../../export/captures/acquire/camera-places.ts';
import { isHistoryDependent } from '../../../export/program/history-dependence.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { LIBRARY } from '../../services/compile-project.ts';
import { NODE_FILES } from '../../services/file-layer.ts';
import { type FolderMark, writePageFolder } from '../../services/page-folder.ts';
import { createAcquisitionWriter } from '../../services/write-acquisition.ts';
import { ACQUIRE_OPTIONS, readCamera, readDepthFormat, readPlaces } from '../capture/acquire-options.ts';
import { acquireViews } from '../capture/acquire-views.ts';
import { type Command, failed, type Outcome, UsageError } from '../command.ts';
import { compileFolder } from '../compile-folder.ts';
import { quoted } from '../quoted.ts';
import { findDeepLayer, screenLayer } from '../render/render-options.ts';

const ACQUISITION: FolderMark = { file: 'acquisition.json', format: 'scrim-acquisition', words: 'an earlier acquisition' };

export const acquireCommand: Command = {
  name: 'capture',
  usage: 'PROJECT --out DIR',
  summary: 'Take photographs of a scene for a capture',
  doc: 'Takes photographs of what PROJECT draws, from many cameras, in a headless browser: at time 0, without the camera image of a device. Writes color, depth in meters and the poses of the cameras (transforms.json) to DIR, which scrim import capture reads. Transparent pixels have no depth; they get the colors of the nearest opaque ones. After an error nothing is written.',
  project: 'required',
  options: ACQUIRE_OPTIONS,
  examples: [
    {
      line: 'scrim capture my-object --out photos --count 42 --center 0,0.2,-1 --extent 1.5',
      says: 'An object from 42 sides, 0.75 m from its center.',
    },
    {
      line: 'scrim capture my-room --out photos --shape grid --count 3x1x3 --extent 2,0,2 --around',
      says: '360° photographs at nine places of a room.',
    },
  ],
  run: async (call, { installation, say, interrupted }): Promise<Outcome> => {
    const out = call.text('out');
    if (!out) throw new UsageError('--out DIR is missing. Name the folder for the photographs.');
    const places = readPlaces(call);
    const camera = readCamera(call);
    const depthFormat = readDepthFormat(call);
    let tap = call.text('layer') ?? '';
    const compiled = await compileFolder(call.project, (project) => {
      tap ||= screenLayer(project) ?? '';
      return { taps: tap === '' ? [] : [tap] };
    });
    const { project, program } = compiled;
    if (project === null || program === null) return failed(compiled.diagnostics, compiled.files);
    const layer = findDeepLayer(tap, project, program);
    if (layer.output === null) return failed(layer.diagnostics, compiled.files);

    const poses = cameraPoses(places, camera.projection === 'equirectangular');
    const diagnostics: Diagnostic[] = [...compiled.diagnostics];
    if (isHistoryDependent(program)) diagnostics.push(warning(CHANGES));
    const written = await writePageFolder(
      out,
      NODE_FILES,
      async (sink) => {
        const files: { readonly path: string }[] = [];
        const write = async (path: string, bytes: Uint8Array): Promise<void> => {
          await sink.write(path, bytes);
          files.push({ path });
        };
        const acquisition = createAcquisitionWriter(write, { camera, poses, depthFormat });
        const problems = await acquireViews({
          root: installation.root,
          projectRoot: compiled.root,
          program,
          tap,
          camera,
          poses,
          say,
          interrupted,
          sourceOf: (file) => compiled.files.sources[file.replace(/^shaders\//, '')] ?? LIBRARY.shader(file),
          onPhotograph: acquisition.add,
        });
        const { views, empty } = acquisition;
        diagnostics.push(...problems);
        if (empty.length === views.length && !hasErrors(diagnostics)) diagnostics.push(nothingSeen(tap));
        if (hasErrors(diagnostics)) return null;
        await acquisition.finish();
        const report = { format: ACQUISITION.format, version: 1, layer: tap, places, camera, files };
        await sink.write(ACQUISITION.file, new TextEncoder().encode(`${JSON.stringify(report, null, 1)}\n`));
        return { views, empty };
      },
      ACQUISITION,
    );
    if (written === null) return failed(diagnostics, compiled.files);
    const { views, empty } = written;
    if (empty.length > 0)
      diagnostics.push(warning(`Nothing is in view in ${empty.length} of ${views.length} photographs, such as ${empty[0]}.`));
    const text = `Took ${views.length} photographs of ${tap}.\nWrote ${join(out, 'transforms.json')}\nNext: scrim import capture ${quoted(out)} --project PROJECT`;
    return { status: 0, json: { ok: true, out, views, diagnostics }, text, diagnostics, files: compiled.files };
  },
};

const CHANGES =
  'What the scene shows depends on its past, such as by physics or feedback. The photographs show it at time 0, one drawn after the other.';

function warning(message: string): Diagnostic {
  return { code: 'SCR069', severity: 'warning', message };
}

function nothingSeen(tap: string): Diagnostic {
  const fix = 'Set --center to the middle of what is to be seen, and --extent to where the cameras stand.';
  return { code: 'SCR069', severity: 'error', message: `No photograph shows anything of ${tap}.`, fix };
}
