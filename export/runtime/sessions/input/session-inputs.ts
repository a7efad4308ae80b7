import { createWebXrInput, type WebXrInput } from '../webxr/webxr-input.ts';
import { createPageInput, type PageInput } from './page-input.ts';

/**
 * Functions by which sessions read input. A page whose program reads no input is bundled without them; its frames list no pointers, taps
 * and controllers.
 */
export interface SessionInputs {
  page(canvas: HTMLCanvasElement): PageInput;
  webXr(session: XRSession, referenceSpace: XRReferenceSpace): WebXrInput;
}

export const SESSION_INPUTS: SessionInputs = { page: createPageInput, webXr: createWebXrInput };
