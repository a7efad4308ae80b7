import type { ProgramAsset } from '../../program/program.ts';
import type { Form } from './choose-forms.ts';

export interface PreparedAsset {
  readonly asset: ProgramAsset;
  /** Path in the page. */
  readonly path: string;
  readonly bytes: Uint8Array;
  /** The other files of a capture, with their paths in the page. */
  readonly others: readonly { readonly path: string; readonly bytes: Uint8Array }[];
  /** Author and license of a model (glTF's `asset.copyright`); otherwise empty. */
  readonly copyright: string;
  readonly report: ReportedAsset;
}

/** Result of the export for an asset. Bytes on the GPU are estimated: vertices, indices, and images with their mipmaps. */
export interface ReportedAsset {
  /** Path in the project. */
  readonly source: string;
  /** Path in the page. */
  readonly path: string;
  readonly kind: ProgramAsset['kind'];
  readonly form: Form;
  readonly fileBytes: BeforeAfter;
  /** `onPhones`: what a capture or splats take on phones and headsets, where they have a limit. */
  readonly gpuBytes: BeforeAfter & { readonly onPhones?: number };
  /** What phones and headsets show less of a capture or splats; absent if nothing. */
  readonly reducedOnPhones?: readonly string[];
}

export interface BeforeAfter {
  readonly before: number;
  readonly after: number;
}
