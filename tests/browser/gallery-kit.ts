import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { compile } from '../../export/compiler/compile.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Project } from '../../export/graph/project.ts';
import type { Program } from '../../export/program/program.ts';
import { LIBRARY } from '../support/library.ts';

const FOLDER = resolve(import.meta.dirname, '../../examples/boards/gallery');

/** Its files, as `gallery/`. */
export const GALLERY_MOUNTS = { '/gallery/': FOLDER };

export function loadGallery(): Project {
  const text = (name: string) => readFileSync(`${FOLDER}/${name}`, 'utf8');
  const { output } = loadProject({ project: text('project.scrim.json'), layout: text('project.layout.json'), sources: {} });
  if (!output) throw new Error('The gallery cannot be read.');
  return output;
}

/** Throws where anything is wrong with it. */
export function compileGallery(project: Project): Program {
  const { output, diagnostics } = compile({ project, library: LIBRARY });
  if (!output || diagnostics.length > 0) throw new Error(JSON.stringify(diagnostics));
  return output;
}
