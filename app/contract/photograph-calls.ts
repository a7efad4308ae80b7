import { z } from 'zod';
import type { CaptureView } from '../../nodes/kit/capture.ts';
import { diagnostic, handle, isWithinLimit, pictureSize, programPath, projectPath, side } from './call-parts.ts';

/** The camera of all photographs of an acquisition: `AcquiredCamera`. */
const acquiredCamera = z.discriminatedUnion('projection', [
  z.object({ projection: z.literal('perspective'), widthPx: side, heightPx: side, fovYRad: z.number().positive().max(Math.PI) }),
  z.object({ projection: z.literal('equirectangular'), widthPx: side, heightPx: side }),
]);

/** `ScaleSource`. */
const scaleSource = z.discriminatedUnion('from', [
  z.object({ from: z.literal('given') }),
  z.object({ from: z.literal('distance'), photo: z.string(), meters: z.number() }),
  z.object({ from: z.literal('camera-height'), photo: z.string(), meters: z.number() }),
  z.object({ from: z.literal('depth') }),
  z.object({ from: z.literal('file'), file: z.string() }),
  z.object({ from: z.literal('assumed') }),
  z.object({ from: z.literal('guessed'), meters: z.number() }),
]);

/** `Axis`. */
const axis = z.enum(['+x', '-x', '+y', '-y', '+z', '-z']);
/** `DepthUnit`. */
const depthUnit = z.union([z.literal('m'), z.literal('mm'), z.literal('reconstruction'), z.number().positive()]);
const depthKind = z.enum(['z', 'ray']);

/** What an import understood: `ImportRecord`. */
const importRecord = z.object({
  format: z.literal('scrim-import-record'),
  version: z.literal(2),
  form: z.string(),
  up: axis,
  metersPerUnit: z.number(),
  scale: scaleSource.nullable(),
  pointCount: z.number(),
  depth: z
    .object({
      unit: depthUnit,
      kind: depthKind,
      count: z.number(),
    })
    .nullable(),
  depthTriangles: z.number(),
  withoutPhotograph: z.array(z.string()).readonly(),
  withoutCamera: z.array(z.string()).readonly(),
  warnings: z.array(z.string()).readonly(),
  views: z
    .array(
      z.object({
        photo: z.string(),
        model: z.string(),
        widthPx: z.number(),
        heightPx: z.number(),
        errorPx: z.number().nullable(),
        points: z.number(),
        places: z.array(z.number()).readonly(),
      }),
    )
    .readonly(),
});

/** A depth map of a few pixels, the same depth of the mesh or the points, and the camera of the pixels; 0: unknown. */
const depthSample = z.object({
  name: z.string(),
  usualUnit: depthUnit,
  pinhole: z.object({
    widthPx: z.number(),
    heightPx: z.number(),
    fxPx: z.number(),
    fyPx: z.number(),
    cxPx: z.number(),
    cyPx: z.number(),
    isAround: z.boolean(),
  }),
  values: z.array(z.number()).readonly(),
  surface: z.object({ kind: z.enum(['mesh', 'points']), values: z.array(z.number()).readonly() }).nullable(),
});

/** Calls that make captures: of photographs that the editor takes of a scene, and of those in a folder. */
export const PHOTOGRAPH_CALLS = {
  /**
   * Begins an acquisition: photographs of the scene, which become the capture `assets/NAME.capture/`. `poses`: column-major 4×4, in the order
   * of the photographs. One at a time per project.
   */
  'capture.begin': {
    input: z.object({
      handle,
      name: z.string().min(1).max(80),
      camera: acquiredCamera,
      poses: z.array(z.array(z.number()).length(16)).min(1).max(1000),
    }),
    output: z.object({}),
  },
  /**
   * Adds a photograph: premultiplied RGBA, and meters as 32-bit floats, little-endian; rows from the top. After an error all photographs are
   * deleted.
   */
  'capture.add': {
    input: z.object({
      handle,
      index: z.number().int().min(0).max(999),
      colorSize: pictureSize,
      rgba: z.instanceof(Uint8Array).refine(isWithinLimit, 'too large'),
      depthSize: pictureSize,
      meters: z.instanceof(Uint8Array).refine((bytes) => isWithinLimit(bytes) && bytes.length % 4 === 0, 'too large, or no 32-bit floats'),
    }),
    output: z.object({}),
  },
  /**
   * Packs the photographs, reporting progress as events. `path` is that of `capture.json`, for the asset table, which the editor keeps; null if
   * the acquisition was canceled.
   */
  'capture.finish': {
    input: z.object({ handle }),
    output: z.object({ path: projectPath.nullable(), diagnostics: z.array(diagnostic) }),
  },
  /** Cancels an acquisition and deletes its photographs. */
  'capture.cancel': { input: z.object({ handle }), output: z.object({}) },
  /**
   * What is known of a capture: what its import understood, its cameras and points of its mesh. `path`: its `capture.json`. SCR032 if a file is
   * damaged.
   */
  'capture.report': {
    input: z.object({ handle, path: projectPath }),
    output: z.object({
      record: importRecord.nullable(),
      /** Cameras and photographs; without files of depth. */
      views: z.array(z.custom<CaptureView>()).readonly(),
      vertexCount: z.number(),
      triangleCount: z.number(),
      sizeM: z.array(z.number()).readonly(),
      surface: z.array(z.number()).readonly(),
    }),
  },
  /**
   * Looks into a folder of photographs. Without cameras, it needs COLMAP: `colmap` has its version and path, or `diagnostic` says why there is
   * none. `colmap` of the input is the path that the user typed; null: that of the setting, or in PATH. SCR004 if there is no such folder.
   */
  'photographs.look': {
    input: z.object({ handle, folder: z.string().min(1).max(4096), colmap: programPath }),
    output: z.object({
      photographs: z.number(),
      hasCameras: z.boolean(),
      colmap: z.string().nullable(),
      diagnostic: diagnostic.nullable(),
    }),
  },
  /**
   * Reads what the import of a folder must decide before. Without cameras, `form`, `up` and `mesh` are null. `isKept`: a JPEG file without
   * distortion, whose pixels stay as they are if it is not reduced. SCR069 if the folder cannot be imported.
   */
  'photographs.survey': {
    input: z.object({ handle, folder: z.string().min(1).max(4096) }),
    output: z.object({
      form: z.string().nullable(),
      up: axis.nullable(),
      mesh: z.object({ vertexCount: z.number(), triangleCount: z.number() }).nullable(),
      warnings: z.array(z.string()),
      photographs: z.array(
        z.object({ widthPx: z.number(), heightPx: z.number(), bytes: z.number(), isKept: z.boolean(), isAround: z.boolean() }),
      ),
      /** Depth files by their form, such as `PNG`; null without them. Without cameras, `pinhole` is not that of the photographs. */
      depth: z.object({ count: z.number(), files: z.string(), hasCameras: z.boolean(), samples: z.array(depthSample) }).nullable(),
    }),
  },
  /**
   * Imports a folder of photographs as the capture `assets/NAME.capture/`; COLMAP finds missing cameras. Reports progress and what COLMAP prints
   * as events, and is canceled by `tool.cancel`; what COLMAP has finished is kept for the next import of the folder. `path` is that of
   * `capture.json`, for the asset table, which the editor keeps; null if the import was canceled. `found`: the photographs that have cameras.
   * `isRough`: the mesh is that of points. `isScaleGuessed`: nothing says how large the place is. `start`: where an eye sees what a photograph shows.
   */
  'photographs.import': {
    input: z.object({
      handle,
      folder: z.string().min(1).max(4096),
      name: z.string().min(1).max(80),
      colmap: programPath,
      /** Whether one camera with one focal length took all. */
      oneCamera: z.boolean(),
      /** Longest side of photographs. */
      maxSidePx: z.number().int().min(64).max(8192),
      /** Null: estimated. */
      up: axis.nullable(),
      /** Null: that of the files, or a guess. */
      metersPerUnit: z.number().positive().nullable(),
      /** As `CaptureJob.depth`. */
      depth: z.object({ from: z.enum(['files', 'mesh', 'none']).nullable(), unit: depthUnit.nullable(), kind: depthKind.nullable() }),
    }),
    output: z.object({
      path: projectPath.nullable(),
      photographs: z.number(),
      found: z.number(),
      isRough: z.boolean(),
      isScaleGuessed: z.boolean(),
      start: z.object({ positionM: z.array(z.number()).length(3), yawRad: z.number() }).nullable(),
      diagnostics: z.array(diagnostic),
    }),
  },
  /**
   * Writes a file of a folder that was dropped, for `photographs.import`, which deletes the files at its end. `folder` is the name of the dropped
   * folder, `path` that of the file inside. The first file removes those of an earlier drop.
   */
  'photographs.stage': {
    input: z.object({
      handle,
      folder: z.string().min(1).max(255),
      path: z.string().min(1).max(512),
      bytes: z.instanceof(Uint8Array).refine(isWithinLimit, 'too large'),
      first: z.boolean(),
    }),
    output: z.object({ folder: z.string() }),
  },
} as const;
