import { spawnSync } from 'node:child_process';
import { describe } from '@jest/globals';
import { describeMissing, type Requirement } from './required.ts';

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

/** Tests that run the algorithm of Instant Meshes by a package for Python. Skipped with the reason where that is missing. */
export function describeWithInstantMeshes(name: string, tests: () => void): void {
  describeWithPackage(name, 'instantmeshes', 'pynanoinstantmeshes', tests, 'pynanoinstantmeshes');
}

function describeWithPackage(name: string, what: Requirement, title: string, tests: () => void, module: string = what): void {
  if (spawnSync('python3', ['-c', `import ${module}`]).status === 0) describe(name, tests);
  else describeMissing(name, what, `python3 has no package ${title} (https://pypi.org/project/${title})`);
}
