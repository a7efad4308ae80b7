import type { Command, Option } from './command.ts';

const JSON_OPTION: Option = { type: 'boolean', doc: 'Print one JSON value on standard output, and nothing else there.' };
const HELP_OPTION: Option = { type: 'boolean', doc: 'Show this.' };

/** What every command takes beside its own. */
export const COMMON_OPTIONS: Readonly<Record<string, Option>> = { json: JSON_OPTION, help: HELP_OPTION };

const WIDTH = 96;

export function overviewHelp(commands: readonly Command[]): string {
  const width = Math.max(...commands.map(({ name }) => name.length));
  return `Scrim turns a graph of mixed-reality layers and effects into a WebXR page.

Usage: scrim COMMAND PROJECT [OPTIONS]

${commands.map(({ name, summary }) => `  ${name.padEnd(width)}  ${summary}`).join('\n')}

PROJECT is a project's folder, or the project.scrim.json in it.
scrim COMMAND --help explains a command, with examples.
Exit status: 0 done, 1 errors in the project or on this machine, 2 the command line is not understood.`;
}

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

function optionHead(name: string, { value }: Option): string {
  return `--${name}${value === undefined ? '' : ` ${value}`}`;
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
