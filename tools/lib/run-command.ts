import { spawn } from 'node:child_process';
import process from 'node:process';

/**
 * Runs a command with its output passed through, and answers with its exit status; 1 where it could not be started or was ended
 * because it took longer than `timeoutS`.
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
    child.on('close', (code, signal) => {
      if (signal === 'SIGTERM' && timeoutS > 0) console.error(`${command} was ended: it ran for more than ${timeoutS} s.`);
      resolve(code ?? 1);
    });
  });
}
