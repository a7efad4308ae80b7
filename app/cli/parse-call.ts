import { parseArgs } from 'node:util';
import { type Call, type Command, UsageError } from './command.ts';
import { COMMON_OPTIONS } from './help.ts';
import { didYouMean } from './suggest.ts';

const PROJECT: NonNullable<Command['operand']> = { word: 'PROJECT', doc: 'a folder, or the project.scrim.json in it' };

/**
 * Parses arguments.
 *
 * @throws UsageError
 */
export function parseCall(command: Command, args: readonly string[]): Call {
  const { values, positionals } = parse(command, args);
  const { word, doc, many = false } = command.operand ?? PROJECT;
  if (positionals.length > 1 && !many) throw new UsageError(`Too many arguments: ${positionals.slice(1).join(' ')}. Name one ${word}.`);
  const [project = ''] = positionals;
  // `--help` needs no project.
  if (project === '' && command.project === 'required' && values.help !== true) {
    throw new UsageError(`${word} is missing: ${doc}.`);
  }
  return {
    project,
    operands: positionals,
    text: (option) => (typeof values[option] === 'string' ? values[option] : null),
    flag: (option) => values[option] === true,
  };
}

/**
 * Supports optional values, which `parseArgs` of Node lacks: rewrites `--depth` to `--depth=`, and `--depth a-b.c` to
 * `--depth=a-b.c`.
 */
function settleOptionalValues({ options }: Command, args: readonly string[]): string[] {
  const settled: string[] = [];
  for (let i = 0; i < args.length; i++) {
    const arg = args[i] ?? '';
    const pattern = arg.startsWith('--') ? options[arg.slice(2)]?.optionalValue : undefined;
    const next = args[i + 1];
    if (!pattern) settled.push(arg);
    else if (next !== undefined && pattern.test(next)) {
      settled.push(`${arg}=${next}`);
      i++;
    } else settled.push(`${arg}=`);
  }
  return settled;
}

function parse(command: Command, args: readonly string[]) {
  const known = { ...command.options, ...COMMON_OPTIONS };
  const options = Object.fromEntries(
    Object.entries(known).map(([name, { type, short }]) => [name, { type, ...(short === undefined ? {} : { short }) }]),
  );
  try {
    return parseArgs({ args: settleOptionalValues(command, args), options, allowPositionals: true, strict: true });
  } catch (error) {
    const { message } = error as Error;
    const unknown = /^Unknown option '(--?[^']*)'/.exec(message)?.[1];
    if (unknown !== undefined) {
      const names = Object.keys(known).map((name) => `--${name}`);
      throw new UsageError(`Unknown option ${unknown}.${didYouMean(unknown, names)}`);
    }
    throw new UsageError(message.replace(/^Option '([^']*?) <value>' /, "Option '$1' "));
  }
}
