import { spawnSync } from 'node:child_process';
import { describe } from '@jest/globals';
import { describeMissing } from './required.ts';

/** Runs a Python script with arguments. @returns What it prints. */
export function runPython(script: string, ...args: readonly string[]): string {
  const { status, stdout, stderr } = spawnSync('python3', ['-c', script, ...args], { encoding: 'utf8' });
  if (status !== 0) throw new Error(`Python failed: ${stderr}`);
  return stdout;
}

/** Tests that run COLMAP by its package for Python. Skipped with the reason where that is missing. */
export function describeWithColmap(name: string, tests: () => void): void {
  describeWithPackage(name, 'pycolmap', 'pycolmap', tests);
}

/** Tests that compare with scikit-image. Skipped with the reason where that is missing. */
export function describeWithSkimage(name: string, tests: () => void): void {
  describeWithPackage(name, 'skimage', 'scikit-image', tests);
}

function describeWithPackage(name: string, module: 'pycolmap' | 'skimage', title: string, tests: () => void): void {
  if (spawnSync('python3', ['-c', `import ${module}`]).status === 0) describe(name, tests);
  else describeMissing(name, module, `python3 has no package ${title} (https://pypi.org/project/${title})`);
}
