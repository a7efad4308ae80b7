import { type Command, EXIT, type Option } from './command.ts';

const JSON_OPTION: Option = { type: 'boolean', doc: 'Print one JSON value on standard output, and nothing else there.' };
const HELP_OPTION: Option = { type: 'boolean', short: 'h', doc: 'Show this.' };

/** Options of all commands. */
export const COMMON_OPTIONS: Readonly<Record<string, Option>> = { json: JSON_OPTION, help: HELP_OPTION };

const WIDTH = 96;

export function overviewHelp(commands: readonly Command[]): string {
  const width = Math.max(...commands.map(({ name }) => name.length));
  return `Scrim turns a graph of mixed-reality layers and effects into a WebXR page.

Usage: scrim COMMAND [PROJECT] [OPTIONS]

${commands.map(({ name, summary }) => `  ${name.padEnd(width)}  ${summary}`).join('\n')}

PROJECT is a project's folder, or the project.scrim.json in it.

A first page:
  scrim new my-effect --template occlusion
  scrim open my-effect
  scrim export my-effect --out site

scrim COMMAND --help explains a command, with examples. scrim --version tells which Scrim this is.

Exit status:
${EXIT_LINES.map(([status, says]) => `  ${String(status).padStart(3)}  ${says}`).join('\n')}

Environment:
  NO_COLOR                      Write without color; so does a pipe.
  SCRIM_CHROMIUM                The browser program that renders, draws posters and compiles shaders.
  ELECTRON_OVERRIDE_DIST_PATH   Folder with the Electron that scrim open uses.`;
}

const EXIT_LINES: readonly (readonly [number, string])[] = [
  [EXIT.done, 'done; warnings, if any, are printed'],
  [EXIT.problems, 'something is wrong with the project, or on this machine; each problem is printed'],
  [EXIT.notUnderstood, 'the command line is not understood'],
  [EXIT.ownFault, 'Scrim has an internal error'],
  [EXIT.interrupted, 'ended by Ctrl-C; nothing half-done is left behind'],
  [EXIT.terminated, 'ended by another program (SIGTERM), in the same way'],
];

export function commandHelp({ name, usage, doc, options, examples }: Command): string {
  const all = Object.entries({ ...options, ...COMMON_OPTIONS }).map(([key, option]) => [optionHead(key, option), option.doc] as const);
  const width = Math.max(...all.map(([head]) => head.length));
  const optionLines = all.map(([head, text]) => `  ${head.padEnd(width)}  ${wrap(text, WIDTH - width - 4, ' '.repeat(width + 4))}`);
  return `Usage: scrim ${name} ${usage}

${wrap(doc, WIDTH, '')}

Options:
${optionLines.join('\n')}

Examples:
${examples.map(({ line, says }) => `  ${line}\n      ${wrap(says, WIDTH - 6, '      ')}`).join('\n')}`;
}

function optionHead(name: string, { short, value }: Option): string {
  return `${short === undefined ? '' : `-${short}, `}--${name}${value === undefined ? '' : ` ${value}`}`;
}

function wrap(text: string, width: number, indent: string): string {
  const lines: string[] = [];
  for (const word of text.split(/\s+/)) {
    const last = lines.at(-1);
    if (last !== undefined && last.length + word.length < width) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines.join(`\n${indent}`);
}
