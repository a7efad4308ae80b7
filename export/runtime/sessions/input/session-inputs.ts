import { createWebXrInput, type WebXrInput } from '../webxr/webxr-input.ts';
import { createPageInput, type PageInput } from './page-input.ts';

/** How sessions read input. A page whose program reads none is bundled without it; its frames list no pointers, taps and controllers. */
export interface SessionInputs {
  page(canvas: HTMLCanvasElement): PageInput;
  webXr(session: XRSession, referenceSpace: XRReferenceSpace): WebXrInput;
}

export const SESSION_INPUTS: SessionInputs = { page: createPageInput, webXr: createWebXrInput };
