import type { Program } from './program.ts';
import { readsView } from './reads-view.ts';

type Facts = Pick<Program, 'presentation' | 'operations' | 'assets' | 'needs' | 'readsInput'>;

/**
 * Whether the image of a program covers the view, needs nothing of a session and does not depend on the view: in AR, in VR and over the
 * camera, a visitor would see no more of it (ADR 54).
 */
export function isFixedImage(program: Facts): boolean {
  return program.presentation.covers === true && isStill(program);
}

function isStill(program: Facts): boolean {
  return program.needs.length === 0 && !readsView(program);
}

/** Says to people who make pages why a program plays in no session that a visitor enters, or with which files it would; else null. */
export function fixedImageNote(program: Facts): string | null {
  const { covers } = program.presentation;
  if (covers === undefined || !isStill(program)) return null;
  return covers === true ? FIXED : FIXED_IF_OPAQUE;
}

const FIXED =
  'The image covers the view and does not depend on it, so the page offers neither AR, VR nor the camera: they would show no more.';
const FIXED_IF_OPAQUE =
  'The image does not depend on the view. If its files have no transparency, the exported page offers neither AR, VR nor the camera.';
