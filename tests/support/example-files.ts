import { readFileSync } from 'node:fs';
import { expect } from '@jest/globals';
import { saveProject } from '../../export/graph/save.ts';
import type { makeProject } from '../../tools/examples/paper/recipe.ts';

/** Expects an example's folder to hold exactly the project that its script makes, and all of its files. */
export function expectMadeByScript(folder: string, project: ReturnType<typeof makeProject>): void {
  const saved = saveProject(project);
  expect(readFileSync(`examples/${folder}/project.scrim.json`, 'utf8')).toBe(saved.project);
  expect(readFileSync(`examples/${folder}/project.layout.json`, 'utf8')).toBe(saved.layout);
  for (const { path } of Object.values(project.assets)) expect(readFileSync(`examples/${folder}/${path}`).length).toBeGreaterThan(1000);
}
