import { parseArgs } from 'node:util';
import { type Call, type Command, UsageError } from './command.ts';
import { COMMON_OPTIONS } from './help.ts';

/** Throws `UsageError`, in words. */
export function parseCall(command: Command, args: readonly string[]): Call {
  const { values, positionals } = parse(command, args);
  if (positionals.length > 1) throw new UsageError(`One project at a time: ${positionals.slice(1).join(' ')} is too much.`);
  const [project = ''] = positionals;
  // `--help` needs no project.
  if (project === '' && command.project === 'required' && values.help !== true) {
    throw new UsageError('PROJECT is missing: a folder, or the project.scrim.json in it.');
  }
  return {
    project,
    text: (option) => (typeof values[option] === 'string' ? values[option] : null),
    flag: (option) => values[option] === true,
  };
}

/** Node knows no options whose value may be missing: `--depth` becomes `--depth=`, and `--depth a-b.c` becomes `--depth=a-b.c`. */
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
  const options = Object.fromEntries(Object.entries({ ...command.options, ...COMMON_OPTIONS }).map(([name, { type }]) => [name, { type }]));
  try {
    return parseArgs({ args: settleOptionalValues(command, args), options, allowPositionals: true, strict: true });
  } catch (error) {
    // Node explains at length how to pass a file whose name begins with a hyphen; its first sentence is what matters.
    throw new UsageError(
      (error as Error).message.replace(/\. To specify .*$/s, '.').replace(/^Option '([^']*?) <value>' /, "Option '$1' "),
    );
  }
}
