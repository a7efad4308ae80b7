/**
 * Mistakes a user can make, as values. The message says what, where and what to do; the code finds its page in
 * `docs/diagnostics.md`, which is made from this table. Programmers' mistakes throw instead.
 */
export interface Diagnostic {
  readonly code: DiagnosticCode;
  readonly severity: 'error' | 'warning' | 'info';
  readonly message: string;
  readonly nodeId?: string;
  readonly port?: string;
  /** Which file, for diagnostics in text: `project.scrim.json`, `shaders/edge.fs`. */
  readonly file?: string;
  /** From 1. */
  readonly line?: number;
  /** From 1. */
  readonly column?: number;
  readonly fix?: string;
}

export const DIAGNOSTICS = {
  // Documents
  SCR001: 'The file is not valid JSON',
  SCR002: 'The document does not have the shape that its version asks for',
  SCR003: 'The document was saved by a newer Scrim',
  SCR004: 'The project cannot be read',
  SCR005: 'The file is too large',
  SCR006: 'A number is not finite',
  // Graphs
  SCR010: 'The node type is unknown',
  SCR011: 'The node was saved by a newer version of its type',
  SCR012: 'The wire names a node or port that does not exist',
  SCR013: 'The two ports carry different types',
  SCR014: 'The wires form a cycle',
  SCR015: 'A required port has no wire',
  SCR016: 'A port that takes one wire has several',
  SCR017: 'The graph needs exactly one screen',
  SCR018: 'The param is unknown or its value does not fit',
  SCR019: 'The param cannot be bound this way',
  SCR020: 'The subgraph does not exist or contains itself',
  SCR021: 'The node does nothing: nothing on screen depends on it',
  SCR022: 'The expression cannot be read',
  SCR023: 'More lights are wired than can be drawn',
  SCR024: 'A shadow is not of the shape or darkness of the thing that casts it',
  SCR025: 'The device cannot draw shadows as they are set up',
  SCR026: 'The project has too many nodes',
  // Assets
  SCR030: 'The asset is not in the project',
  SCR031: 'The asset lies outside the project folder',
  SCR032: 'The asset cannot be decoded',
  SCR033: 'The asset is of another kind',
  SCR034: 'The asset is very large',
  SCR035: 'The model of a real thing has holes',
  SCR036: 'The asset could not be compressed',
  // Shaders
  SCR040: 'The shader header is broken',
  SCR041: 'The shader has a syntax error',
  SCR042: 'The shader does not compile',
  SCR043: 'The shader uses something that Scrim cannot give it',
  SCR044: 'The loops of the shader take too long, or never end',
  SCR045: 'The Shadertoy source cannot be converted as it is',
  SCR046: 'The license of a work forbids commercial use',
  SCR047: 'An effect that the processor works out has failed',
  // Sessions
  SCR050: 'This browser has no WebXR',
  SCR051: 'The device or the visitor refused',
  SCR052: 'The session ended',
  SCR053: 'The graphics context was lost',
  SCR054: 'The session folder is broken',
  SCR055: 'A capability is missing: the picture does without it',
  SCR056: 'More happened in one frame than a node can pass on',
  // Files and export
  SCR060: 'The folder cannot be written',
  SCR061: 'The folder holds files that Scrim did not write',
  SCR062: 'The disk is full',
  SCR063: 'The file changed outside Scrim',
  SCR064: 'The page could not be bundled',
  SCR065: 'There is no picture of the page for its poster',
  SCR066: 'Another Scrim holds the project',
  SCR067: 'The project folder is gone',
  // Command line
  SCR070: 'The command line is not understood',
  SCR071: 'There is no browser that can render',
  SCR072: 'Scrim does not answer',
  SCR073: 'The request was refused',
  SCR074: 'Scrim made a mistake of its own',
  SCR075: 'The address of the session was opened a second time',
} as const;

export type DiagnosticCode = keyof typeof DIAGNOSTICS;

export function hasErrors(diagnostics: readonly Diagnostic[]): boolean {
  return diagnostics.some((d) => d.severity === 'error');
}

/**
 * Formats a diagnostic as one line: `file:line:column: error SCR042: message`, or `node.port:column: …`.
 *
 * @returns Without the parts that are unknown.
 *
 * @example
 * formatDiagnostic({ code: 'SCR042', severity: 'error', file: 'shaders/edge.fs', line: 3, message: 'No.' });
 */
export function formatDiagnostic(d: Diagnostic): string {
  // Without a file and a line, a column is one of the text at the port.
  const alone = d.file === undefined && d.line === undefined;
  const place = [d.file, d.line, alone ? undefined : d.column].filter((part) => part !== undefined).join(':');
  const column = alone && d.column !== undefined ? `:${d.column}` : '';
  const node = d.nodeId === undefined ? '' : `${d.nodeId}${d.port === undefined ? '' : `.${d.port}`}${column}`;
  const where = [place, node].filter((part) => part !== '').join(' ');
  const fix = d.fix === undefined ? '' : ` ${d.fix}`;
  return `${where === '' ? '' : `${where}: `}${d.severity} ${d.code}: ${d.message}${fix}`;
}

/** How every phase answers: what it could make, or null, and what it has to say. */
export interface Result<T> {
  readonly output: T | null;
  readonly diagnostics: readonly Diagnostic[];
}
