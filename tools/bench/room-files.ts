import { access, copyFile, mkdir, mkdtemp } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { compileProject } from '../../app/services/compile-project.ts';
import { call, openPage } from './open-page.ts';
import type { RoomPlan } from './pages/room-plan.ts';
import { MODEL_FILE, roomProject } from './room-project.ts';

/** Path of the model that the paper uses (§4, Figure 15); null with a message if this checkout has no test data. */
export async function findModel(root: string): Promise<string | null> {
  const path = `../shared/data/models/${MODEL_FILE}`;
  const model = resolve(root, path);
  try {
    await access(model);
    return model;
  } catch {
    console.error(`What is measured with the model ${path} is left out: the file is missing.`);
    return null;
  }
}

/** Creates a project folder with the model. The caller deletes it. */
export async function roomFolder(model: string): Promise<string> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-bench-room-'));
  await mkdir(join(folder, 'assets'));
  await copyFile(model, join(folder, 'assets', MODEL_FILE));
  return folder;
}

export async function openThree(browser: Browser, root: string, folder: string, plan: RoomPlan): Promise<Page> {
  const page = await openPage(browser, root, 'tools/bench/pages/three-room.page.ts', folder);
  await call(page, 'open', `assets/${MODEL_FILE}`, plan);
  return page;
}

export async function openOurs(browser: Browser, root: string, folder: string, plan: RoomPlan): Promise<Page> {
  const files = { project: JSON.stringify(roomProject(plan)), layout: null, sources: {} };
  const { program, diagnostics } = await compileProject(folder, files, () => ({ sourceMaps: false }));
  if (program === null) throw new Error(`The room does not compile: ${JSON.stringify(diagnostics)}`);
  const page = await openPage(browser, root, 'tools/bench/pages/room.page.ts', folder);
  await call(page, 'open', program, plan);
  return page;
}
