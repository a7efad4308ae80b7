import type { Diagnostic, Result } from '../../nodes/kit/diagnostics.ts';
import { type DocumentFormat, LAYOUT_FORMAT, migrateDocument, PROJECT_FORMAT } from './document/migrate-document.ts';
import { SHADER_FILE } from './document/name-rules.ts';
import { readLayout } from './document/read-layout.ts';
import { readProject } from './document/read-project.ts';
import { parseJson } from './json/parse-json.ts';
import { createLocator } from './json/positions.ts';
import { createShapeReader, type ShapeReader } from './json/shape-reader.ts';
import { EMPTY_GRAPH } from './new-project.ts';
import type { Project } from './project.ts';
import { getOwn } from './record.ts';
import { pruneRoutes } from './routes.ts';

/** The files of a project folder as texts. */
export interface ProjectTexts {
  /** `project.scrim.json`. */
  readonly project: string;
  /** `project.layout.json`, or null if there is none. */
  readonly layout: string | null;
  /** The files in `shaders/` by name. */
  readonly sources: Readonly<Record<string, string>>;
}

/** Maximum length of a shader, the same as in the host's contract. */
const MAX_SHADER_CHARACTERS = 4 * 2 ** 20;

/**
 * Reads a project from the texts of its files. Invalid texts give errors: SCR001 (not JSON), SCR002 (wrong shape, unknown keys included),
 * SCR003 (newer version), SCR005 (too large), SCR006 (not finite). An invalid layout gives warnings; `placeNodes` then places the nodes.
 * Invalid routes are left out.
 *
 * Node types are not checked: `migrateNodes` and `validateProject` do that with a library.
 *
 * @param texts The files of a project folder.
 * @returns The project, or null with at least one error. Never throws.
 *
 * @example
 * const { output, diagnostics } = loadProject({ project: text, layout: null, sources: {} });
 * if (output === null) console.error(diagnostics);
 */
export function loadProject(texts: ProjectTexts): Result<Project> {
  const project = readDocument(texts.project, PROJECT_FORMAT, readProject);
  const layout = texts.layout === null ? NO_LAYOUT : readDocument(texts.layout, LAYOUT_FORMAT, readLayout);
  const diagnostics = [...project.diagnostics, ...layout.diagnostics.map(asLayoutWarning), ...checkSources(texts.sources)];
  if (project.output === null || diagnostics.some((d) => d.severity === 'error')) return { output: null, diagnostics };
  const { graphs } = project.output;
  const layouts = Object.entries(layout.output ?? {}).map(([name, read]) => [name, pruneRoutes(getOwn(graphs, name) ?? EMPTY_GRAPH, read)]);
  return { output: { ...project.output, layout: Object.fromEntries(layouts), sources: { ...texts.sources } }, diagnostics };
}

const NO_LAYOUT: Result<Project['layout']> = { output: {}, diagnostics: [] };

function readDocument<T>(text: string, format: DocumentFormat, read: (reader: ShapeReader, json: unknown) => T): Result<T> {
  const { file } = format;
  const parsed = parseJson(text, file);
  if (!parsed.ok) return { output: null, diagnostics: [parsed.diagnostic] };
  const locate = createLocator(text);
  const migrated = migrateDocument(parsed.value, format);
  if (!migrated.ok) {
    const { code, message } = migrated;
    const place = locate(migrated.at === null ? [] : [migrated.at], 'value');
    return { output: null, diagnostics: [{ code, severity: 'error', file, ...place, message }] };
  }
  const reader = createShapeReader();
  const output = read(reader, migrated.json);
  if (reader.problems.length === 0) return { output, diagnostics: [] };
  const diagnostics = reader.problems.map(
    ({ code, path, of, message }): Diagnostic => ({ code, severity: 'error', file, ...locate(path, of), message }),
  );
  return { output: null, diagnostics };
}

function asLayoutWarning(diagnostic: Diagnostic): Diagnostic {
  return {
    ...diagnostic,
    severity: 'warning',
    fix: 'Arrange the nodes again, or restore the layout from a backup. The graph itself is complete.',
  };
}

function checkSources(sources: Readonly<Record<string, string>>): Diagnostic[] {
  return Object.entries(sources).flatMap(([name, text]): Diagnostic[] => {
    const file = `shaders/${name.slice(0, 200)}`;
    if (!SHADER_FILE.is(name)) return [{ code: 'SCR002', severity: 'error', file, message: `Invalid name: ${SHADER_FILE.words}` }];
    if (text.length <= MAX_SHADER_CHARACTERS) return [];
    return [{ code: 'SCR005', severity: 'error', file, message: 'The shader is larger than 4 MiB.' }];
  });
}
