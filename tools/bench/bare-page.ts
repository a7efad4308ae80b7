import { build } from 'esbuild';
import { compileProject } from '../../app/services/compile-project.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import { readAssetFile } from '../../app/services/read-asset.ts';
import { prepareAssets } from '../../export/bundle/assets/prepare-assets.ts';
import { bundleScripts, PAGE_SETTINGS } from '../../export/bundle/bundle-page-script.ts';
import type { PageUse } from '../../export/bundle/page-entry.ts';
import { programUse } from '../../export/bundle/program-use.ts';
import { type Sizes, sizesOf } from '../../export/bundle/report.ts';

/** Bundles the page that does what the first example does in plain three.js, as `export/bundle` bundles pages. */
export async function bundleBarePage(root: string): Promise<Uint8Array> {
  const { outputFiles } = await build({
    ...PAGE_SETTINGS,
    entryPoints: ['tools/bench/pages/bare.page.ts'],
    absWorkingDir: root,
    format: 'iife',
  });
  const [script] = outputFiles;
  if (!script) throw new Error('esbuild made nothing of the bare page.');
  return script.contents;
}

/** `index.html` of the bare page, with its script, the model and the poster beside it. */
export const BARE_HTML = `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>First light</title>
<link rel="icon" href="data:,">
<link rel="preload" href="robot.glb" as="fetch" crossorigin>
<script src="bare.js" defer></script>
<style>
html, body { margin: 0; height: 100%; overflow: hidden; background: #14161a }
canvas { display: block }
.poster { position: fixed; inset: 0; width: 100%; height: 100%; object-fit: cover }
</style>
<body>
<img class="poster" src="poster.jpg" alt="First light" width="1200" height="630">
`;

/** Sizes of the scripts of the first example and of the bare page. */
export interface ScriptWeights {
  /** What is loaded before the first image. */
  readonly first: Sizes;
  /** With the sessions that a visitor may enter. */
  readonly all: Sizes;
  /** All, with what three.js' own bundle contains. */
  readonly wholeThree: Sizes;
  readonly bare: Sizes;
}

export async function weighScripts(root: string, folder: string): Promise<ScriptWeights> {
  const { program, diagnostics } = await compileProject(folder, await readProjectFiles(folder), () => ({ sourceMaps: false, fuse: true }));
  if (program === null) throw new Error(`${folder} does not compile: ${JSON.stringify(diagnostics)}`);
  const options = {
    root,
    readAsset: (path: string) => readAssetFile(folder, path),
    compress: false,
    cache: null,
    streams: true,
    say: () => {},
  };
  const { output } = await prepareAssets(program.assets, options);
  if (output === null) throw new Error(`The assets of ${folder} cannot be read.`);
  const { decoders, models } = output;
  const use: PageUse = { ...programUse(program), decoders, models, credits: true, singleFile: false };
  const [stripped, whole] = [await bundleScripts(root, use), await bundleScripts(root, use, { wholeThree: true })];
  const sizes = ({ page, sessions }: typeof whole): Sizes => add(sizesOf(page.bytes), sizesOf(sessions?.bytes ?? new Uint8Array()));
  return {
    first: sizesOf(stripped.page.bytes),
    all: sizes(stripped),
    wholeThree: sizes(whole),
    bare: sizesOf(await bundleBarePage(root)),
  };
}

function add(a: Sizes, b: Sizes): Sizes {
  return { raw: a.raw + b.raw, gzip: a.gzip + b.gzip };
}
