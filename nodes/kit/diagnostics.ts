/**
 * A mistake of a user, as a value. Programmer mistakes throw instead.
 *
 * @example
 * ctx.report({ code: 'SCR018', severity: 'warning', message: 'The model has no animation “walk”.', fix: 'Choose another one.' });
 */
export interface Diagnostic {
  readonly code: DiagnosticCode;
  readonly severity: 'error' | 'warning' | 'info';
  /** What is wrong, and where, as a sentence. */
  readonly message: string;
  readonly nodeId?: string;
  readonly port?: string;
  /** The file of a diagnostic in text: `project.scrim.json`, `shaders/edge.fs`. */
  readonly file?: string;
  /** Line number in `file`, from 1. */
  readonly line?: number;
  /** Column number in the line, from 1. */
  readonly column?: number;
  /** The remedy, as an imperative sentence. */
  readonly fix?: string;
}

/** The title of each code; `docs/diagnostics.md` is generated from this table. */
export const DIAGNOSTICS = {
  // Documents
  SCR001: 'The file is not valid JSON',
  SCR002: 'The document does not match the schema of its version',
  SCR003: 'The document was saved by a newer version of Scrim',
  SCR004: 'The project cannot be read',
  SCR005: 'The file is too large',
  SCR006: 'A number is not finite',
  // Graphs
  SCR010: 'The node type is unknown',
  SCR011: 'The node was saved by a newer version of its type',
  SCR012: 'The wire refers to a node or port that does not exist',
  SCR013: 'The two ports have different types',
  SCR014: 'The wires form a cycle',
  SCR015: 'A required input is not connected',
  SCR016: 'An input for one wire has several',
  SCR017: 'The graph does not have exactly one Output node',
  SCR018: 'The parameter is unknown or its value is invalid',
  SCR019: 'The parameter cannot be bound this way',
  SCR020: 'The subgraph does not exist or contains itself',
  SCR021: 'The node has no effect: the output does not depend on it',
  SCR022: 'The expression is invalid',
  SCR023: 'More lights are connected than can be drawn',
  SCR024: 'A shadow does not match the shape or transparency of its object',
  SCR025: 'The device does not support the shadow settings',
  SCR026: 'The project has too many nodes',
  SCR027: 'The graph has several nodes of a type of which it may have one',
  SCR076: 'A kind of device lacks what a node requires',
  SCR028: 'The panorama has no lamps',
  SCR029: 'Pixels of the panorama are invalid',
  // Assets
  SCR030: 'The asset is not in the project',
  SCR031: 'The asset is outside the project folder',
  SCR032: 'The asset cannot be decoded',
  SCR033: 'The asset is of the wrong kind',
  SCR034: 'The asset is very large',
  SCR035: 'The model of a phantom has holes',
  SCR036: 'The asset could not be compressed',
  SCR037: 'A body has the shape of a box instead of its object',
  SCR038: 'A body belongs to no physics world',
  SCR039: 'The panorama has an unusual shape',
  SCR068: 'The shots of a panorama do not fit together',
  SCR069: 'The photographs of a capture, or their cameras, are invalid',
  // Shaders
  SCR040: 'The shader header is invalid',
  SCR041: 'The shader has a syntax error',
  SCR042: 'The shader does not compile',
  SCR043: 'The shader uses a feature that Scrim does not support',
  SCR044: 'A loop of the shader takes too long or never ends',
  SCR045: 'The Shadertoy source cannot be converted',
  SCR046: 'The license of an asset or shader forbids commercial use',
  SCR047: 'An effect that runs on the CPU failed',
  SCR048: 'Layers of different encodings are connected',
  SCR049: 'Shadows are too faint on the display',
  // Sessions
  SCR050: 'The browser does not support WebXR',
  SCR051: 'The device or the visitor refused a request',
  SCR052: 'The session ended',
  SCR053: 'The graphics context was lost',
  SCR054: 'The session folder is invalid',
  SCR055: 'A feature is not available; the project plays without it',
  SCR056: 'A node received more pulses in one frame than it can pass on',
  SCR057: 'The device does not keep an anchor or the room over visits',
  SCR058: 'The worker of the physics world ended',
  SCR059: 'A text cannot be drawn completely',
  // Files and export
  SCR060: 'The folder cannot be written',
  SCR061: 'The folder contains files that Scrim did not write',
  SCR062: 'The disk is full',
  SCR063: 'The file was changed outside Scrim',
  SCR064: 'The page could not be bundled',
  SCR065: 'The poster of the page could not be rendered',
  SCR066: 'Another Scrim is writing the same files',
  SCR067: 'The project folder does not exist anymore',
  // Command line
  SCR070: 'The command line is invalid',
  SCR071: 'No browser that can render was found',
  SCR072: 'The connection to Scrim was lost',
  SCR073: 'The request was refused',
  SCR074: 'An internal error occurred',
  SCR075: 'The link of the session was opened a second time',
  SCR077: 'A score of the project misses its limit',
  SCR078: 'A program of others is missing or failed',
} as const;

/** The code of a diagnostic. */
export type DiagnosticCode = keyof typeof DIAGNOSTICS;

/**
 * Whether any of the diagnostics is an error.
 *
 * @example
 * if (hasErrors(result.diagnostics)) return null;
 */
export function hasErrors(diagnostics: readonly Diagnostic[]): boolean {
  return diagnostics.some((d) => d.severity === 'error');
}

/**
 * Formats a diagnostic as one line: `file:line:column: error SCR042: message`, or `node.port:column: …`.
 *
 * @param d Parts that are absent are left out of the line.
 * @returns One line, with the remedy at its end.
 *
 * @example
 * formatDiagnostic({ code: 'SCR042', severity: 'error', file: 'shaders/edge.fs', line: 3, message: 'No.' });
 * // 'shaders/edge.fs:3: error SCR042: No.'
 */
export function formatDiagnostic(d: Diagnostic): string {
  // Without a file and a line, the column refers to the text at the port.
  const alone = d.file === undefined && d.line === undefined;
  const place = [d.file, d.line, alone ? undefined : d.column].filter((part) => part !== undefined).join(':');
  const column = alone && d.column !== undefined ? `:${d.column}` : '';
  const node = d.nodeId === undefined ? '' : `${d.nodeId}${d.port === undefined ? '' : `.${d.port}`}${column}`;
  const where = [place, node].filter((part) => part !== '').join(' ');
  const fix = d.fix === undefined ? '' : ` ${d.fix}`;
  return `${where === '' ? '' : `${where}: `}${d.severity} ${d.code}: ${d.message}${fix}`;
}

/** The result of a phase: its output, or null if there are errors, and its diagnostics. */
export interface Result<T> {
  readonly output: T | null;
  readonly diagnostics: readonly Diagnostic[];
}
