import { spawn } from 'node:child_process';
import process from 'node:process';

const PASSED_ON = ['SIGTERM', 'SIGHUP'] as const;

/**
 * Runs a command with inherited output. Returns its exit status; 1 if it could not be started or took longer than `timeoutS`. Signals
 * that end this process also end the command.
 */
export function runCommand(
  command: string,
  args: readonly string[],
  options: { readonly cwd: string; readonly env?: Readonly<Record<string, string>>; readonly timeoutS?: number },
): Promise<number> {
  return new Promise((resolve) => {
    const timeoutS = options.timeoutS ?? 0;
    const child = spawn(command, args, {
      cwd: options.cwd,
      stdio: ['ignore', 'inherit', 'inherit'],
      timeout: timeoutS * 1000,
      env: { ...process.env, ...options.env },
    });
    child.on('error', (error) => {
      console.error(String(error));
      resolve(1);
    });
    let ended: NodeJS.Signals | null = null;
    const pass = (signal: NodeJS.Signals) => {
      ended = signal;
      child.kill(signal);
    };
    for (const signal of PASSED_ON) process.on(signal, pass);
    child.on('close', (code, signal) => {
      for (const name of PASSED_ON) process.off(name, pass);
      // What comes after the command is not to begin.
      if (ended !== null) process.kill(process.pid, ended);
      if (signal === 'SIGTERM' && timeoutS > 0) console.error(`${command} was ended: it ran for more than ${timeoutS} s.`);
      resolve(code ?? 1);
    });
  });
}
